import { findBoundary } from './boundary.ts';
import type { StageContext, StrokeTest } from './context.ts';
import { FloorPlanError } from './errors.ts';
import { orient } from './frame.ts';
import { chooseLevel } from './level.ts';
import { removeOutliers } from './outliers.ts';
import { type Options, PARAM_NAMES, PARAMS } from './params.ts';
import { makePlan } from './plan.ts';
import { regulariseBoundary } from './regularise.ts';
import { findSecondary } from './secondary.ts';
import { makeSlice } from './slice.ts';
import { STAGE_NAMES, STAGES, type StageName } from './stages.ts';
import type {
  Boundary,
  FloorPlan,
  Frame,
  Level,
  PointCloud,
  Polygon,
  RegularisedBoundary,
  Scan,
  SecondaryResult,
  Slice,
  Warning,
} from './types.ts';
import { findWallPoints } from './wall-columns.ts';

/** Where a run stands. */
export interface Progress {
  readonly stage: StageName;
  /** Share of the whole run, 0 to 1, never falling. */
  readonly share: number;
}

/** One stage of a run, for the app's rail and the report. */
export interface StageReport {
  readonly name: StageName;
  readonly ms: number;
  /** Whether the result came from the cache. */
  readonly isCached: boolean;
  /** What came out, in words: "380,344 points", "24 vertices". */
  readonly outcome: string;
}

/** What an environment alone can do, for a whole run. */
export interface PipelineHooks {
  /** Milliseconds from any start. */
  now(): number;
  readonly strokeTest: StrokeTest;
  /** Called between stages: lets an environment see messages. */
  breathe?(): Promise<void>;
}

export interface RunControl {
  onProgress?(progress: Progress): void;
  readonly signal?: AbortSignalLike;
}

/** The part of an AbortSignal that core needs; core knows no DOM. */
export interface AbortSignalLike {
  readonly aborted: boolean;
}

interface CachedStage {
  readonly key: string;
  readonly output: unknown;
  readonly warnings: readonly Warning[];
  readonly outcome: string;
}

/** The last result of every stage, so that a changed parameter runs again from its stage only. */
export class StageCache {
  readonly #stages = new Map<StageName, CachedStage>();

  get(name: StageName, key: string): CachedStage | undefined {
    const cached = this.#stages.get(name);
    return cached?.key === key ? cached : undefined;
  }

  set(name: StageName, cached: CachedStage): void {
    this.#stages.set(name, cached);
  }
}

/** One pass through {@link STAGES} with one set of options. */
export class PipelineRun {
  readonly stages: StageReport[] = [];
  readonly warnings: Warning[] = [];
  readonly #cache: StageCache;
  readonly #hooks: PipelineHooks;
  readonly #control: RunControl;
  #key = '';

  constructor(cache: StageCache, hooks: PipelineHooks, control: RunControl) {
    this.#cache = cache;
    this.#hooks = hooks;
    this.#control = control;
  }

  /**
   * Runs a stage, or takes its result from the cache when neither its parameters nor any stage before it changed.
   *
   * @param outcome what came out, in words, for the rail
   * @throws cancelled, and whatever `work` throws
   */
  async stage<T>(
    name: StageName,
    options: Options,
    work: (context: StageContext) => T | Promise<T>,
    outcome: (output: T) => string,
  ): Promise<T> {
    this.#key = `${this.#key}\n${stageKey(name, options)}`;
    const cached = this.#cache.get(name, this.#key);
    if (cached) {
      this.warnings.push(...cached.warnings);
      this.stages.push({ name, ms: 0, isCached: true, outcome: cached.outcome });
      return cached.output as T;
    }
    await this.#hooks.breathe?.();
    this.throwIfCancelled();
    this.progress(name, 0);
    const warnings: Warning[] = [];
    const start = this.#hooks.now();
    const output = await work({
      warn: (warning) => warnings.push(warning),
      progress: (share) => this.progress(name, share),
      strokeTest: this.#hooks.strokeTest,
    });
    this.throwIfCancelled();
    const ms = this.#hooks.now() - start;
    const words = outcome(output);
    this.#cache.set(name, { key: this.#key, output, warnings, outcome: words });
    this.warnings.push(...warnings);
    this.stages.push({ name, ms, isCached: false, outcome: words });
    this.progress(name, 1);
    return output;
  }

  /** @throws cancelled */
  throwIfCancelled(): void {
    if (this.#control.signal?.aborted) throw new FloorPlanError('cancelled', 'The run was cancelled.');
  }

  progress(name: StageName, share: number): void {
    let before = 0;
    for (const stage of STAGE_NAMES) {
      if (stage === name) break;
      before += STAGES[stage].share;
    }
    this.#control.onProgress?.({ stage: name, share: before + STAGES[name].share * Math.min(1, share) });
  }
}

/** What the stages from `frame` to `plan` make of a scan. */
export interface PlanResult {
  readonly cloud: PointCloud;
  /** Points left out as outliers. */
  readonly outliers: number;
  readonly levels: readonly Level[];
  readonly slice: Slice;
  readonly boundary: Boundary;
  readonly regularised: RegularisedBoundary;
  readonly secondary: SecondaryResult;
  readonly plan: FloorPlan;
}

/**
 * The paper's chain from a scan to its floor plan ([Stojanovic19] §3–3.1), every stage cached.
 *
 * @throws option/…, input/degenerate, input/too-few-points, result/…, cancelled
 */
export async function planScan(scan: Scan, options: Options, run: PipelineRun): Promise<PlanResult> {
  const cloud = await run.stage(
    'frame',
    options,
    (context) => orient(scan, options, context),
    ({ frame }) => `${frame.up} up, ${frame.unit}`,
  );
  const total = cloud.positions.length / 3;
  const kept = await run.stage(
    'outliers',
    options,
    (context) => removeOutliers(cloud, options, context),
    (indices) => `${count(total - indices.length, 'outlier')}`,
  );
  const level = await run.stage(
    'level',
    options,
    (context) => chooseLevel(cloud, kept, options, context),
    ({ band, indices }) =>
      `${count(indices.length, 'point')}, ${band[0].toFixed(2)} to ${band[1].toFixed(2)} m`,
  );
  const slice = await run.stage(
    'slice',
    options,
    (context) => {
      const walls = findWallPoints(cloud, kept, level, options, context);
      return makeSlice(cloud, walls.indices, walls.band, options);
    },
    ({ xy }) => count(xy.length / 2, 'point'),
  );
  const boundary = await run.stage(
    'boundary',
    options,
    (context) =>
      findBoundary(slice, options, { ...context, placeInSource: (x, y) => placeInSource(cloud.frame, x, y) }),
    ({ polygons }) => count(vertexCount(polygons), 'vertex', 'vertices'),
  );
  const regularised = await run.stage(
    'regularise',
    options,
    () => regulariseBoundary(boundary, slice, options),
    ({ polygons }) => count(vertexCount(polygons), 'vertex', 'vertices'),
  );
  const secondary = await run.stage(
    'secondary',
    options,
    (context) => findSecondary(slice, regularised, options, context),
    ({ boundaries }) => count(boundaries.length, 'structure'),
  );
  const plan = await run.stage(
    'plan',
    options,
    (context) => {
      const made: Warning[] = [];
      const warn = (warning: Warning) => {
        made.push(warning);
        context.warn(warning);
      };
      const parts = { source: scan.facts, cloud, kept, boundary, regularised, secondary, options };
      const draft = makePlan(parts, { ...context, warn });
      return { ...draft, warnings: [...run.warnings, ...made] };
    },
    ({ storeys }) => count(storeys.length, 'storey'),
  );
  const { levels } = level;
  return { cloud, outliers: total - kept.length, levels, slice, boundary, regularised, secondary, plan };
}

/** Vertices of all rings. */
export function vertexCount(polygons: readonly Polygon[]): number {
  let vertices = 0;
  for (const { outer, holes } of polygons) {
    vertices += outer.length / 2;
    for (const hole of holes) vertices += hole.length / 2;
  }
  return vertices;
}

/** Seen from above, to about a centimetre: (691823.12, 5336027.50) m. */
function placeInSource({ planOrigin, metresPerUnit, unit }: Frame, x: number, y: number): string {
  const digits = Math.max(0, 2 + Math.ceil(Math.log10(metresPerUnit)));
  const [sourceX, sourceY] = [planOrigin[0] + x / metresPerUnit, planOrigin[1] + y / metresPerUnit];
  return `(${sourceX.toFixed(digits)}, ${sourceY.toFixed(digits)}) ${unit}`;
}

function stageKey(name: StageName, options: Options): string {
  const values = PARAM_NAMES.filter((param) => PARAMS[param].stage === name && param !== 'preset');
  return `${name} ${values.map((param) => String(options[param])).join(' ')}`;
}

function count(n: number, singular: string, plural = `${singular}s`): string {
  return `${n.toLocaleString('en-GB')} ${n === 1 ? singular : plural}`;
}
