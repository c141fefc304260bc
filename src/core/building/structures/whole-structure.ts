import { signedArea } from '../../geometry/rings.ts';
import type { PointCloud, Ring } from '../../types.ts';
import { type HeightColumns, hasPlane } from '../columns/height-columns.ts';
import { type Rectangle, ringOf, type StructureShape, sizeOf, THINNEST } from './structure-shape.ts';
import { seenAround, surroundingsOf } from './structure-surroundings.ts';

/** Longer ones, m, are shafts and cores … */
const LONGEST_COLUMN = 1.25;
/** … of which so many sides were seen: a wall or a row of cupboards shows two … */
const SHAFT_SIDES = 3;
/** … and those with more than this, m², are rooms. */
const LARGEST = 12;
/** Floor or ceiling is seen along so much of the way around a structure: it stands in a room … */
const LEAST_AROUND = 0.5;
/** … and at no more than this share of the places within it, where noise may carry its own points … */
const MOST_WITHIN = 0.3;
/** … with no more than this share of the ceiling's points: over cupboards and open leaves of doors it goes on. */
const MOST_CEILED = 0.2;
/** Where a single face is all that tells, fewer points to be expected of the ceiling are no proof that it ends. */
const LEAST_EXPECTED = 4;

/** Beyond a side that was not seen, floor or ceiling are looked for so far off it, m. */
const BEYOND = 0.15;

/** What structures are looked for in. */
export interface StructureSite {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  /** Standard deviation of points across a face, m. */
  readonly noise: number;
}

/**
 * The whole outline of what a structure's points lie on; null where it is no structure.
 *
 * The ceiling ends at a structure, and floor or ceiling was seen around it. Where one of its faces is longer than what was seen
 * beside it is deep, and nothing was seen behind, it is taken for square.
 */
export function wholeOutline(site: StructureSite, { rectangle, outline, seen }: StructureShape): Ring | null {
  if (rectangle === null) return signedArea(outline) <= LARGEST && standsFree(site, outline) ? outline : null;
  const [along, across] = sizeOf(rectangle);
  const [least, most] = [Math.min(along, across), Math.max(along, across)];
  if (most < THINNEST || (least < THINNEST && most > LONGEST_COLUMN) || signedArea(outline) > LARGEST)
    return null;
  const sides = seen.filter(Boolean).length;
  if (most > LONGEST_COLUMN) return sides >= SHAFT_SIDES && standsFree(site, outline) ? outline : null;
  const square = squareBehind(site, rectangle, seen);
  if (square !== null) return square;
  const isWhole = least >= THINNEST && isClosed(site, rectangle, seen);
  return isWhole && standsFree(site, outline) ? outline : null;
}

/** Whether floor or ceiling was seen beyond each side that was not. */
function isClosed(
  { columns }: StructureSite,
  { ux, uy, sides }: Rectangle,
  seen: readonly boolean[],
): boolean {
  const [left, right, low, high] = sides;
  return seen.every((isSeen, k) => {
    const out = sides[k] + (k % 2 === 0 ? -BEYOND : BEYOND);
    const [a, b] = k < 2 ? [out, (low + high) / 2] : [(left + right) / 2, out];
    return isSeen || hasPlane(columns, a * ux - b * uy, a * uy + b * ux);
  });
}

/** Whether the ceiling ends at an outline, all that is around it was seen, and nothing within. */
function standsFree({ cloud, columns }: StructureSite, outline: Ring): boolean {
  if (seenAround(columns, outline) < LEAST_AROUND) return false;
  const { ceilingWithin, ceilingExpected, seenWithin } = surroundingsOf(cloud, columns, outline);
  if (seenWithin > MOST_WITHIN) return false;
  return ceilingWithin <= MOST_CEILED * ceilingExpected;
}

/** Whether a ceiling is known to end at an outline; without ceilings, floors must do. */
function endsCeiling({ cloud, columns }: StructureSite, outline: Ring): boolean {
  if (columns.heights.isOpenAbove) return true;
  return surroundingsOf(cloud, columns, outline).ceilingExpected >= LEAST_EXPECTED;
}

/**
 * The square on a face that is longer than what was seen beside it is deep; null unless there is one such side on which
 * nothing was seen.
 */
function squareBehind(site: StructureSite, rectangle: Rectangle, seen: readonly boolean[]): Ring | null {
  const { ux, uy, sides } = rectangle;
  const [along, across] = sizeOf(rectangle);
  const axis = along < across ? 0 : 2;
  const isThin = Math.min(along, across) < THINNEST;
  if (!isThin && seen[axis] && seen[axis + 1]) return null;
  const depth = Math.max(along, across);
  const middle = (sides[axis] + sides[axis + 1]) / 2;
  const [low, high] = isThin ? [middle, middle] : [sides[axis], sides[axis + 1]];
  const squares = [
    { back: 1, reach: [low, low + depth] },
    { back: 0, reach: [high - depth, high] },
  ].flatMap(({ back, reach: [from, to] }) => {
    if (!isThin && seen[axis + back]) return [];
    const square: [number, number, number, number] = [...sides];
    square[axis] = from;
    square[axis + 1] = to;
    return [ringOf({ ux, uy, sides: square })];
  });
  const free = squares.filter((square) => standsFree(site, square) && (!isThin || endsCeiling(site, square)));
  return free.length === 1 ? free[0] : null;
}
