import { type DoorCut, formatDoors, isDoorSize, parseDoors } from '../../core/doors.ts';
import { doorOutlines, placeDoors } from '../../core/place-doors.ts';
import { sayCoordinates, sayUnit, sourceCoordinates } from '../../core/source-coordinates.ts';
import type { FloorPlan, Gap, Opening, Storey, Vec2 } from '../../core/types.ts';
import { directionOf, lengthOf, middleOf, type Stretch } from '../stretch.ts';

/** Of a door about to be cut, m. */
export interface DoorSize {
  readonly width: number;
  /** Left out where it is the usual one. */
  readonly height?: number | undefined;
}

/** A door of the plan, and the entry of the parameter that it comes from. */
export interface PlanDoor {
  readonly opening: Opening;
  /** Index among the storey's gaps where every gap is a door, else among the doors cut by hand. */
  readonly origin: { readonly kind: 'gap' | 'cut'; readonly index: number };
}

/** A door's place and width are written to the millimetre, and read by people to the centimetre. m */
const WRITTEN = 0.001;
const WRITTEN_DIGITS = 3;
const SAID = 0.01;

/**
 * The doors of the lowest storey, which alone gets any, as the parameter `doors` says them, and what one more or less makes of the parameter. Every
 * door is placed by the core's own rule, so what a person sees before a cut is what the plan gets.
 */
export class PlanDoors {
  /** Those that find a wall. */
  readonly doors: readonly PlanDoor[];
  readonly #plan: FloorPlan;
  readonly #storey: Storey;
  readonly #text: string;

  /** @param text the parameter `doors`; it may be ahead of the plan while a run is under way */
  constructor(plan: FloorPlan, text: string) {
    this.#plan = plan;
    [this.#storey] = plan.storeys;
    this.#text = text;
    const { gaps, cuts } = parseDoors(text);
    const ofGaps = (gaps ? this.gaps : []).map((gap) => this.#place('gaps', [gap]));
    const ofCuts = cuts.map((cut) => this.#place(formatDoors({ gaps: false, cuts: [cut] })));
    this.doors = [...ofOrigin('gap', ofGaps), ...ofOrigin('cut', ofCuts)];
  }

  get gaps(): readonly Gap[] {
    return this.#storey.gaps;
  }

  /** The door at a place, or less than `reach` metres beside it. */
  at(place: Vec2, reach: number): PlanDoor | null {
    return this.doors.find(({ opening }) => this.#isOn(opening, place, reach)) ?? null;
  }

  /** The gap without a door at a place, or less than `reach` metres beside it. */
  gapAt(place: Vec2, reach: number): Gap | null {
    return this.gaps.find((gap) => this.#isOn(gap, place, reach) && !this.inGap(gap)) ?? null;
  }

  inGap(gap: Gap): PlanDoor | null {
    return this.at(middleOf(gap), 0);
  }

  /** The door that would be cut at a place, moved along its wall to where it fits; null off every wall. */
  fit(place: Vec2, size: DoorSize): Opening | null {
    const found = this.#cutAt(place, size);
    if (!found || lengthOf(found) >= size.width - WRITTEN) return found;
    const [ux, uy] = directionOf(found);
    const along = ([x, y]: Vec2) => (x - place[0]) * ux + (y - place[1]) * uy;
    // On one side the wall ends: the door goes there.
    const half = size.width / 2;
    const isAtStart = -along(found.from) < along(found.to);
    const [[x, y], way] = isAtStart ? [found.from, half] : [found.to, -half];
    const moved = this.#cutAt([x + way * ux, y + way * uy], size);
    return moved && lengthOf(moved) > lengthOf(found) ? moved : found;
  }

  /** The door as wide as a gap; null where that is no size for one, or no wall stands along it. */
  fitGap(gap: Gap, height?: number): Opening | null {
    return isDoorSize(gap.width) ? this.#cutAt(middleOf(gap), { width: gap.width, height }) : null;
  }

  /** The parameter with one more door. */
  with(opening: Stretch, height?: number): string {
    const { gaps, cuts } = parseDoors(this.#text);
    return formatDoors({ gaps, cuts: [...cuts, this.#cutOf(opening, height)] });
  }

  /** The parameter without a door. Where every gap was one, the other gaps stay doors, each on its own. */
  without({ origin }: PlanDoor): string {
    const { gaps, cuts } = parseDoors(this.#text);
    if (origin.kind === 'cut') return formatDoors({ gaps, cuts: cuts.filter((_, i) => i !== origin.index) });
    const others = this.doors.filter(
      (door) => door.origin.kind === 'gap' && door.origin.index !== origin.index,
    );
    return formatDoors({
      gaps: false,
      cuts: [...others.map(({ opening }) => this.#cutOf(opening)), ...cuts],
    });
  }

  /** The middle of a stretch as a person finds it in the source: `3.20, 0.00 m`. */
  sayPlace(stretch: Stretch): string {
    const { frame } = this.#plan;
    return `${sayCoordinates(frame, middleOf(stretch), SAID)} ${sayUnit(frame.unit)}`;
  }

  #cutOf(stretch: Stretch, height?: number): DoorCut {
    const source = sourceCoordinates(this.#plan.frame, WRITTEN);
    const [x, y] = middleOf(stretch);
    return doorCut({
      x: Number(source.x(x).toFixed(source.digits)),
      y: Number(source.y(y).toFixed(source.digits)),
      width: Number(lengthOf(stretch).toFixed(WRITTEN_DIGITS)),
      height,
    });
  }

  #cutAt([planX, planY]: Vec2, { width, height }: DoorSize): Opening | null {
    const source = sourceCoordinates(this.#plan.frame);
    const cut = doorCut({ x: source.x(planX), y: source.y(planY), width, height });
    return this.#place(formatDoors({ gaps: false, cuts: [cut] }));
  }

  /** One entry of the parameter as the core places it. */
  #place(doors: string, gaps: readonly Gap[] = []): Opening | null {
    const { frame, options } = this.#plan;
    const { height } = this.#storey;
    const outlines = doorOutlines(this.#storey);
    const site = { outlines, gaps, frame, height, options: { ...options, doors } };
    return placeDoors(site, { warn: ignore })[0] ?? null;
  }

  #isOn(stretch: Stretch, [x, y]: Vec2, reach: number): boolean {
    const [ux, uy] = directionOf(stretch);
    const [dx, dy] = [x - stretch.from[0], y - stretch.from[1]];
    const [along, aside] = [dx * ux + dy * uy, Math.abs(ux * dy - uy * dx)];
    // A gap lies on the outline, a door in the middle of the wall.
    const deep = this.#plan.options.wallThickness;
    return along >= -reach && along <= lengthOf(stretch) + reach && aside <= deep + reach;
  }
}

/** Whether a storey shown is the one that gets doors; a number beyond the last stands for the last. */
export function isLowest({ storeys }: FloorPlan, storey: number): boolean {
  return storey === 0 || storeys.length === 1;
}

function ofOrigin(kind: 'gap' | 'cut', openings: readonly (Opening | null)[]): PlanDoor[] {
  return openings.flatMap((opening, index) => (opening ? [{ opening, origin: { kind, index } }] : []));
}

function doorCut({ height, ...cut }: Pick<DoorCut, 'x' | 'y'> & DoorSize): DoorCut {
  return height === undefined ? cut : { ...cut, height };
}

/** A place off every wall is no warning while a person looks for one. */
function ignore(): void {}
