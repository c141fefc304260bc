import type { GivenValues, Options, ParamName } from '../core/params.ts';
import type { Progress } from '../core/pipeline-run.ts';
import type { Warning } from '../core/types.ts';
import type {
  Comparison,
  ComparisonRequest,
  PictureAsked,
  PictureFacts,
  PictureOf,
  PlanView,
} from '../worker/protocol.ts';
import type { DisplayUnit } from '../write/sheet/measure-words.ts';
import type { Layout, PlanState } from './contract.ts';
import type { FailedRun } from './plan-maker.ts';
import type { Stretch } from './stretch.ts';

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
  /** The last run, if it failed after some stages. */
  readonly failed: FailedRun | null;
  /** What the environment lacks, and what the last change dropped, beside the warnings of the plan. */
  readonly notices: readonly Warning[];
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  readonly unit: DisplayUnit;
  readonly layout: Layout;
  readonly storey: number;
  readonly files: FilesShown;
  readonly steps: StepsShown;
  /** What the pointer does in the drawing, beside moving it. */
  readonly tool: Tool | null;
  /** A stretch of wall pointed out in the drawing. */
  readonly marked: Stretch | null;
}

/** Cuts doors, names rooms, measures a known length, draws the crop box. */
export type Tool = 'doors' | 'names' | 'measure' | 'crop';

/** Files opened together. */
export interface FilesShown {
  readonly names: readonly string[];
  /** Index of the one that is the scan; null where all of them are. */
  readonly picked: number | null;
}

/** The pictures of the steps, and the one in place of the drawing. */
export interface StepsShown {
  readonly of: PictureOf;
  readonly pictures: readonly PictureFacts[];
  /** Null while the drawing is shown. */
  readonly picture: PictureFacts | null;
}

/** What a person can do. */
export interface Actions {
  /** Opens files, several as one scan. */
  open(files: readonly File[]): void;
  /** One of the files opened together, or all as one scan. */
  pickFile(index: number | null): void;
  cancel(): void;
  /** @param isFinal false while a slider is on its way */
  change(change: GivenValues, isFinal: boolean): void;
  /** Every parameter of the plan to the preset's value; what was said of the scan itself stays. */
  setPreset(preset: Options['preset']): void;
  /** Back to the preset's value. */
  reset(names: readonly ParamName[]): void;
  undo(): void;
  redo(): void;
  save(format: string): void;
  dismiss(): void;
  setUnit(unit: DisplayUnit): void;
  setLayout(layout: Layout): void;
  setStorey(storey: number): void;
  /** Shows a step's picture in place of the drawing; null shows the drawing again. */
  showStep(name: string | null): void;
  /** To the step after, or the one before. */
  moveStep(by: 1 | -1): void;
  /** To the pictures of the plan, or to the last one of the run that failed. */
  turnSteps(of: PictureOf): void;
  /** @throws FloorPlanError */
  picture(asked: PictureAsked): Promise<string | null>;
  /** What changed options make of the scan, beside its plan, which stays. @throws FloorPlanError */
  compare(request: ComparisonRequest, onProgress: (progress: Progress) => void): Promise<Comparison>;
  stopComparing(): void;
  /** Gives the pointer in the drawing a tool; null takes it back. */
  takeTool(tool: Tool | null): void;
  /** Points out a stretch of wall in the drawing; null takes that back. */
  mark(stretch: Stretch | null): void;
}

/** A piece of the element. */
export interface Panel {
  readonly node: HTMLElement;
  show(model: Model): void;
}
