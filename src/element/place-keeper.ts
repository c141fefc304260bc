import { formatCrop, parseCrop } from '../core/crop-box.ts';
import { formatDoors, isDoorSize, parseDoors } from '../core/doors.ts';
import { statedUnit } from '../core/frame/judge-unit.ts';
import { resolveOptions } from '../core/options.ts';
import { type GivenValues, kebabCase } from '../core/params.ts';
import { formatRoomNames, parseRoomNames } from '../core/room-names.ts';
import type { Axis, Frame, Warning } from '../core/types.ts';
import type { PLACED } from './given-options.ts';

/** A door's size is written to the millimetre. */
const SIZE_DIGITS = 3;

/** What a run tells of the scan. */
export interface FrameFound {
  readonly frame: Pick<Frame, 'up' | 'metresPerUnit'>;
  /** Lies in the plan frame, whatever is up: a ready slice, a plan without its scan. */
  readonly isFixed: boolean;
  readonly storeys: number;
}

/**
 * Keeps crop box, doors and names of rooms at their places in the building when a person changes what is up or how long a
 * unit is.
 *
 * They are said in the plan's axes and the source's units. Another unit leaves them there, only the doors' sizes, which
 * are metres, grow with the plan. A scan turned over has the same plan mirrored, its highest storey the lowest, and they are
 * mirrored with it. Seen along another axis it is another drawing, where they have no place: they are dropped, with a notice.
 */
export class PlaceKeeper {
  #autoUp: Axis | null = null;
  #autoScale: number | null = null;
  #isFixed = false;
  #storeys = 1;
  #notices: readonly Warning[] = [];

  /** What the last change has dropped. */
  get notices(): readonly Warning[] {
    return this.#notices;
  }

  /** Takes what a run found where it had to. @param given what the run was started with */
  learn({ frame, isFixed, storeys }: FrameFound, given: GivenValues): void {
    this.#isFixed = isFixed;
    this.#storeys = storeys;
    if (isAuto(given.up)) this.#autoUp = frame.up;
    if (isAuto(given.unit) && isAuto(given.metresPerUnit)) this.#autoScale = frame.metresPerUnit;
  }

  /** Another scan has other axes and another unit. */
  forget(): void {
    this.#autoUp = null;
    this.#autoScale = null;
    this.#isFixed = false;
    this.#notices = [];
  }

  /** The notices have been read. */
  dismiss(): void {
    this.#notices = [];
  }

  /** `next` with the places of `before` where they are in its plan. What `next` says of places anew is left alone. */
  carry(before: GivenValues, next: GivenValues): GivenValues {
    this.#notices = [];
    const ups = [this.#upOf(before), this.#upOf(next)] as const;
    const growth = this.#scaleOf(next) / this.#scaleOf(before);
    const carried = { ...next };
    const isOld = (name: Placed) => next[name] !== undefined && next[name] === before[name];
    if (isOld('crop')) carried.crop = this.#carryCrop(next.crop!, ups);
    if (isOld('doors')) carried.doors = this.#carryDoors(next.doors!, ups, growth);
    if (isOld('roomNames')) carried.roomNames = this.#carryNames(next.roomNames!, ups);
    return carried;
  }

  #carryCrop(text: string, ups: Ups): string {
    const box = parseCrop(text);
    const turn = turnBetween(ups);
    if (!box || turn === 'none') return text;
    if (turn === 'other') return this.#drop('crop', ups);
    const { x0, x1, heights, heading } = box;
    const [y0, y1] = mirrored(box.y0, box.y1);
    return formatCrop({ x0, y0, x1, y1, heights: heights && mirrored(...heights), heading: 0 - heading });
  }

  #carryDoors(text: string, ups: Ups, growth: number): string {
    const { gaps, cuts } = parseDoors(text);
    const turn = turnBetween(ups);
    if (cuts.length === 0 || (turn === 'none' && growth === 1)) return text;
    if (turn === 'other') {
      this.#drop('doors', ups);
      return formatDoors({ gaps, cuts: [] });
    }
    const carried = cuts.map(({ x, y, width, height }) => ({
      x,
      y: turn === 'over' ? 0 - y : y,
      width: grown(width, growth),
      ...(height !== undefined && { height: grown(height, growth) }),
    }));
    return formatDoors({ gaps, cuts: carried });
  }

  #carryNames(text: string, ups: Ups): string {
    const names = parseRoomNames(text);
    const turn = turnBetween(ups);
    if (names.length === 0 || turn === 'none') return text;
    if (turn === 'other') return this.#drop('roomNames', ups);
    const highest = this.#storeys - 1;
    return formatRoomNames(
      names.map(({ x, y, storey, name }) => ({
        ...{ x, y: 0 - y, name },
        // A storey that is not there stays so.
        storey: storey > highest ? storey : highest - storey,
      })),
    );
  }

  #drop(name: Placed, [before, next]: Ups): 'none' {
    const found = next === null ? 'another axis may be' : `${next} is`;
    this.#notices = [
      ...this.#notices,
      {
        code: `frame/${kebabCase(name)}-dropped`,
        message: `${DROPPED[name]} taken away: placed in the plan with ${before} up, and now ${found}.`,
        hint: 'Undo brings back the plan before with all that was in it.',
      },
    ];
    return 'none';
  }

  /** Null where it is not known before the run; what is fixed always has z up. */
  #upOf({ up }: GivenValues): Axis | null {
    if (this.#isFixed) return 'z';
    return up === undefined || up === 'auto' ? this.#autoUp : up;
  }

  /** NaN where it is not known before the run. */
  #scaleOf(given: GivenValues): number {
    return statedUnit({}, resolveOptions(given))?.metresPerUnit ?? this.#autoScale ?? Number.NaN;
  }
}

type Placed = (typeof PLACED)[number];

const DROPPED: Readonly<Record<Placed, string>> = {
  crop: 'The crop box was',
  doors: 'The doors cut by hand were',
  roomNames: 'The names of rooms were',
};

type Ups = readonly [before: Axis | null, next: Axis | null];

function isAuto(value: unknown): boolean {
  return value === undefined || value === 'auto';
}

function turnBetween([before, next]: Ups): 'none' | 'over' | 'other' {
  // Before the first plan nothing was placed in one.
  if (before === next || before === null) return 'none';
  return before.at(-1) === next?.at(-1) ? 'over' : 'other';
}

/** A range seen from its other side. Taken from 0, so that no zero is negative. */
function mirrored(low: number, high: number): readonly [low: number, high: number] {
  return [0 - high, 0 - low];
}

/** A size that would be no door's stays: it was meant as it was said. */
function grown(size: number, growth: number): number {
  const metres = Number((size * growth).toFixed(SIZE_DIGITS));
  return isDoorSize(metres) ? metres : size;
}
