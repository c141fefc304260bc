import type { Options } from '../core/params.ts';
import type { PlanResult, StageReport } from '../core/pipeline.ts';
import type { Scan, Solid, Warning } from '../core/types.ts';

/** Everything one run of the pipeline made, stage by stage. */
export interface RunResult extends PlanResult {
  readonly options: Options;
  readonly scan: Scan;
  readonly solid: Solid;
  readonly stages: readonly StageReport[];
  readonly warnings: readonly Warning[];
}

export type { Progress, StageReport } from '../core/pipeline.ts';
