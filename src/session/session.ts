import { FloorPlanError } from '../core/errors.ts';
import { resolveOptions } from '../core/options.ts';
import type { GivenValues } from '../core/params.ts';
import { planScan } from '../core/pipeline.ts';
import {
  type PipelineHooks,
  PipelineRun,
  type RunControl,
  StageCache,
  type StageReport,
} from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { StageName } from '../core/stages.ts';
import type { FloorPlan, Slice } from '../core/types.ts';
import type { ByteSource } from '../read/bytes/source.ts';
import { readScan } from '../read/read-scan.ts';
import { makeSolid } from '../solid/make-solid.ts';
import type { WriteTools } from '../write/drawing/raster.ts';
import { writeFiles } from '../write/formats.ts';
import { drawPicture, PICTURES, type PictureFacts, type PictureName } from '../write/pictures/pictures.ts';
import type { Product, WrittenFile } from '../write/plan-writer.ts';
import { drawSheets, saySheets } from '../write/sheet/draw-sheet.ts';
import { DEFAULT_HOOKS } from './default-hooks.ts';
import { type OpenedPlan, openPlan, readPlanFile } from './open-plan.ts';
import { isOfScan, type RunResult, type ScanResult } from './result.ts';

export interface SessionControl extends RunControl {
  /** A sample of the points read so far: source units, relative to the first point. */
  onPreview?(positions: Float32Array): void;
  readonly signal?: AbortSignal;
}

/** What an environment alone can do, for runs and for writers. */
export type SessionHooks = PipelineHooks & WriteTools;

interface OpenSource {
  readonly sources: readonly ByteSource[];
  readonly cache: StageCache;
  /** What each stage last took, ms. */
  readonly times: Map<StageName, number>;
  /** What a plan.json holds, null for scans; absent until it was read. */
  plan?: FloorPlan | null;
}

/** The session's last own run, good or failed. */
interface LastRun {
  readonly run: PipelineRun;
  readonly given: GivenValues;
  readonly times: ReadonlyMap<StageName, number>;
}

/** Of a plan whose points are not at hand. */
export const NO_SLICE: Slice = { xy: new Float64Array(0), band: [0, 0], spacing: 0 };

/**
 * One person's work on one scan: reads it, makes its plan, makes it again when a parameter changes, writes files.
 * The same in worker, command and library. A source that fails leaves the one before it open. One run at a time:
 * await, or cancel and await, the last before the next.
 */
export class Session {
  readonly #hooks: SessionHooks;
  #open: OpenSource | null = null;
  #result: RunResult | null = null;
  #last: LastRun | null = null;

  /** @param hooks what the environment does better than its defaults: a clock, a canvas, a pause between stages */
  constructor(hooks: Partial<SessionHooks> = {}) {
    this.#hooks = { ...DEFAULT_HOOKS, ...hooks };
  }

  /** The last good run. */
  get result(): RunResult | null {
    return this.#result;
  }

  /** What the stages of the last run made, as far as it got: a run that failed has those before the failing stage. */
  get evidence(): Partial<StageResults> {
    return this.#last?.run.results ?? {};
  }

  /** The stages of the last run, as far as it got. */
  get reports(): readonly StageReport[] {
    return this.#last?.run.stages ?? [];
  }

  /** What each stage took when it last ran on the scan of the last run, ms. */
  get times(): ReadonlyMap<StageName, number> {
    return this.#last?.times ?? new Map();
  }

  /**
   * Reads a scan, several sources as parts of one, and makes its plan; or reads a plan.json, to be shown and written again.
   *
   * @throws FloorPlanError
   */
  async load(
    source: ByteSource | readonly ByteSource[],
    given: GivenValues = {},
    control: SessionControl = {},
  ): Promise<RunResult> {
    const sources = 'name' in source ? [source] : source;
    const opened: OpenSource = { sources, cache: new StageCache(), times: new Map() };
    const result = await this.#runOwn(opened, given, control);
    this.#open = opened;
    this.#result = result;
    return result;
  }

  /** Makes the plan again, from the first stage whose parameters changed. @throws FloorPlanError */
  async update(given: GivenValues, control: SessionControl = {}): Promise<RunResult> {
    if (!this.#open) throw noScan();
    this.#result = await this.#runOwn(this.#open, given, control);
    return this.#result;
  }

  /**
   * What other options would make of the scan, beside the plan at hand, which stays. Stages before the first that
   * differs are taken from the cache; nothing of the other run is put there. @throws FloorPlanError
   *
   * @param given all options of the other run, as for {@link update}
   */
  async compare(given: GivenValues, control: SessionControl = {}): Promise<ScanResult> {
    if (!this.#open) throw noScan();
    const run = new PipelineRun(this.#open.cache.fork(), this.#hooks, control);
    const result = await this.#run(this.#open, given, run, control);
    if (!isOfScan(result)) throw noPoints();
    return result;
  }

  /** A picture of the last run as SVG, with its stage's time; null where the run did not get so far. */
  picture(name: PictureName, facts: PictureFacts = {}): string | null {
    if (!this.#last) return null;
    const { run, given, times } = this.#last;
    const ms = times.get(PICTURES[name].stage);
    const options = run.results.read && resolveOptions(given, run.results.read);
    return drawPicture(name, run.results, { ...(ms && { ms }), ...(options && { options }), ...facts });
  }

  /** The files of one write format. @throws option/invalid for an unknown format */
  async write(format: string): Promise<readonly WrittenFile[]> {
    if (!this.#result) throw noScan();
    return writeFiles(productOf(this.#result), format, this.#hooks);
  }

  /** A run that leaves its evidence, however far it gets. */
  async #runOwn(opened: OpenSource, given: GivenValues, control: SessionControl): Promise<RunResult> {
    const { cache, times } = opened;
    const run = new PipelineRun(cache, this.#hooks, control);
    this.#last = { run, given, times };
    try {
      return await this.#run(opened, given, run, control);
    } finally {
      for (const { name, ms, isCached } of run.stages) if (!isCached) times.set(name, ms);
    }
  }

  async #run(
    opened: OpenSource,
    given: GivenValues,
    run: PipelineRun,
    control: SessionControl,
  ): Promise<RunResult> {
    opened.plan ??= await readPlanFile(opened.sources);
    const { plan, options, warnings } = opened.plan
      ? await takePlan(opened.plan, given, run)
      : await makePlan(opened.sources, given, run, control);
    await run.stage(
      'solid',
      options,
      ({ warn }) => makeSolid(plan, options, warn),
      ({ indices }) => `${(indices.length / 3).toLocaleString('en-GB')} triangles`,
    );
    await run.stage(
      'sheet',
      options,
      ({ warn }) => {
        const { slice = NO_SLICE } = run.results;
        return drawSheets({ plan, slice, options, name: baseName(plan.source.name) }, warn);
      },
      saySheets,
    );
    // Taken from the cache, it bears the options of when it was made.
    const made = { ...(run.results as RunResult), plan: { ...plan, options } };
    return { ...made, options, stages: run.stages, warnings: [...run.warnings, ...warnings] };
  }
}

/** A plan that was made before enters the chain where it left it. */
async function takePlan(saved: FloorPlan, given: GivenValues, run: PipelineRun): Promise<OpenedPlan> {
  const opened = openPlan(saved, given);
  await run.stage(
    'plan',
    opened.options,
    ({ warn }) => {
      for (const warning of opened.plan.warnings) warn(warning);
      return opened.plan;
    },
    () => 'as it was saved',
  );
  return opened;
}

async function makePlan(
  sources: readonly ByteSource[],
  given: GivenValues,
  run: PipelineRun,
  control: SessionControl,
): Promise<OpenedPlan> {
  const readOptions = resolveOptions(given);
  const scan = await run.stage(
    'read',
    readOptions,
    async (context) => {
      const read = await readScan(sources, readOptions, {
        signal: control.signal,
        onPreview: control.onPreview,
        onProgress: ({ bytesRead, totalBytes }) => context.progress(totalBytes ? bytesRead / totalBytes : 0),
      });
      for (const warning of read.warnings) context.warn(warning);
      return read;
    },
    ({ facts }) =>
      `${facts.pointsKept.toLocaleString('en-GB')} of ${facts.pointsRead.toLocaleString('en-GB')} points`,
  );
  const options = resolveOptions(given, scan);
  return { plan: await planScan(scan, options, run), options, warnings: [] };
}

/** What the writers draw on. */
export function productOf(result: RunResult): Product {
  return { ...result, slice: result.slice ?? NO_SLICE, name: baseName(result.plan.source.name) };
}

/** `scan.ply.gz` → `scan`, `hall.las + 2` → `hall + 2`; a name that is all extension stays. */
export function baseName(fileName: string): string {
  return fileName.replace(/(?<=.)\.[^.]{1,5}?(\.(gz|zip))?(?=( \+ \d+)?$)/i, '');
}

function noScan(): FloorPlanError {
  return new FloorPlanError('input/empty', 'There is no scan yet.', { hint: 'Load a scan first.' });
}

function noPoints(): FloorPlanError {
  return new FloorPlanError('input/empty', 'There is no scan to compare with: a plan was opened.', {
    hint: 'Load the scan itself.',
  });
}
