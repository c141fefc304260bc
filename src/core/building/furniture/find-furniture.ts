import { areaOf, combine, grow } from '../../geometry/areas.ts';
import { boundsOf, pointInRing, ringsOf } from '../../geometry/rings.ts';
import { squaredDistanceToSegment } from '../../geometry/segments.ts';
import { conflictingEdges, isSimpleRing } from '../../geometry/simplicity.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { Furniture, Polygon, Ring } from '../../types.ts';
import { connectedColumns } from '../columns/connected-columns.ts';
import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import { wallColumns } from '../columns/wall-columns.ts';
import { edgesOf, type RoomEdge } from '../walls/room-edges.ts';
import { heightWithin, seenShare } from './furniture-evidence.ts';
import { furnitureOutlines } from './furniture-outline.ts';
import { type FurnishedRooms, type StandingPoints, standingPoints } from './standing-points.ts';
import { EYE_HEIGHT, isUnseen, waysToWalls } from './ways-to-walls.ts';

/** Footprints smaller than this are lamps' feet, cables, bins and what a scanner saw of somebody passing, m². */
const SMALLEST = 0.05;
/** What is nearer than this is one thing, m: no hand reaches between, and scanned rows may lie that far apart. */
const TOUCH = 0.1;
/** Door leaves and pictures are not as thick as this, m, and curtains with so many deviations of their points. */
const THIN = 0.08;
const THIN_DEVIATIONS = 4;
/** Of less than one side in four somebody must have seen something, or it is a guess. */
const LEAST_SEEN = 0.25;
/** Rings that touch where a room's corner cuts in are parted by this, m. */
const PARTING = 0.002;
/** Cupboards up to the ceiling are deeper than this, m; pieces of wall that no room ends at are hardly thicker. */
const SHALLOWEST = 0.25;
/** Over more of a wall or a shaft than this the ceiling cannot be seen, looked at so far within its rim, m. */
const MOST_CEILED = 0.2;
const RIM = 0.05;

interface Site extends FurnishedRooms {
  /** Edges of each room's outline. */
  readonly edges: readonly (readonly RoomEdge[])[];
  /** Each room's area without the structures in it. */
  readonly free: readonly (readonly Polygon[])[];
}

/**
 * What stands in the rooms of a storey and is neither wall nor structure, room by room.
 *
 * Ours. Points off the walls that are no floor's and no ceiling's, in columns that touch. What stands from floor to ceiling
 * is furniture only where the ceiling goes on over it. O(points + columns · vertices of a room).
 */
export function findFurniture(rooms: FurnishedRooms): Furniture[] {
  const outlines = rooms.rooms.map(({ outline }) => outline);
  const structures = rooms.secondary.map(({ outline }) => outline);
  const site: Site = {
    ...rooms,
    edges: outlines.map((outline) => edgesOf([outline])),
    free: outlines.map((outline) => combine('difference', [outline], structures)),
  };
  const standing = standingPoints(site);
  const isOpen = Uint8Array.from(standing.room, (room) => (room >= 0 ? 1 : 0));
  for (const c of structureColumns(site, standing)) isOpen[c] = 0;
  const found = groupsOf(standing, isOpen).flatMap((group) => furnitureOf(site, standing, group));
  return site.rooms.flatMap(({ name }) => found.filter(({ room }) => room === name));
}

/** Columns in rooms that stand up to a ceiling which does not go on over them: pieces of wall, shafts. */
function structureColumns(site: Site, standing: StandingPoints): number[] {
  const { columns, ceiling } = site;
  const { room, isShort } = standing;
  const isTall = wallColumns(columns, ceiling).map((tall, c) => (room[c] >= 0 ? tall : 0));
  return groupsOf(standing, isTall).flatMap((group) => {
    if (isMostly(group, (c) => isShort[c] === 1)) return [];
    const outlines = outlinesOf(site, standing, group, SHALLOWEST);
    return outlines.some(({ outer }) => ceiledShare(columns, outer) > MOST_CEILED) ? [] : group;
  });
}

/** Share of what is under an outline, off its rim, over which the ceiling was seen: it goes on over cupboards. */
function ceiledShare({ table, size, overhead }: HeightColumns, outline: Ring): number {
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

function isMostly(group: readonly number[], is: (c: number) => boolean): boolean {
  return 2 * group.filter(is).length > group.length;
}

/** Groups of marked columns that touch, each in one room. */
function groupsOf({ columns, room }: StandingPoints, isMarked: Uint8Array): number[][] {
  const isFree = isMarked.slice();
  const groups: number[][] = [];
  for (let first = 0; first < isFree.length; first++) {
    if (isFree[first] === 0) continue;
    isFree[first] = 0;
    const reach = Math.max(1, Math.round(TOUCH / columns.size));
    const group = connectedColumns(columns, first, reach, (c) => {
      if (isFree[c] === 0 || room[c] !== room[first]) return false;
      isFree[c] = 0;
      return true;
    });
    groups.push(group);
  }
  return groups;
}

function furnitureOf(site: Site, standing: StandingPoints, group: readonly number[]): Furniture[] {
  const { size } = standing.columns;
  if (group.length * size * size < SMALLEST / 2) return [];
  const owner = standing.room[group[0]];
  const outlines = outlinesOf(site, standing, group, THIN + THIN_DEVIATIONS * site.noise);
  const pieces = outlines.flatMap((outline) => combine('intersection', [outline], site.free[owner]));
  const sound = pieces.flatMap((piece) =>
    isSound(piece) ? [piece] : grow([piece], -PARTING).filter(isSound),
  );
  return sound.flatMap((outline): Furniture[] => {
    const height = heightWithin(standing, group, outline.outer);
    const confidence = seenShare(standing, outline.outer);
    const isFound = areaOf([outline]) >= SMALLEST && confidence >= LEAST_SEEN && !Number.isNaN(height);
    return isFound ? [{ outline, height, confidence, room: site.rooms[owner].name }] : [];
  });
}

/** Whether every ring is simple and touches no other. */
function isSound(polygon: Polygon): boolean {
  const rings = ringsOf([polygon]);
  return rings.every(isSimpleRing) && conflictingEdges(rings).length === 0;
}

function outlinesOf(
  site: Site,
  standing: StandingPoints,
  group: readonly number[],
  thinnest: number,
): Polygon[] {
  const { xy, start, columns, room } = standing;
  const seen = new Float64Array(2 * group.reduce((sum, c) => sum + start[c + 1] - start[c], 0));
  let filled = 0;
  for (const c of group) {
    seen.set(xy.subarray(2 * start[c], 2 * start[c + 1]), filled);
    filled += 2 * (start[c + 1] - start[c]);
  }
  const known = Float64Array.from(waysToWalls(site.edges[room[group[0]]], standing, new Set(group)));
  const wall = wallDirection(site.edges[room[group[0]]], seen);
  const isTall = isMostly(group, (c) => standing.top[c] > EYE_HEIGHT);
  const isHidden = (x: number, y: number) => isTall && isUnseen(standing, columnAt(columns, x, y));
  return furnitureOutlines({ seen, known, wall, isHidden }, columns.size, thinnest);
}

/** Along the wall nearest to the middle of points. */
function wallDirection(edges: readonly RoomEdge[], xy: Float64Array): readonly [ux: number, uy: number] {
  let [x, y] = [0, 0];
  for (let i = 0; i < xy.length; i += 2) [x, y] = [x + xy[i], y + xy[i + 1]];
  const middle = [(2 * x) / xy.length, (2 * y) / xy.length] as const;
  const away = ({ ax, ay, bx, by }: RoomEdge) => squaredDistanceToSegment(...middle, ax, ay, bx, by);
  const { ux, uy } = edges.reduce((best, edge) => (away(edge) < away(best) ? edge : best));
  return [ux, uy];
}
