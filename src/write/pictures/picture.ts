import type { Options } from '../../core/params.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { StageName } from '../../core/stages.ts';
import type { Drawing } from './page.ts';

/** What a picture can tell beside the results. */
export interface PictureFacts {
  /** How long the stage took. Left out where equal runs must give equal files. */
  readonly ms?: number;
  /** Round of the paper's search for secondary boundaries, 1 for the first; the last one where absent. */
  readonly round?: number;
  /** Of the run; where absent those of the plan, if there is one. */
  readonly options?: Options;
}

/** A row of PICTURES: how a stage's result is seen. */
export interface PictureRow {
  readonly label: string;
  /** Caption, one sentence. */
  readonly doc: string;
  /** The stage whose result it shows. */
  readonly stage: StageName;
  /** The figure of [Stojanovic19] that it corresponds to, or "ours". */
  readonly figure: string;
  /** Whether a stage that ran left something to show; where absent it always does. Far cheaper than drawing. */
  has?(results: StageResults): boolean;
  /** Rounds of the search that can be shown, by number from 1; where absent there is no choice. */
  rounds?(results: StageResults): number;
  /** @returns null where the stage has not run or there is nothing to show */
  draw(results: Partial<StageResults>, facts: PictureFacts): Drawing | null;
}
