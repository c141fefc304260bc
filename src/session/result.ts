import type { Options } from '../core/params.ts';
import type { StageReport } from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { StageName } from '../core/stages.ts';
import type { Warning } from '../core/types.ts';

/** Stages that a plan without its scan goes through too. */
type PlanStage = Exclude<StageName, PointStage>;
/** Stages that need the points. */
type PointStage =
  | 'read'
  | 'frame'
  | 'crop'
  | 'outliers'
  | 'level'
  | 'slice'
  | 'boundary'
  | 'regularise'
  | 'secondary'
  | 'rooms';

/**
 * Everything one run of the pipeline made: by the name of its stage what each made, and how the run went. A plan.json opened
 * again has no points, so that the stages before `plan` made nothing; {@link isOfScan} tells.
 */
export interface RunResult extends Pick<StageResults, PlanStage>, Partial<Pick<StageResults, PointStage>> {
  readonly options: Options;
  readonly stages: readonly StageReport[];
  readonly warnings: readonly Warning[];
}

/** A run of a scan: every stage made something. */
export type ScanResult = RunResult & StageResults;

/** Whether a run began with a scan, not with its plan. */
export function isOfScan(result: RunResult): result is ScanResult {
  return result.read !== undefined;
}
