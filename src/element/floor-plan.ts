import { parseParam, resolveOptions } from '../core/options.ts';
import type { GivenValues, ParamName } from '../core/params.ts';
import type { FloorPlan } from '../core/types.ts';
import type { ScanFile } from '../worker/protocol.ts';
import type { Spawn } from '../worker/spawn.ts';
import { ATTRIBUTES, LAYOUTS, type Layout, PARAM_ATTRIBUTES, type PlanState } from './contract.ts';
import { bundleFiles, saveFile } from './files.ts';
import { GivenOptions } from './given-options.ts';
import type { Actions, Model } from './model.ts';
import { OpenedFiles } from './opened-files.ts';
import { PlaceKeeper } from './place-keeper.ts';
import { PlanMaker } from './plan-maker.ts';
import { fileOf, type ScanSource, scanKey } from './scan-source.ts';
import { SheetChoice } from './sheet-choice.ts';
import { Shell } from './shell.ts';
import { pressKey } from './shortcuts.ts';
import { adoptStyles } from './styles.ts';

export type { ScanSource } from './scan-source.ts';

/** Under Node there is no DOM: the class can be imported, not used. */
const Base = globalThis.HTMLElement ?? (class {} as typeof HTMLElement);

/** A moved slider makes the plan again when it has rested this long, ms. */
const REST = 140;

/**
 * `<floor-plan>`: drop a scan, hold its plan. All work is done in a worker; nothing leaves the browser.
 * What it offers is in contract.ts; `define.ts` registers it.
 */
export class FloorPlanElement extends Base {
  static readonly observedAttributes = [...Object.keys(ATTRIBUTES), ...PARAM_ATTRIBUTES.keys()];

  readonly #places = new PlaceKeeper();
  readonly #given = new GivenOptions((before, next) => this.#places.carry(before, next));
  readonly #maker = new PlanMaker({
    onChange: () => this.#invalidate(),
    onScan: () => {
      this.#given.enter(scanKey(this.#maker.scan!));
      this.#sheet.showStorey(0);
      this.#places.forget();
    },
    onView: ({ plan, options, isSlice, isSavedPlan }) => {
      const isFixed = isSlice || isSavedPlan;
      this.#places.learn({ frame: plan.frame, isFixed, storeys: plan.storeys.length }, options);
    },
    onPreview: (positions) => this.#shell?.preview(positions),
    spawnWorker: () => this.#spawnWorker,
    emit: (type, detail) => this.dispatchEvent(new CustomEvent(type, { detail })),
  });
  readonly #sheet = new SheetChoice(this.#maker, {
    onChange: () => this.#invalidate(),
    // Where the model alone is shown, the 2D view needs a place.
    onShow: () => this.getAttribute('view') === '3d' && this.setAttribute('view', 'split'),
  });
  readonly #actions = this.#makeActions();
  #shell: Shell | null = null;
  #spawnWorker: Spawn | null = null;
  readonly #files = new OpenedFiles();
  #rest = 0;
  #frame = 0;

  connectedCallback(): void {
    for (const name of ['spawnWorker', 'file', 'options', 'step'] as const) upgrade(this, name);
    if (!this.shadowRoot) this.#build();
    this.#shell!.connect();
    this.addEventListener('keydown', this.#key);
    this.#render();
    if (this.#maker.isReading) this.#restart();
    else if (!this.#maker.scan) this.#loadSrc();
  }

  disconnectedCallback(): void {
    this.removeEventListener('keydown', this.#key);
    clearTimeout(this.#rest);
    cancelAnimationFrame(this.#frame);
    this.#maker.cancel();
    this.#shell?.disconnect();
  }

  attributeChangedCallback(name: string, before: string | null, now: string | null): void {
    if (before === now) return;
    const param = PARAM_ATTRIBUTES.get(name);
    if (param) this.#takeParam(param, now);
    else if (name === 'src' && this.isConnected && this.#shell) this.#loadSrc();
    this.#invalidate();
  }

  /** The scan being read, else the one shown, where it is a file; of several the first. Setting it loads it. */
  get file(): Blob | null {
    const data = this.#maker.scan?.[0].data;
    return data instanceof Blob ? data : null;
  }

  set file(file: Blob | null) {
    if (file) this.load(file).catch(ignore);
  }

  /** Parameters given so far. @throws option/unknown, option/invalid when set to what {@link Options} does not allow */
  get options(): GivenValues {
    return { ...this.#given.now };
  }

  set options(options: GivenValues) {
    resolveOptions(options);
    this.#given.replace(options);
    this.#scheduleRun(0);
  }

  /** Makes the worker, for pages whose policy refuses a blob; from `grundriss/worker`. Null: the one inside. */
  get spawnWorker(): Spawn | null {
    return this.#spawnWorker;
  }

  set spawnWorker(spawn: Spawn | null) {
    this.#spawnWorker = spawn;
  }

  /** Name of the step whose picture stands in place of the drawing, e.g. `hull`; null while the drawing is shown. */
  get step(): string | null {
    return this.#sheet.step;
  }

  set step(name: string | null) {
    this.#sheet.showStep(name);
  }

  get plan(): FloorPlan | null {
    return this.#maker.view?.plan ?? null;
  }

  get state(): PlanState {
    return this.#maker.state;
  }

  get error(): Error | null {
    return this.#maker.error;
  }

  /**
   * Reads a scan and shows its plan; the plan before stays until then. Several sources are parts of one scan; in the bar
   * a person can pick one alone. @throws FloorPlanError, `cancelled` among them
   */
  async load(source: ScanSource | readonly ScanSource[]): Promise<FloorPlan> {
    clearTimeout(this.#rest);
    const sources = Array.isArray(source) ? (source as readonly ScanSource[]) : [source as ScanSource];
    this.#files.take(this.#filesOf(sources));
    return this.#read();
  }

  /** Stops the run; the last plan stays. */
  cancel(): void {
    clearTimeout(this.#rest);
    this.#maker.cancel();
  }

  /** The bytes of one format; several files come as a ZIP. @throws FloorPlanError */
  async export(format: string): Promise<Blob> {
    return (await bundleFiles(await this.#maker.files(format), format)).blob;
  }

  /** Shows everything in both views. */
  fit(): void {
    this.#shell?.fit();
  }

  #build(): void {
    const root = this.attachShadow({ mode: 'open' });
    adoptStyles(root);
    this.#shell = new Shell(this, this.#actions);
    root.append(this.#shell.node);
  }

  #makeActions(): Actions {
    return {
      open: (files) => void this.load(files).catch(ignore),
      pickFile: (index) => {
        this.#files.pick(index);
        this.#read().catch(ignore);
      },
      cancel: () => this.cancel(),
      change: (change, isFinal) => {
        this.#given.change(change, isFinal);
        this.#scheduleRun(isFinal ? 0 : REST);
      },
      setPreset: (preset) => {
        this.#given.takePreset(preset);
        this.#scheduleRun(0);
      },
      reset: (names) => {
        this.#given.reset(names);
        this.#scheduleRun(0);
      },
      undo: () => this.#leaf('undo'),
      redo: () => this.#leaf('redo'),
      save: (format) => void this.#save(format),
      dismiss: () => this.#maker.dismiss(),
      setUnit: (unit) => this.setAttribute('display-units', unit),
      setLayout: (layout) => {
        if (layout === '3d') this.#sheet.takeTool(null);
        this.setAttribute('view', layout);
      },
      setStorey: (storey) => this.#sheet.showStorey(storey),
      showStep: (name) => this.#sheet.showStep(name),
      moveStep: (by) => this.#sheet.moveStep(by),
      turnSteps: (of) => {
        this.#sheet.turnSteps(of);
        // What was pressed is gone.
        this.#shell?.focusStep();
      },
      picture: (asked) => this.#maker.picture(asked),
      compare: ({ options, labels }, onProgress) =>
        this.#maker.compare({ options: { ...this.#given.now, ...options }, labels }, onProgress),
      stopComparing: () => this.#maker.stopComparing(),
      takeTool: (tool) => this.#sheet.takeTool(tool),
      mark: (stretch) => this.#sheet.mark(stretch),
    };
  }

  #leaf(way: 'undo' | 'redo'): void {
    this.#given[way]();
    this.#places.dismiss();
    this.#scheduleRun(0);
  }

  #takeParam(param: ParamName, text: string | null): void {
    try {
      const value = text === null ? {} : parseParam(param, text);
      // A quantity in pixels is judged beside the pixels' size.
      resolveOptions({ ...this.#given.now, ...value });
      this.#given.begin(param, value);
      this.#scheduleRun(0);
    } catch (error) {
      this.#maker.complain(error as Error);
    }
  }

  /** In a task of its own at the earliest: several attributes set in one go make one run. */
  #scheduleRun(delay: number): void {
    this.#invalidate();
    clearTimeout(this.#rest);
    if (this.#maker.scan) this.#rest = window.setTimeout(() => this.#restart(), delay);
  }

  #restart(): void {
    const { scan } = this.#maker;
    if (this.isConnected && this.#shell && scan)
      this.#maker.update(this.#given.of(scanKey(scan))).catch(ignore);
  }

  #read(): Promise<FloorPlan> {
    const { chosen } = this.#files;
    return this.#maker.load(chosen, this.#given.of(scanKey(chosen)));
  }

  /** A wrong address never gets to a run, so it is told of here. */
  #filesOf(given: readonly ScanSource[]): readonly ScanFile[] {
    try {
      return given.map(fileOf);
    } catch (error) {
      this.#maker.complain(error as Error);
      throw error;
    }
  }

  #loadSrc(): void {
    const src = this.getAttribute('src');
    if (src) this.load(src).catch(ignore);
  }

  async #save(format: string): Promise<void> {
    try {
      saveFile(await bundleFiles(await this.#maker.files(format), format));
    } catch (error) {
      this.#maker.complain(error as Error);
    }
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
    const layout = this.getAttribute('view') as Layout;
    const preset = this.#given.now.preset ?? 'auto';
    const { view } = this.#maker;
    const isSlice = preset === 'auto' && view?.options.preset === 'paper';
    // What a saved plan was made with holds where nothing else is said.
    const told = view?.isSavedPlan ? { ...view.options, ...this.#given.now } : this.#given.now;
    const options = resolveOptions(told, { isSlice });
    return {
      ...this.#maker.facts,
      notices: [...this.#places.notices, ...this.#maker.facts.notices],
      given: this.#given.now,
      options,
      canUndo: this.#given.canUndo,
      canRedo: this.#given.canRedo,
      unit: options.displayUnits,
      layout: LAYOUTS.includes(layout) ? layout : 'split',
      files: this.#files.shown,
      ...this.#sheet.shown,
    };
  }

  readonly #key = (event: KeyboardEvent): void => {
    const { tool, steps } = this.#sheet.shown;
    const situation = { tool, isStepping: steps.picture !== null, hasTools: this.hasAttribute('controls') };
    pressKey(event, situation, this.#actions);
  };
}

/** A property set before the class was registered shadows the accessor; set it again through it. */
function upgrade(element: FloorPlanElement, name: 'spawnWorker' | 'file' | 'options' | 'step'): void {
  if (!Object.hasOwn(element, name)) return;
  const value = element[name];
  delete (element as Partial<FloorPlanElement>)[name];
  Object.assign(element, { [name]: value });
}

/** The error has been shown and sent as an event; nobody awaits this promise. */
function ignore(): void {}
