import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import { turnBetween } from './column-directions.ts';

/** Columns this far off a growing line or arc belong to it, m: two deviations of a bad scan, less than half a thin wall. */
export const BAND = 0.04;
/** A line or arc ends where no column follows for longer than this, m: a door with its frame. */
export const LONGEST_BREAK = 1.3;

/** Columns of a storey that may belong to walls, and those that no face has taken yet. */
export interface FreeColumns {
  readonly columns: HeightColumns;
  /** Direction of the normal; NaN where a column makes no line with its neighbours. */
  readonly angle: Float64Array;
  readonly isFree: Uint8Array;
}

/** A line or arc along which columns are taken up. */
export interface Course {
  /** The point at a place along it, `across` off it, m. */
  pointAt(along: number, across: number): readonly [x: number, y: number];
  /** How far off it a point is, m. */
  asideOf(x: number, y: number): number;
  /** Direction of its normal at a place along it, radians. */
  normalAt(along: number): number;
  /** A column whose own direction leaves it by more than this, radians, belongs to another. */
  readonly mostTurn: number;
}

/** Takes up the free columns across a course at a place along it; tells whether there are any, taken before or now. */
export function takeAcross(
  { columns, angle, isFree }: FreeColumns,
  course: Course,
  along: number,
  taken: Set<number>,
): boolean {
  const { centres, size } = columns;
  const normal = course.normalAt(along);
  let isAny = false;
  for (let across = -BAND; across <= BAND; across += size / 2) {
    const c = columnAt(columns, ...course.pointAt(along, across));
    if (c < 0 || isFree[c] === 0) continue;
    if (Math.abs(course.asideOf(centres[2 * c], centres[2 * c + 1])) > BAND) continue;
    // Corners and clutter have no direction.
    if (!(turnBetween(angle[c], normal) <= course.mostTurn)) continue;
    taken.add(c);
    isAny = true;
  }
  return isAny;
}
