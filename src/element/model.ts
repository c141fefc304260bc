import type { GivenValues, Options, ParamName } from '../core/params.ts';
import type { Progress } from '../core/pipeline-run.ts';
import type { Warning } from '../core/types.ts';
import type { DisplayUnit } from '../view/measure.ts';
import type { PlanView } from '../worker/protocol.ts';
import type { Layout, PlanState } from './contract.ts';

/** Everything the element's panels show; they draw it and hold nothing of their own. */
export interface Model {
  readonly state: PlanState;
  readonly view: PlanView | null;
  /** What a person set. */
  readonly given: GivenValues;
  /** What holds now: the preset's values, then theirs. */
  readonly options: Options;
  /** Name of the scan shown or being read. */
  readonly name: string;
  readonly progress: Progress | null;
  /** Start of the run under way, ms of performance.now. */
  readonly startedAt: number;
  /** Points seen while reading. */
  readonly pointsSeen: number;
  readonly error: Error | null;
  /** What the environment lacks, beside the warnings of the plan. */
  readonly notices: readonly Warning[];
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  readonly unit: DisplayUnit;
  readonly layout: Layout;
  readonly storey: number;
}

/** What a person can do. */
export interface Actions {
  open(file: File): void;
  cancel(): void;
  /** @param isFinal false while a slider is on its way */
  change(change: GivenValues, isFinal: boolean): void;
  /** Back to the preset's value. */
  reset(names: readonly ParamName[]): void;
  undo(): void;
  redo(): void;
  save(format: string): void;
  dismiss(): void;
  setUnit(unit: DisplayUnit): void;
  setLayout(layout: Layout): void;
  setStorey(storey: number): void;
}

/** A piece of the element. */
export interface Panel {
  readonly node: HTMLElement;
  show(model: Model): void;
}
