import { FloorPlanError } from '../core/errors.ts';
import { parseParam, resolveOptions } from '../core/options.ts';
import type { Options, ParamName } from '../core/params.ts';
import type { Progress } from '../core/pipeline.ts';
import type { FloorPlan, Warning } from '../core/types.ts';
import type { DisplayUnit } from '../view/measure.ts';
import { PlanClient } from '../worker/client.ts';
import type { PlanView } from '../worker/protocol.ts';
import {
  ATTRIBUTES,
  type FloorPlanEventMap,
  LAYOUTS,
  type Layout,
  PARAM_ATTRIBUTES,
  type PlanState,
} from './contract.ts';
import { bundleFiles, saveFile } from './files.ts';
import { GivenOptions } from './given-options.ts';
import type { Actions, Model } from './model.ts';
import { Shell } from './shell.ts';
import { adoptStyles } from './styles.ts';

/** Under Node there is no DOM: the class can be imported, not used. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** A moved slider makes the plan again when it has rested this long, ms. */
const REST = 140;

interface Source {
  readonly data: Blob | string;
  readonly name: string;
}

/**
 * `<floor-plan>`: drop a scan, hold its plan. All work is done in a worker; nothing leaves the browser.
 * What it offers is in contract.ts; `define.ts` registers it.
 */
export class FloorPlanElement extends Base {
  static readonly observedAttributes = [...Object.keys(ATTRIBUTES), ...PARAM_ATTRIBUTES.keys()];

  #shell: Shell | null = null;
  #client: PlanClient | null = null;
  /** The scan shown, and whether the client of now has read it. */
  #source: Source | null = null;
  #isHeld = false;
  /** The scan being read. */
  #next: Source | null = null;
  #view: PlanView | null = null;
  readonly #given = new GivenOptions();
  #state: PlanState = 'empty';
  #error: Error | null = null;
  #progress: Progress | null = null;
  #pointsSeen = 0;
  #startedAt = 0;
  #runs = 0;
  #storey = 0;
  #notices: Warning[] = [];
  #rest = 0;
  #frame = 0;

  connectedCallback(): void {
    for (const name of ['file', 'options'] as const) this.#upgrade(name);
    if (!this.shadowRoot) this.#build();
    this.#shell!.connect();
    this.addEventListener('keydown', this.#key);
    this.#render();
    if (this.#next) this.#restart();
    else if (!this.#source) this.#loadSrc();
  }

  disconnectedCallback(): void {
    this.removeEventListener('keydown', this.#key);
    clearTimeout(this.#rest);
    cancelAnimationFrame(this.#frame);
    this.#client?.dispose();
    this.#client = null;
    this.#isHeld = false;
    this.#shell?.disconnect();
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (before === now) return;
    const param = PARAM_ATTRIBUTES.get(name);
    if (param) this.#takeParam(param, now);
    else if (name === 'src' && this.isConnected && this.#shell) this.#loadSrc();
    this.#invalidate();
  }

  /** The scan shown, where it is a file. Setting it loads it. */
  get file(): Blob | null {
    const data = (this.#next ?? this.#source)?.data;
    return data instanceof Blob ? data : null;
  }

  set file(file: Blob | null) {
    if (file) this.load(file).catch(ignore);
  }

  /** Parameters given so far. @throws option/unknown, option/invalid when set to what {@link Options} does not allow */
  get options(): Partial<Options> {
    return { ...this.#given.now };
  }

  set options(options: Partial<Options>) {
    resolveOptions(options);
    this.#given.replace(options);
    this.#scheduleRun(0);
  }

  get plan(): FloorPlan | null {
    return this.#view?.plan ?? null;
  }

  get state(): PlanState {
    return this.#state;
  }

  get error(): Error | null {
    return this.#error;
  }

  /** Reads a scan and shows its plan; the plan before stays until then. @throws FloorPlanError, `cancelled` among them */
  async load(source: Blob | URL | string): Promise<FloorPlan> {
    const next = sourceOf(source);
    this.#next = next;
    this.#pointsSeen = 0;
    const view = await this.#run((client) => client.load(next.data, next.name, this.#given.now));
    this.#emit('load', view.plan);
    return view.plan;
  }

  /** Stops the run; the last plan stays. */
  cancel(): void {
    clearTimeout(this.#rest);
    this.#client?.cancel();
  }

  /** The bytes of one format; several files come as a ZIP. @throws FloorPlanError */
  async export(format: string): Promise<Blob> {
    const files = await this.#files(format);
    return files.length === 1 ? files[0].blob : (await bundleFiles(files, format)).blob;
  }

  /** Shows everything in both views. */
  fit(): void {
    this.#shell?.fit();
  }

  #build(): void {
    const root = this.attachShadow({ mode: 'open' });
    adoptStyles(root);
    this.#shell = new Shell(this, this.#actions());
    root.append(this.#shell.node);
  }

  #actions(): Actions {
    return {
      open: (file) => void this.load(file).catch(ignore),
      cancel: () => this.cancel(),
      change: (change, isFinal) => {
        this.#given.change(change, isFinal);
        this.#scheduleRun(isFinal ? 0 : REST);
      },
      reset: (names) => {
        this.#given.reset(names);
        this.#scheduleRun(0);
      },
      undo: () => this.#undo(),
      redo: () => this.#redo(),
      save: (format) => void this.#save(format),
      dismiss: () => this.#settle(null),
      setUnit: (unit) => this.setAttribute('display-units', unit),
      setLayout: (layout) => this.setAttribute('view', layout),
      setStorey: (storey) => {
        this.#storey = storey;
        this.#invalidate();
      },
    };
  }

  /** Runs the client and shows what it made. Only the latest run reaches the page. */
  async #run(start: (client: PlanClient) => Promise<PlanView>): Promise<PlanView> {
    const run = ++this.#runs;
    clearTimeout(this.#rest);
    this.#state = 'loading';
    this.#error = null;
    this.#progress = null;
    this.#startedAt = performance.now();
    this.#invalidate();
    try {
      const view = await start(this.#openClient());
      if (run !== this.#runs) throw overtaken();
      this.#take(view);
      return view;
    } catch (error) {
      if (run === this.#runs) this.#fail(error as Error);
      throw error;
    }
  }

  #take(view: PlanView): void {
    if (this.#next) {
      this.#source = this.#next;
      this.#next = null;
      this.#storey = 0;
    }
    this.#isHeld = true;
    this.#view = view;
    this.#settle(null);
    this.#emit('plan-change', view.plan);
  }

  #fail(error: Error): void {
    this.#next = null;
    if (error instanceof FloorPlanError && error.code === 'cancelled') {
      this.#settle(null);
      return;
    }
    this.#settle(error);
    this.#emit('error', error);
  }

  /** Something beside a run failed; a run under way goes on. */
  #complain(error: Error): void {
    if (error instanceof FloorPlanError && error.code === 'cancelled') return;
    this.#error = error;
    if (this.#state !== 'loading') this.#state = 'failed';
    this.#invalidate();
    this.#emit('error', error);
  }

  /** The run has ended, or its error was read. */
  #settle(error: Error | null): void {
    this.#error = error;
    if (error) this.#state = 'failed';
    else this.#state = this.#view ? 'ready' : 'empty';
    this.#invalidate();
  }

  #openClient(): PlanClient {
    this.#client ??= new PlanClient({
      onProgress: (progress) => {
        this.#progress = progress;
        this.#emit('progress', progress);
        this.#invalidate();
      },
      onPreview: (positions) => {
        this.#pointsSeen = positions.length / 3;
        this.#shell?.preview(positions);
      },
      onWarning: (warning) => {
        this.#notices = [...this.#notices, warning];
        this.#invalidate();
      },
    });
    return this.#client;
  }

  #undo(): void {
    this.#given.undo();
    this.#scheduleRun(0);
  }

  #redo(): void {
    this.#given.redo();
    this.#scheduleRun(0);
  }

  #takeParam(param: ParamName, text: string | null): void {
    try {
      this.#given.begin(param, text === null ? {} : parseParam(param, text));
      this.#scheduleRun(0);
    } catch (error) {
      this.#complain(error as Error);
    }
  }

  /** In a task of its own at the earliest: several attributes set in one go make one run. */
  #scheduleRun(delay: number): void {
    this.#invalidate();
    clearTimeout(this.#rest);
    if (this.#next || this.#source) this.#rest = window.setTimeout(() => this.#restart(), delay);
  }

  /** Makes the plan again with the parameters of now: of the scan being read, else of the one shown. */
  #restart(): void {
    if (!this.isConnected || !this.#shell) return;
    const source = this.#next ?? (this.#isHeld ? null : this.#source);
    if (source) {
      this.#next = source;
      this.#run((client) => client.load(source.data, source.name, this.#given.now)).then(
        ({ plan }) => this.#emit('load', plan),
        ignore,
      );
    } else if (this.#source) {
      this.#run((client) => client.update(this.#given.now)).catch(ignore);
    }
  }

  #loadSrc(): void {
    const src = this.getAttribute('src');
    if (src) this.load(src).catch(ignore);
  }

  async #files(format: string): Promise<readonly { readonly name: string; readonly blob: Blob }[]> {
    if (!this.#source) {
      throw new FloorPlanError('input/empty', 'There is no plan to export yet.', {
        hint: 'Load a scan first.',
      });
    }
    if (!this.#isHeld) {
      const { data, name } = this.#source;
      await this.#run((client) => client.load(data, name, this.#given.now));
    }
    return this.#openClient().export(format);
  }

  async #save(format: string): Promise<void> {
    try {
      const files = await this.#files(format);
      saveFile(files.length === 1 ? files[0] : await bundleFiles(files, format));
    } catch (error) {
      this.#complain(error as Error);
    }
  }

  #emit<Type extends keyof FloorPlanEventMap>(type: Type, detail: FloorPlanEventMap[Type]['detail']): void {
    this.dispatchEvent(new CustomEvent(type, { detail }));
  }

  /** Draws once before the next frame, however much has changed. */
  #invalidate(): void {
    if (!this.isConnected || !this.#shell || this.#frame !== 0) return;
    this.#frame = requestAnimationFrame(() => this.#render());
  }

  #render(): void {
    this.#frame = 0;
    this.#shell?.show(this.#model());
  }

  #model(): Model {
    const unit: DisplayUnit = this.getAttribute('display-units') === 'ft' ? 'ft' : 'm';
    const layout = this.getAttribute('view') as Layout;
    const preset = this.#given.now.preset ?? 'auto';
    const isSlice = preset === 'auto' && this.#view?.options.preset === 'paper';
    return {
      state: this.#state,
      view: this.#view,
      given: this.#given.now,
      options: resolveOptions(this.#given.now, { isSlice }),
      name: (this.#next ?? this.#source)?.name ?? '',
      progress: this.#progress,
      startedAt: this.#startedAt,
      pointsSeen: this.#pointsSeen,
      error: this.#error,
      notices: this.#notices,
      canUndo: this.#given.canUndo,
      canRedo: this.#given.canRedo,
      unit,
      layout: LAYOUTS.includes(layout) ? layout : 'split',
      storey: this.#storey,
    };
  }

  readonly #key = (event: KeyboardEvent): void => {
    const isCommand = (event.ctrlKey || event.metaKey) && event.key.toLowerCase() === 'z';
    const [target] = event.composedPath();
    // In a field the browser's own undo comes first.
    const isTyping = target instanceof HTMLInputElement && target.type === 'number';
    if (!isCommand || isTyping) return;
    event.preventDefault();
    if (event.shiftKey) this.#redo();
    else this.#undo();
  };

  /** A property set before the class was registered shadows the accessor; set it again through it. */
  #upgrade(name: 'file' | 'options'): void {
    if (!Object.hasOwn(this, name)) return;
    const value = this[name];
    delete (this as Record<string, unknown>)[name];
    Object.assign(this, { [name]: value });
  }
}

function sourceOf(source: Blob | URL | string): Source {
  if (source instanceof File) return { data: source, name: source.name };
  if (source instanceof Blob) return { data: source, name: 'scan' };
  const { href, pathname } = new URL(source, document.baseURI);
  return { data: href, name: decodeURIComponent(pathname.split('/').pop() ?? '') || 'scan' };
}

function overtaken(): FloorPlanError {
  return new FloorPlanError('cancelled', 'A newer request overtook this one.');
}

/** The error has been shown and sent as an event; nobody awaits this promise. */
function ignore(): void {}
