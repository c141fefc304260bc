import type { Options } from '../core/params.ts';
import type { StageReport } from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import type { Warning } from '../core/types.ts';

/** Everything one run of the pipeline made: by the name of its stage what each made, and how the run went. */
export interface RunResult extends StageResults {
  readonly options: Options;
  readonly stages: readonly StageReport[];
  readonly warnings: readonly Warning[];
}
