import type { Options } from '../core/params.ts';
import type { StageName } from '../core/stages.ts';
import type {
  Boundary,
  FloorPlan,
  Level,
  PointCloud,
  RegularisedBoundary,
  Scan,
  SecondaryResult,
  Slice,
  Solid,
  Warning,
} from '../core/types.ts';

/** One stage of a run, for the rail and the report. */
export interface StageReport {
  readonly name: StageName;
  readonly ms: number;
  /** Whether the result came from the cache. */
  readonly isCached: boolean;
  /** What came out, in words: "380,344 points", "24 vertices". */
  readonly outcome: string;
}

/** Everything one run of the pipeline made, stage by stage. */
export interface RunResult {
  readonly options: Options;
  readonly scan: Scan;
  readonly cloud: PointCloud;
  readonly outliers: number;
  readonly levels: readonly Level[];
  readonly slice: Slice;
  readonly boundary: Boundary;
  readonly regularised: RegularisedBoundary;
  readonly secondary: SecondaryResult;
  readonly plan: FloorPlan;
  readonly solid: Solid;
  readonly stages: readonly StageReport[];
  readonly warnings: readonly Warning[];
}

/** Where a run stands. */
export interface Progress {
  readonly stage: StageName;
  /** Share of the whole run, 0 to 1, never falling. */
  readonly share: number;
  readonly points?: number;
}
