import type { SheetTool } from '../view/sheet.ts';
import type { SheetMark } from '../view/sheet-marks.ts';
import type { Model } from './model.ts';

/** A tool for the drawing, with its bar. Whoever makes it is told when its marks change. */
export interface PlanTool extends SheetTool {
  readonly bar: { readonly node: HTMLElement };
  /** What it marks in the drawing; nothing while it is not in hand. */
  readonly marks: readonly SheetMark[];
  show(model: Model): void;
}
