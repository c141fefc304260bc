import { convexHull } from '../geometry/convex-hull.ts';
import { boundsOf, pointInPolygon, pointInRing, signedArea } from '../geometry/rings.ts';
import { completeShell } from '../secondary/complete-shell.ts';
import { distanceToRing } from '../secondary/structure.ts';
import type { PointCloud, Polygon, Ring, SecondaryBoundary } from '../types.ts';
import { hasBin } from './bin-masks.ts';
import { connectedColumns } from './connected-columns.ts';
import { type HeightColumns, pointsOf, topShare } from './height-columns.ts';
import type { LocalCeiling } from './local-ceiling.ts';

/** A structure stands this far off the walls, m: nearer, it is a part of them. */
const OFF_WALL = 0.12;
/** It reaches above cupboards: so many of the bins just below the ceiling have points … */
const TOP_SHARE = 0.5;
/** … its columns together over so much of the whole height … */
const LEAST_STANDING = 0.6;
/** … and each of its columns in so many of all bins. */
const LEAST_HITS = 0.3;
/** Fewest columns, and area, m², of the grid that make one. */
const FEWEST = 3;
const SMALLEST = 0.01;
/** Columns no farther apart than so many, either way, are of one structure. */
const TOUCH = 3;
/** Larger ones are shafts and cores, m². */
const LARGEST_COLUMN = 1.5;
const LARGEST = 12;

/** Over more of a structure than this the ceiling cannot be seen, looked at so far within its rim, m. */
export const MOST_CEILED = 0.2;
const RIM = 0.05;

/** Structures that stand from floor to ceiling within rooms: columns and shafts. */
export function findColumns(
  cloud: PointCloud,
  columns: HeightColumns,
  ceiling: LocalCeiling,
  rooms: readonly Polygon[],
): SecondaryBoundary[] {
  const isStanding = standingColumns(columns, ceiling);
  const isInside = (c: number) => insideRooms(columns, c, rooms);
  const members = [...isStanding.keys()].filter((c) => isStanding[c] === 1 && isInside(c));
  return groupsOf(columns, members).flatMap((group) => structureOf(cloud, columns, group) ?? []);
}

function standingColumns(columns: HeightColumns, ceiling: LocalCeiling): Uint8Array {
  const { count, hits, bins, masks, centres } = columns;
  const isStanding = new Uint8Array(count);
  for (let c = 0; c < count; c++) {
    if (hits[c] < 2) continue;
    const top = topShare(columns, masks, c, ceiling.at(centres[2 * c], centres[2 * c + 1]));
    isStanding[c] = top >= TOP_SHARE && hits[c] >= LEAST_HITS * bins ? 1 : 0;
  }
  return isStanding;
}

function insideRooms({ centres }: HeightColumns, c: number, rooms: readonly Polygon[]): boolean {
  const [x, y] = [centres[2 * c], centres[2 * c + 1]];
  return rooms.some(
    (room) => pointInPolygon(x, y, { ...room, holes: [] }) > 0 && distanceToRing(x, y, room.outer) > OFF_WALL,
  );
}

/** Columns that touch, or nearly. */
function groupsOf(columns: HeightColumns, members: readonly number[]): number[][] {
  const open = new Set(members);
  return members.flatMap((first) =>
    open.delete(first) ? [connectedColumns(columns, first, TOUCH, (c) => open.delete(c))] : [],
  );
}

function structureOf(
  cloud: PointCloud,
  columns: HeightColumns,
  group: readonly number[],
): SecondaryBoundary | null {
  if (group.length < FEWEST) return null;
  const { masks, bins } = columns;
  let standing = 0;
  for (let bin = 0; bin < bins; bin++) if (group.some((c) => hasBin(masks, c, bin))) standing++;
  if (standing < LEAST_STANDING * bins) return null;
  const xy = pointsOf(cloud, columns, group);
  const outline = outlineOf(xy);
  const area = signedArea(outline);
  if (area < SMALLEST || area > LARGEST || ceiledShare(columns, outline) > MOST_CEILED) return null;
  return {
    outline: { outer: outline, holes: [] },
    operation: 'subtract',
    type: area <= LARGEST_COLUMN ? 'column' : 'shaft',
    points: xy.length / 2,
  };
}

/** Share of what is under an outline, off its rim, over which the ceiling was seen: it goes on over cupboards. */
export function ceiledShare({ table, size, overhead }: HeightColumns, outline: Ring): number {
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  let [ceiled, count] = [0, 0];
  for (let iy = Math.floor(minY / size); iy <= Math.floor(maxY / size); iy++) {
    for (let ix = Math.floor(minX / size); ix <= Math.floor(maxX / size); ix++) {
      const [x, y] = [(ix + 0.5) * size, (iy + 0.5) * size];
      if (pointInRing(x, y, outline) <= 0 || distanceToRing(x, y, outline) < RIM) continue;
      count++;
      const c = table.find(ix, iy, 0);
      if (c >= 0 && !Number.isNaN(overhead[c])) ceiled++;
    }
  }
  return count === 0 ? 0 : ceiled / count;
}

function outlineOf(xy: Float64Array): Ring {
  return completeShell(xy) ?? convexHull(xy);
}
