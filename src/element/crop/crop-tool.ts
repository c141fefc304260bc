import { type CropBox, formatCrop, parseCrop } from '../../core/crop-box.ts';
import { sayUnit } from '../../core/source-coordinates.ts';
import { formatLength } from '../../view/measure.ts';
import type { SheetCursor, SheetDrag, SheetPlace } from '../../view/sheet.ts';
import type { SheetMark } from '../../view/sheet-marks.ts';
import type { Actions, Model } from '../model.ts';
import type { PlanTool } from '../plan-tool.ts';
import { CropBar } from './crop-bar.ts';
import { boxBetween, dragged, type Grip, gripAt, HANDLES, handleAt } from './grip.ts';
import {
  cornersOf,
  cropOf,
  headingOf,
  inTurnedAxes,
  type TurnedBox,
  turnedBox,
  wholeOf,
} from './turned-box.ts';

/** A handle is taken from this many times the reach of a hand. */
const TAKE = 2;

/**
 * Draws the box around what the plan is made from, along the sheet, which the plan may be turned on. It is applied when
 * the hand lets go.
 */
export class CropTool implements PlanTool {
  readonly bar: CropBar;
  readonly #actions: Actions;
  readonly #redraw: () => void;
  #model: Model | null = null;
  /** As it is dragged, plan metres. */
  #drawn: TurnedBox | null = null;
  #grip: Grip | null = null;

  constructor(actions: Actions, redraw: () => void) {
    this.#actions = actions;
    this.#redraw = redraw;
    this.bar = new CropBar({
      onChange: (box) => actions.change({ crop: formatCrop(box) }, true),
      onRemove: () => actions.change({ crop: 'none' }, true),
      onLeave: () => actions.takeTool(null),
    });
  }

  show(model: Model): void {
    const before = this.#model;
    this.#model = model;
    this.bar.node.hidden = model.tool !== 'crop';
    const isSame =
      before?.view === model.view &&
      before?.tool === model.tool &&
      before?.unit === model.unit &&
      before?.options.crop === model.options.crop;
    if (!isSame) this.#tell();
  }

  get cursor(): SheetCursor {
    if (this.#grip === 'all') return 'move';
    return this.#grip && inTurnedAxes(this.#grip, -(this.#box?.heading ?? 0));
  }

  hover(place: SheetPlace | null): void {
    const box = this.#box;
    this.#grip = place && box && gripAt(box, inTurnedAxes(place.at, box.heading), TAKE * place.reach);
  }

  /** All is done by dragging. */
  press(): void {}

  grab({ at: pressed, reach, turn }: SheetPlace): SheetDrag | null {
    const before = this.#box;
    const heading = before?.heading ?? headingOf(turn);
    const at = inTurnedAxes(pressed, heading);
    const grip = before && gripAt(before, at, TAKE * reach);
    if (before && !grip) return null;
    const follow = (place: SheetPlace) => {
      const to = inTurnedAxes(place.at, heading);
      const box = before && grip ? dragged(before, grip, [to[0] - at[0], to[1] - at[1]]) : boxBetween(at, to);
      this.#drawn = { ...box, heading };
      this.#tell();
    };
    const end = (isDone: boolean) => {
      const box = this.#drawn;
      this.#drawn = null;
      const isSeen = box && box.high[0] - box.low[0] > reach && box.high[1] - box.low[1] > reach;
      if (isDone && isSeen) this.#actions.change({ crop: formatCrop(this.#cropOf(box)) }, true);
      else this.#tell();
    };
    return { move: follow, drop: () => end(true), cancel: () => end(false) };
  }

  get marks(): readonly SheetMark[] {
    const box = this.#model?.tool === 'crop' ? this.#box : null;
    if (!box) return [];
    const handles = HANDLES.map((handle) => inTurnedAxes(handleAt(box, handle), -box.heading));
    return [{ kind: 'box', corners: cornersOf(box), handles }];
  }

  get #box(): TurnedBox | null {
    if (this.#drawn) return this.#drawn;
    const frame = this.#model?.view?.plan.frame;
    const crop = this.#crop;
    return frame && crop ? turnedBox(frame, crop) : null;
  }

  /** As it is set, source units and coordinates. */
  get #crop(): CropBox | null {
    return this.#model ? parseCrop(this.#model.options.crop) : null;
  }

  /** Source units and coordinates; heights stay as they are. */
  #cropOf(box: TurnedBox): CropBox {
    return { ...cropOf(this.#model!.view!.plan.frame, box), heights: this.#crop?.heights ?? null };
  }

  /** The bar and the marks, after something has changed. */
  #tell(): void {
    const { view, unit = 'm' } = this.#model ?? {};
    this.#redraw();
    if (!view) return;
    const box = this.#box;
    this.bar.show({
      box: this.#drawn ? this.#cropOf(this.#drawn) : this.#crop,
      whole: wholeOf(view.plan.frame, view.surroundings),
      hasHeights: view.surroundings.min[2] < view.surroundings.max[2],
      unit: sayUnit(view.plan.frame.unit),
    });
    if (!box) this.bar.say('Drag a box around what the plan is to be made from.');
    else {
      const sides = [box.high[0] - box.low[0], box.high[1] - box.low[1]];
      this.bar.say(sides.map((side) => formatLength(side, unit)).join(' × '));
    }
  }
}
