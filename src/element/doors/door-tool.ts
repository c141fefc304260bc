import type { Gap } from '../../core/types.ts';
import { formatLength } from '../../view/measure.ts';
import type { SheetPlace } from '../../view/sheet.ts';
import type { StretchMark } from '../../view/sheet-marks.ts';
import type { Actions, Model } from '../model.ts';
import type { PlanTool } from '../plan-tool.ts';
import { lengthOf, type Stretch } from '../stretch.ts';
import { DoorBar } from './door-bar.ts';
import { isLowest, type PlanDoor, PlanDoors } from './plan-doors.ts';

/** What a press at some place does. */
interface Aim {
  readonly kind: 'cut' | 'remove';
  readonly stretch: Stretch;
  readonly words: string;
  /** The parameter `doors` after it. */
  readonly doors: string;
}

const WALLS = 'Press a wall to cut a door, a door to take it away.';
const ABOVE = 'Doors are cut in the lowest storey.';
const WALLS_AND_GAPS = 'Press a wall or a dashed gap to cut a door, a door to take it away.';

/** Cuts doors in the drawing ([Stojanovic19] §3): a wall or a bridged gap gets one, a door goes. */
export class DoorTool implements PlanTool {
  readonly bar: DoorBar;
  readonly #actions: Actions;
  readonly #redraw: () => void;
  #model: Model | null = null;
  #doors: PlanDoors | null = null;
  #aim: Aim | null = null;

  constructor(actions: Actions, redraw: () => void) {
    this.#actions = actions;
    this.#redraw = redraw;
    this.bar = new DoorBar(() => actions.takeTool(null));
  }

  show(model: Model): void {
    const { view, options, storey, unit, tool, marked } = model;
    const isCutting = tool === 'doors';
    const before = this.#model;
    this.#model = model;
    this.bar.setUnit(unit);
    this.bar.node.hidden = !isCutting;
    const isSame =
      before?.view === view &&
      before?.options.doors === options.doors &&
      before.storey === storey &&
      (before.tool === 'doors') === isCutting &&
      before.marked === marked;
    if (isSame) return;
    this.#doors = view && isLowest(view.plan, storey) ? new PlanDoors(view.plan, options.doors) : null;
    this.hover(null);
  }

  hover(place: SheetPlace | null): void {
    this.#aim = place && this.#aimAt(place);
    this.bar.say(this.#aim?.words ?? this.#resting);
    this.#redraw();
  }

  press(place: SheetPlace): void {
    const aim = this.#aimAt(place);
    if (aim) this.#actions.change({ doors: aim.doors }, true);
    else this.bar.say(this.#doors ? 'No wall here long enough for a door.' : this.#resting);
  }

  get #resting(): string {
    if (!this.#doors) return ABOVE;
    return this.#freeGaps().length > 0 ? WALLS_AND_GAPS : WALLS;
  }

  #aimAt({ at, reach }: SheetPlace): Aim | null {
    const doors = this.#doors;
    if (!doors) return null;
    const door = doors.at(at, reach);
    if (door) return this.#aimAtDoor(door);
    const { size } = this.bar;
    const gap = doors.gapAt(at, reach);
    const opening = gap ? doors.fitGap(gap, size.height) : doors.fit(at, size);
    if (!opening) return null;
    const width = this.#say(lengthOf(opening));
    const words = gap ? `Make a door of this gap, ${width} wide.` : `Cut a door here, ${width} wide.`;
    return { kind: 'cut', stretch: opening, words, doors: doors.with(gap ?? opening, size.height) };
  }

  #aimAtDoor(door: PlanDoor): Aim {
    const { opening } = door;
    const words = `Take this door away, ${this.#say(lengthOf(opening))} wide.`;
    return { kind: 'remove', stretch: opening, words, doors: this.#doors!.without(door) };
  }

  get marks(): readonly StretchMark[] {
    const { tool = null, marked = null, view } = this.#model ?? {};
    const thickness = view?.plan.options.wallThickness ?? 0;
    const mark = (kind: StretchMark['kind'], { from, to }: Stretch) => ({ kind, from, to, thickness });
    const free = tool === 'doors' ? this.#freeGaps() : [];
    return [
      ...free.map((gap) => mark('candidate', this.#doors?.fitGap(gap) ?? gap)),
      ...(this.#aim ? [mark(this.#aim.kind, this.#aim.stretch)] : []),
      ...(marked ? [mark('cut', marked)] : []),
    ];
  }

  #freeGaps(): readonly Gap[] {
    return this.#doors?.gaps.filter((gap) => !this.#doors?.inGap(gap)) ?? [];
  }

  #say(metres: number): string {
    return formatLength(metres, this.#model?.unit ?? 'm');
  }
}
