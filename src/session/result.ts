import type { Options } from '../core/params.ts';
import type { PlanResult } from '../core/pipeline.ts';
import type { StageReport } from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { Scan, Solid, Warning } from '../core/types.ts';

/** Everything one run of the pipeline made, stage by stage. */
export interface RunResult extends PlanResult {
  readonly options: Options;
  readonly scan: Scan;
  readonly solid: Solid;
  /** The same by stage, with what the later stages have no use for. */
  readonly results: StageResults;
  readonly stages: readonly StageReport[];
  readonly warnings: readonly Warning[];
}
