import { combine } from '../geometry/areas.ts';
import { boundsOf, pointInRing, signedArea } from '../geometry/rings.ts';
import { distanceToRing } from '../secondary/structure.ts';
import type { PointCloud, Polygon, Ring, SecondaryBoundary } from '../types.ts';
import { hasBin } from './bin-masks.ts';
import { connectedColumns } from './connected-columns.ts';
import { type HeightColumns, hasPlane, pointsOf, topShare } from './height-columns.ts';
import type { LocalCeiling } from './local-ceiling.ts';
import {
  type Rectangle,
  ringOf,
  type StructureShape,
  sizeOf,
  structureShape,
  THINNEST,
} from './structure-shape.ts';
import { seenAround, surroundingsOf } from './structure-surroundings.ts';

/** A structure stands this far off the walls, m: nearer, it is a part of them … */
const OFF_WALL = 0.12;
/** … unless floor or ceiling was seen along so much of the way around it: then the wall there is none. */
const ALL_AROUND = 0.85;
/** It reaches above cupboards: so many of the bins just below the ceiling have points … */
const TOP_SHARE = 0.5;
/** … its columns together over so much of the whole height … */
const LEAST_STANDING = 0.6;
/** … and each of its columns in so many of all bins. */
const LEAST_HITS = 0.3;
/** Fewest columns of the grid that make one. */
const FEWEST = 3;
/** Columns of the grid no farther apart than this, m, are of one structure. */
const TOUCH = 0.15;
/** Longer ones, m, or with more area, m², are shafts and cores … */
const LONGEST_COLUMN = 1.25;
const LARGEST_COLUMN = 1.5;
/** … of which so many sides were seen: a wall or a row of cupboards shows two … */
const SHAFT_SIDES = 3;
/** … and those with more than this, m², or wider, m, are rooms, or walls. */
const LARGEST = 12;
const WIDEST = 4;
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
 * Structures that stand from floor to ceiling within rooms: columns and shafts.
 *
 * Ours. What hangs together and reaches the ceiling, apart from the walls, is drawn by the circle or rectangle its faces lie
 * on; a face whose back no scanner saw is taken for a square's. It counts where floor and ceiling were seen around it and not
 * within: over cupboards and behind leaves of doors the ceiling goes on.
 */
export function findStructures(
  site: StructureSite,
  ceiling: LocalCeiling,
  rooms: readonly Polygon[],
): SecondaryBoundary[] {
  const { cloud, columns } = site;
  const found = freeGroups(columns, ceiling).flatMap((group) => {
    if (group.length < FEWEST || !isUpright(columns, group)) return [];
    return candidateOf(site, rooms, pointsOf(cloud, columns, group)) ?? [];
  });
  return joinedWhereTheyMeet(site, rooms, found).map(({ outline, xy }) => ({
    outline: { outer: outline, holes: [] },
    operation: 'subtract',
    type: signedArea(outline) <= LARGEST_COLUMN ? 'column' : 'shaft',
    points: xy.length / 2,
  }));
}

/**
 * Groups of columns of the grid that hang together just below the ceiling, as far as they stand; walls, whose lintels hang on
 * them, are too wide.
 */
function freeGroups(columns: HeightColumns, ceiling: LocalCeiling): number[][] {
  const { centres, size, hits, bins, masks } = columns;
  const open = new Set<number>();
  for (let c = 0; c < columns.count; c++) {
    const z = ceiling.at(centres[2 * c], centres[2 * c + 1]);
    if (hits[c] >= 2 && topShare(columns, masks, c, z) >= TOP_SHARE) open.add(c);
  }
  const touch = Math.max(TOUCH, size);
  const reach = Math.ceil(touch / size);
  return [...open].flatMap((first) => {
    if (!open.delete(first)) return [];
    const group = connectedColumns(columns, first, reach, (c, from) => {
      const away = Math.hypot(centres[2 * c] - centres[2 * from], centres[2 * c + 1] - centres[2 * from + 1]);
      return away <= touch && open.delete(c);
    });
    const { minX, minY, maxX, maxY } = boundsOf(group.flatMap((c) => [centres[2 * c], centres[2 * c + 1]]));
    if (Math.max(maxX - minX, maxY - minY) > WIDEST) return [];
    return [group.filter((c) => hits[c] >= LEAST_HITS * bins)];
  });
}

/** Whether columns together have points over much of the whole height. */
function isUpright({ masks, bins }: HeightColumns, group: readonly number[]): boolean {
  let standing = 0;
  for (let bin = 0; bin < bins; bin++) if (group.some((c) => hasBin(masks, c, bin))) standing++;
  return standing >= LEAST_STANDING * bins;
}

interface Candidate {
  readonly outline: Ring;
  /** The points of its faces, x, y each, m. */
  readonly xy: Float64Array;
}

function candidateOf(site: StructureSite, rooms: readonly Polygon[], xy: Float64Array): Candidate | null {
  const shape = structureShape(xy, site.noise);
  const outline = shape && wholeOutline(site, shape);
  if (outline === null) return null;
  // A face alone near a wall is a bay's side.
  const isFace = shape?.rectangle && Math.min(...sizeOf(shape.rectangle)) < THINNEST;
  const isFree = isOffWalls(outline, rooms) || (!isFace && seenAround(site.columns, outline) >= ALL_AROUND);
  return isFree ? { outline, xy } : null;
}

/** Structures that overlap are the sides of one. */
function joinedWhereTheyMeet(
  site: StructureSite,
  rooms: readonly Polygon[],
  found: readonly Candidate[],
): Candidate[] {
  const kept: Candidate[] = [];
  for (const candidate of found) {
    const at = kept.findIndex(({ outline }) => overlap(outline, candidate.outline));
    if (at < 0) {
      kept.push(candidate);
      continue;
    }
    const xy = Float64Array.from([...kept[at].xy, ...candidate.xy]);
    kept[at] =
      candidateOf(site, rooms, xy) ?? [kept[at], candidate].sort((a, b) => b.xy.length - a.xy.length)[0];
  }
  return kept;
}

function overlap(a: Ring, b: Ring): boolean {
  return combine('intersection', [{ outer: a, holes: [] }], [{ outer: b, holes: [] }]).length > 0;
}

/** Whether an outline lies in one of the rooms, and nowhere at its walls. */
function isOffWalls(outline: Ring, rooms: readonly Polygon[]): boolean {
  return rooms.some(
    ({ outer }) =>
      everyVertex(
        outline,
        (x, y) => pointInRing(x, y, outer) > 0 && distanceToRing(x, y, outer) >= OFF_WALL,
      ) &&
      everyVertex(
        outer,
        (x, y) => pointInRing(x, y, outline) < 0 && distanceToRing(x, y, outline) >= OFF_WALL,
      ),
  );
}

function everyVertex(ring: Ring, holds: (x: number, y: number) => boolean): boolean {
  for (let i = 0; i < ring.length; i += 2) if (!holds(ring[i], ring[i + 1])) return false;
  return true;
}

/** The outline of what stands there; null where it is no structure. */
function wholeOutline(site: StructureSite, { rectangle, outline, seen }: StructureShape): Ring | null {
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
