import { type CropBox, formatCrop, parseCrop } from '../../core/crop-box.ts';
import {
  planPlace,
  type SourceCoordinates,
  sayUnit,
  sourceCoordinates,
} from '../../core/source-coordinates.ts';
import { formatLength } from '../../view/measure.ts';
import type { SheetCursor, SheetDrag, SheetPlace } from '../../view/sheet.ts';
import type { SheetMark } from '../../view/sheet-marks.ts';
import type { PlanView } from '../../worker/protocol.ts';
import type { Actions, Model } from '../model.ts';
import type { PlanTool } from '../plan-tool.ts';
import { CropBar } from './crop-bar.ts';
import { type Box, boxBetween, dragged, type Grip, gripAt, HANDLES, handleAt } from './grip.ts';

/** A handle is taken from this many times the reach of a hand. */
const TAKE = 2;
/** A box is drawn to this, m: nobody sees a centimetre on a sheet … */
const DRAWN = 0.01;
/** … but in that of a small thing; a share of the box's shorter side. */
const FINE = 0.01;

/** Draws the box around what the plan is made from. It is applied when the hand lets go. */
export class CropTool implements PlanTool {
  readonly bar: CropBar;
  readonly #actions: Actions;
  readonly #redraw: () => void;
  #model: Model | null = null;
  /** As it is dragged, plan metres. */
  #drawn: Box | null = null;
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
    return this.#grip === 'all' ? 'move' : this.#grip;
  }

  hover(place: SheetPlace | null): void {
    const box = this.#box;
    this.#grip = place && box && gripAt(box, place.at, TAKE * place.reach);
  }

  /** All is done by dragging. */
  press(): void {}

  grab({ at, reach }: SheetPlace): SheetDrag | null {
    const before = this.#box;
    const grip = before && gripAt(before, at, TAKE * reach);
    if (before && !grip) return null;
    const follow = ({ at: to }: SheetPlace) => {
      this.#drawn =
        before && grip ? dragged(before, grip, [to[0] - at[0], to[1] - at[1]]) : boxBetween(at, to);
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
    return [{ kind: 'box', ...box, handles: HANDLES.map((handle) => handleAt(box, handle)) }];
  }

  /** Plan metres. */
  get #box(): Box | null {
    if (this.#drawn) return this.#drawn;
    const frame = this.#model?.view?.plan.frame;
    const crop = this.#crop;
    if (!frame || !crop) return null;
    return { low: planPlace(frame, crop.x0, crop.y0), high: planPlace(frame, crop.x1, crop.y1) };
  }

  /** As it is set, source units and coordinates. */
  get #crop(): CropBox | null {
    return this.#model ? parseCrop(this.#model.options.crop) : null;
  }

  /** Source units and coordinates; heights stay as they are. */
  #cropOf({ low, high }: Box): CropBox {
    const side = Math.min(high[0] - low[0], high[1] - low[1]);
    const to = sourceCoordinates(this.#model!.view!.plan.frame, Math.min(DRAWN, FINE * side));
    const [[x0, y0], [x1, y1]] = [low, high].map(([x, y]) => [round(to.x(x), to), round(to.y(y), to)]);
    return { x0, y0, x1, y1, heights: this.#crop?.heights ?? null };
  }

  /** The bar and the marks, after something has changed. */
  #tell(): void {
    const { view, unit = 'm' } = this.#model ?? {};
    this.#redraw();
    if (!view) return;
    const box = this.#box;
    this.bar.show({
      box: this.#drawn ? this.#cropOf(this.#drawn) : this.#crop,
      whole: wholeOf(view),
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

/** Where the whole cloud lies, source units and coordinates, rounded outwards. */
function wholeOf({ plan, surroundings }: PlanView) {
  const to = sourceCoordinates(plan.frame, DRAWN);
  const { min, max } = surroundings;
  const { planOrigin, metresPerUnit } = plan.frame;
  const z = (height: number) => planOrigin[2] + height / metresPerUnit;
  const step = 10 ** -to.digits;
  const below = (value: number) => round(Math.floor(value / step) * step, to);
  const above = (value: number) => round(Math.ceil(value / step) * step, to);
  return {
    x0: below(to.x(min[0])),
    y0: below(to.y(min[1])),
    z0: below(z(min[2])),
    x1: above(to.x(max[0])),
    y1: above(to.y(max[1])),
    z1: above(z(max[2])),
  };
}

/** Adding 0 makes a negative zero a zero. */
function round(value: number, { digits }: SourceCoordinates): number {
  return Number(value.toFixed(digits)) + 0;
}
