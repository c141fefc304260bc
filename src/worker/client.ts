import { FloorPlanError, fromPlainError } from '../core/errors.ts';
import type { GivenValues } from '../core/params.ts';
import type { Progress } from '../core/pipeline-run.ts';
import type { Warning } from '../core/types.ts';
import type {
  Comparison,
  ComparisonRequest,
  Evidence,
  ExportedFile,
  PictureAsked,
  PlanView,
  Request,
  Response,
  ScanFile,
} from './protocol.ts';
import { type Line, openMainThread, openWorker, type Spawn, type Start, spawnOrder } from './spawn.ts';

export interface ClientEvents {
  onProgress?(progress: Progress): void;
  /** A sample of the points read so far: source units, relative to the first point. */
  onPreview?(positions: Float32Array): void;
  /** A load or an update failed after some stages. */
  onEvidence?(evidence: Evidence): void;
  /** How the page itself makes the worker; asked when the first one is needed. */
  spawnWorker?(): Spawn | null;
  /** The environment gave less than hoped for, e.g. no worker. */
  onWarning?(warning: Warning): void;
}

type Answer = PlanView | readonly ExportedFile[] | Comparison | string | null;

interface Pending {
  readonly request: Request;
  resolve(answer: Answer): void;
  reject(error: unknown): void;
  readonly onProgress: ((progress: Progress) => void) | undefined;
}

interface Loaded {
  readonly files: readonly ScanFile[];
  options: GivenValues;
}

type RequestBody = Request extends infer R ? (R extends Request ? Omit<R, 'id'> : never) : never;

const NO_WORKER: Warning = {
  code: 'environment/worker',
  message: 'No worker could be started, so the plan is made on the page itself, which may stall.',
  hint: "Allow worker-src blob: in the page's content security policy, or give the element a worker.",
};

/**
 * The pipeline off the main thread. The latest load or update wins; an overtaken one rejects with `cancelled`.
 * Cancelling ends the worker, which frees its memory at once; a worker may also die. Either way the last good scan is
 * read again when it is next needed, in a worker of its own.
 */
export class PlanClient {
  readonly #events: ClientEvents;
  /** The ways to a worker that are left; null before the first is tried. */
  #starts: Start[] | null = null;
  readonly #pending = new Map<number, Pending>();
  #line: Line | null = null;
  #isReady = false;
  #lastId = 0;
  /** What the page shows. */
  #loaded: Loaded | null = null;
  /** Whether the worker holds the scan that the page shows. */
  #holdsLoaded = false;

  constructor(events: ClientEvents = {}) {
    this.#events = events;
  }

  /** Reads the files of a scan and makes its plan; a URL is taken relative to the page. @throws FloorPlanError */
  async load(given: readonly ScanFile[], options: GivenValues = {}): Promise<PlanView> {
    if (this.#isRunning) this.cancel();
    const loading = { files: given.map(absolute), options };
    const view = await this.#ask<PlanView>({ kind: 'load', ...loading }, this.#events.onProgress);
    this.#loaded = loading;
    this.#holdsLoaded = true;
    return view;
  }

  /** Makes the plan again with other options, from the first stage they touch. @throws FloorPlanError */
  async update(options: GivenValues): Promise<PlanView> {
    if (!this.#loaded)
      throw new FloorPlanError('input/empty', 'There is no scan yet.', { hint: 'Load one first.' });
    this.#overtake();
    const view = this.#holdsLoaded
      ? await this.#ask<PlanView>({ kind: 'update', options }, this.#events.onProgress)
      : await this.load(this.#loaded.files, options);
    this.#loaded.options = options;
    return view;
  }

  /** Files of one write format, several for a building of several storeys. @throws FloorPlanError */
  async export(format: string): Promise<readonly ExportedFile[]> {
    await this.#hold();
    return this.#ask<readonly ExportedFile[]>({ kind: 'export', format });
  }

  /** A stage's picture as SVG text, or null where that run has none. @throws FloorPlanError */
  async picture(asked: PictureAsked): Promise<string | null> {
    await this.#hold();
    return this.#ask<string | null>({ kind: 'picture', ...asked });
  }

  /**
   * Puts what other options make of the scan beside its plan, which stays as it is. A newer comparison overtakes.
   *
   * @throws FloorPlanError, `cancelled` among them
   */
  async compare(request: ComparisonRequest, onProgress?: (progress: Progress) => void): Promise<Comparison> {
    this.stopComparing();
    await this.#hold();
    return this.#ask<Comparison>({ kind: 'compare', ...request }, onProgress);
  }

  /** Ends the comparison under way, which rejects with `cancelled`; nothing else is touched. */
  stopComparing(): void {
    for (const [id, { request, reject }] of this.#pending) {
      if (request.kind !== 'compare') continue;
      this.#pending.delete(id);
      if (this.#isReady) this.#line?.send({ kind: 'stop', id });
      reject(new FloorPlanError('cancelled', 'The comparison was stopped.'));
    }
  }

  /** Stops at once; pending calls reject with `cancelled`; the last plan can still be updated and exported. */
  cancel(): void {
    this.#close();
    this.#rejectAll(new FloorPlanError('cancelled', 'The run was cancelled.'));
  }

  get #isRunning(): boolean {
    return [...this.#pending.values()].some(({ request: { kind } }) => kind === 'load' || kind === 'update');
  }

  /** Reads the scan shown again where the worker that held it has ended. */
  async #hold(): Promise<void> {
    if (!this.#loaded || this.#holdsLoaded || this.#isRunning) return;
    await this.load(this.#loaded.files, this.#loaded.options);
  }

  #ask<Given extends Answer>(body: RequestBody, onProgress?: Pending['onProgress']): Promise<Given> {
    const request: Request = { ...body, id: ++this.#lastId };
    return new Promise((resolve, reject) => {
      this.#pending.set(request.id, { request, resolve: resolve as Pending['resolve'], reject, onProgress });
      if (!this.#line) this.#open();
      else if (this.#isReady) this.#line.send(request);
    });
  }

  /** Rejects the updates under way: a newer one makes their results stale. */
  #overtake(): void {
    for (const [id, { request, reject }] of this.#pending) {
      if (request.kind !== 'update') continue;
      this.#pending.delete(id);
      reject(new FloorPlanError('cancelled', 'A newer request overtook this one.'));
    }
  }

  #open(): void {
    const events = { onResponse: (r: Response) => this.#receive(r), onBroken: () => this.#broke() };
    this.#isReady = false;
    this.#starts ??= spawnOrder(this.#events.spawnWorker?.());
    const [start] = this.#starts;
    this.#line = start ? openWorker(start, events) : openMainThread(events);
  }

  /** A line that never got ready is replaced by the next way to a worker, if any is left; one that did has died. */
  #broke(): void {
    const wasReady = this.#isReady;
    this.#close();
    if (wasReady) {
      const hint = 'The scan may need more memory than the browser gives; lower the point budget.';
      this.#rejectAll(new FloorPlanError('environment/worker', 'The worker stopped unexpectedly.', { hint }));
      return;
    }
    if (!this.#starts?.shift()) {
      const message = 'The part of the program that makes plans could not be fetched.';
      const hint = 'Reload the page to try again.';
      this.#rejectAll(new FloorPlanError('environment/network', message, { hint }));
      return;
    }
    if (this.#starts.length === 0) this.#events.onWarning?.(NO_WORKER);
    this.#open();
  }

  #close(): void {
    this.#line?.close();
    this.#line = null;
    this.#isReady = false;
    this.#holdsLoaded = false;
  }

  #rejectAll(error: FloorPlanError): void {
    const waiting = [...this.#pending.values()];
    this.#pending.clear();
    for (const { reject } of waiting) reject(error);
  }

  #receive(response: Response): void {
    if (response.kind === 'ready') {
      this.#isReady = true;
      for (const { request } of this.#pending.values()) this.#line?.send(request);
      return;
    }
    const pending = this.#pending.get(response.id);
    if (!pending) return;
    switch (response.kind) {
      case 'progress':
        pending.onProgress?.(response.progress);
        return;
      case 'preview':
        this.#events.onPreview?.(response.positions);
        return;
      case 'error':
        if (response.evidence) this.#events.onEvidence?.(response.evidence);
        pending.reject(fromPlainError(response.error));
        break;
      case 'view':
        pending.resolve(response.view);
        break;
      case 'files':
        pending.resolve(response.files);
        break;
      case 'picture':
        pending.resolve(response.svg);
        break;
      case 'comparison':
        pending.resolve(response.comparison);
    }
    this.#pending.delete(response.id);
  }
}

function absolute({ data, name }: ScanFile): ScanFile {
  return { data: typeof data === 'string' ? new URL(data, globalThis.document?.baseURI).href : data, name };
}
