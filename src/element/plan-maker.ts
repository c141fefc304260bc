import { FloorPlanError } from '../core/errors.ts';
import type { GivenValues } from '../core/params.ts';
import type { Progress } from '../core/pipeline-run.ts';
import type { FloorPlan, Warning } from '../core/types.ts';
import { scanName } from '../read/scan-name.ts';
import { PlanClient } from '../worker/client.ts';
import type {
  Comparison,
  ComparisonRequest,
  Evidence,
  ExportedFile,
  PictureAsked,
  PlanView,
  ScanFile,
} from '../worker/protocol.ts';
import type { Spawn } from '../worker/spawn.ts';
import type { FloorPlanEventMap, PlanState } from './contract.ts';

/** A run that failed after some stages, and what they made. */
export interface FailedRun extends Evidence {
  readonly error: Error;
}

export interface MakerEvents {
  /** Something that is shown has changed. */
  onChange(): void;
  /** Another scan is shown. */
  onScan(): void;
  /** A run has made what is shown next. */
  onView(view: PlanView): void;
  /** How a page makes the worker; asked when the first one is needed. */
  spawnWorker(): Spawn | null;
  /** A sample of the points read so far: source units, relative to the first point. */
  onPreview(positions: Float32Array): void;
  emit<Type extends keyof FloorPlanEventMap>(type: Type, detail: FloorPlanEventMap[Type]['detail']): void;
}

/**
 * The plan shown, the scan it is of, and the run that makes the next one. Only the latest run reaches the page; a run
 * that fails or is cancelled leaves the plan before.
 */
export class PlanMaker {
  readonly #events: MakerEvents;
  readonly #client: PlanClient;
  /** The scan shown. */
  #source: readonly ScanFile[] | null = null;
  /** The scan being read. */
  #next: readonly ScanFile[] | null = null;
  #view: PlanView | null = null;
  #error: Error | null = null;
  #failed: FailedRun | null = null;
  /** Came with the answer to the run under way, just before its error. */
  #evidence: Evidence | null = null;
  #notices: readonly Warning[] = [];
  #isRunning = false;
  #runs = 0;
  #progress: Progress | null = null;
  #pointsSeen = 0;
  #startedAt = 0;

  constructor(events: MakerEvents) {
    this.#events = events;
    this.#client = new PlanClient({
      spawnWorker: () => events.spawnWorker(),
      onProgress: (progress) => {
        this.#progress = progress;
        events.emit('progress', progress);
        events.onChange();
      },
      onPreview: (positions) => {
        this.#pointsSeen = positions.length / 3;
        events.onPreview(positions);
      },
      onEvidence: (evidence) => {
        this.#evidence = evidence;
      },
      onWarning: (warning) => {
        this.#notices = [...this.#notices, warning];
        events.onChange();
      },
    });
  }

  get state(): PlanState {
    if (this.#isRunning) return 'loading';
    if (this.#error) return 'failed';
    return this.#view ? 'ready' : 'empty';
  }

  get view(): PlanView | null {
    return this.#view;
  }

  get error(): Error | null {
    return this.#error;
  }

  /** The last run, if it failed after some stages. */
  get failed(): FailedRun | null {
    return this.#failed;
  }

  /** The scan being read, else the one shown. */
  get scan(): readonly ScanFile[] | null {
    return this.#next ?? this.#source;
  }

  get isReading(): boolean {
    return this.#next !== null;
  }

  /** What the panels show of the run and the plan. */
  get facts() {
    return {
      state: this.state,
      view: this.#view,
      error: this.#error,
      failed: this.#failed,
      notices: this.#notices,
      name: this.scan ? scanName(this.scan) : '',
      progress: this.#progress,
      pointsSeen: this.#pointsSeen,
      startedAt: this.#startedAt,
    };
  }

  /** Reads the files of a scan and makes its plan. @throws FloorPlanError, `cancelled` among them */
  async load(files: readonly ScanFile[], options: GivenValues): Promise<FloorPlan> {
    this.#next = files;
    this.#pointsSeen = 0;
    const { plan } = await this.#run(() => this.#client.load(files, options));
    this.#events.emit('load', plan);
    return plan;
  }

  /** Makes the plan again with other parameters: of the scan being read, else of the one shown. @throws FloorPlanError */
  async update(options: GivenValues): Promise<void> {
    if (this.#next) await this.load(this.#next, options);
    else if (this.#source) await this.#run(() => this.#client.update(options));
  }

  /** Stops the run and ends the worker; the last plan stays, and can be changed and exported. */
  cancel(): void {
    this.#client.cancel();
  }

  /** @throws FloorPlanError */
  async files(format: string): Promise<readonly ExportedFile[]> {
    if (this.#source) return this.#client.export(format);
    throw new FloorPlanError('input/empty', 'There is no plan to export yet.', {
      hint: 'Load a scan first.',
    });
  }

  /** A stage's picture as SVG text; null where that run has none. @throws FloorPlanError */
  picture(asked: PictureAsked): Promise<string | null> {
    return this.#client.picture(asked);
  }

  /** What other parameters make of the scan shown, beside its plan, which stays. @throws FloorPlanError */
  compare(request: ComparisonRequest, onProgress: (progress: Progress) => void): Promise<Comparison> {
    return this.#client.compare(request, onProgress);
  }

  stopComparing(): void {
    this.#client.stopComparing();
  }

  /** Tells of something beside a run that failed; a run under way goes on. */
  complain(error: Error): void {
    if (isCancelled(error)) return;
    this.#tell(error);
  }

  /** The error was read. */
  dismiss(): void {
    this.#error = null;
    this.#events.onChange();
  }

  async #run(start: () => Promise<PlanView>): Promise<PlanView> {
    const run = ++this.#runs;
    this.#isRunning = true;
    this.#error = null;
    this.#evidence = null;
    this.#progress = null;
    this.#startedAt = performance.now();
    this.#events.onChange();
    try {
      const view = await start();
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
      this.#events.onScan();
    }
    this.#events.onView(view);
    this.#view = view;
    this.#isRunning = false;
    this.#error = null;
    this.#failed = null;
    this.#progress = null;
    this.#events.onChange();
    this.#events.emit('plan-change', view.plan);
  }

  #fail(error: Error): void {
    this.#next = null;
    this.#isRunning = false;
    if (isCancelled(error)) this.dismiss();
    else {
      this.#failed = this.#evidence && { ...this.#evidence, error };
      this.#tell(error);
    }
  }

  #tell(error: Error): void {
    this.#error = error;
    this.#events.onChange();
    this.#events.emit('error', error);
  }
}

function isCancelled(error: Error): boolean {
  return error instanceof FloorPlanError && error.code === 'cancelled';
}

function overtaken(): FloorPlanError {
  return new FloorPlanError('cancelled', 'A newer request overtook this one.');
}
