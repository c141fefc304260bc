import { areaOf, combine } from '../geometry/areas.ts';
import { pointInRing } from '../geometry/rings.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { Furniture, Ring } from '../types.ts';
import { connectedColumns } from './connected-columns.ts';
import { ceiledShare, MOST_CEILED } from './find-columns.ts';
import { furnitureOutlines } from './furniture-outline.ts';
import { columnAt } from './height-columns.ts';
import { edgesOf, type RoomEdge } from './room-edges.ts';
import { type FurnishedRooms, type StandingPoints, standingPoints } from './standing-points.ts';
import { wallColumns } from './wall-columns.ts';

/** Footprints smaller than this are lamps' feet, cables, bins and what a scanner saw of somebody passing, m². */
const SMALLEST = 0.05;
/** What is nearer than this is one thing, m: no hand reaches between, and scanned rows may lie that far apart. */
const TOUCH = 0.1;
/** Door leaves and pictures are not as thick as this, m, and curtains with so many deviations of their points. */
const THIN = 0.08;
const THIN_DEVIATIONS = 4;
/** Nobody carries a scanner so low that it sees the top of what is higher than this, m … */
const EYE_HEIGHT = 1.3;
/** … which reaches back to the wall if that is no farther than the deepest cupboard, m. */
const DEEPEST = 0.8;
/** Lower things stand before the wall if it is no farther than this, m, skirting and the wall's own points left out. */
const BEFORE_WALL = 0.15;
/** Of less than one side in four somebody must have seen something, or it is a guess. */
const LEAST_SEEN = 0.25;
/** Cupboards up to the ceiling are deeper than this, m; pieces of wall that no room ends at are hardly thicker. */
const SHALLOWEST = 0.25;
/** Share of a thing's columns that are no higher than its top is said to be: a lamp on a table is not the table. */
const TOP_RANK = 0.9;

type Place = readonly [x: number, y: number];

interface Site extends FurnishedRooms {
  /** Edges of each room's outline. */
  readonly edges: readonly (readonly RoomEdge[])[];
}

/**
 * What stands in the rooms of a storey and is neither wall nor structure, room by room.
 *
 * Ours. Points off the walls that are no floor's and no ceiling's, in columns that touch. What stands from floor to ceiling
 * is furniture only where the ceiling goes on over it. O(points + columns · vertices of a room).
 */
export function findFurniture(rooms: FurnishedRooms): Furniture[] {
  const site = { ...rooms, edges: rooms.rooms.map(({ outline }) => edgesOf([outline])) };
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
    return outlines.some((outline) => ceiledShare(columns, outline) > MOST_CEILED) ? [] : group;
  });
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
  const room = site.rooms[standing.room[group[0]]];
  const structures = site.secondary.map(({ outline }) => outline);
  const free = combine('difference', [room.outline], structures);
  return outlinesOf(site, standing, group, THIN + THIN_DEVIATIONS * site.noise).flatMap((outline) =>
    combine('intersection', [{ outer: outline, holes: [] }], free).flatMap((piece): Furniture[] => {
      const { outer } = piece;
      const [height, confidence] = [heightWithin(standing, group, outer), seenShare(standing, outer)];
      const isFound = areaOf([piece]) >= SMALLEST && confidence >= LEAST_SEEN && !Number.isNaN(height);
      return isFound ? [{ outline: piece, height, confidence, room: room.name }] : [];
    }),
  );
}

function outlinesOf(
  site: Site,
  standing: StandingPoints,
  group: readonly number[],
  thinnest: number,
): Ring[] {
  const { xy, start, columns, room } = standing;
  const seen = Float64Array.from(group.flatMap((c) => [...xy.subarray(2 * start[c], 2 * start[c + 1])]));
  const known = Float64Array.from(waysToWalls(site, standing, new Set(group)));
  const wall = wallDirection(site.edges[room[group[0]]], seen);
  const isTall = isMostly(group, (c) => standing.top[c] > EYE_HEIGHT);
  const isHidden = (x: number, y: number) => isTall && isUnseen(standing, columnAt(columns, x, y));
  return furnitureOutlines({ seen, known, wall, isHidden }, columns.size, thinnest);
}

/** Places between a group of columns and the walls it stands before, x, y each; none where most of the floor there was seen. */
function waysToWalls(site: Site, standing: StandingPoints, group: ReadonlySet<number>): number[] {
  const { columns, room, top } = standing;
  const { size, table } = columns;
  const ways: number[] = [];
  let [open, closed] = [0, 0];
  for (const c of group) {
    const [ix, iy] = table.coordinatesOf(c);
    const [x, y] = [(ix + 0.5) * size, (iy + 0.5) * size];
    const foot = footOf(site.edges[room[c]], x, y);
    if (foot.away > (top[c] > EYE_HEIGHT ? DEEPEST : BEFORE_WALL)) continue;
    const way = wayAcross(standing, group, [x, y], foot.place);
    if (way === null) open++;
    else closed++;
    ways.push(...(way ?? []));
  }
  return closed > open ? ways : [];
}

/** The place on the nearest wall that is square to it from a place in the room; infinitely far where there is none. */
function footOf(edges: readonly RoomEdge[], x: number, y: number): { place: Place; away: number } {
  let best: { place: Place; away: number } = { place: [x, y], away: Infinity };
  for (const { ax, ay, ux, uy, length } of edges) {
    const [along, away] = [(x - ax) * ux + (y - ay) * uy, (y - ay) * ux - (x - ax) * uy];
    if (along < 0 || along > length || away < 0 || away >= best.away) continue;
    best = { place: [ax + along * ux, ay + along * uy], away };
  }
  return best;
}

/** Null where the floor was seen on the way, or something else stands there. */
function wayAcross(
  standing: StandingPoints,
  group: ReadonlySet<number>,
  from: Place,
  to: Place,
): number[] | null {
  const steps = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / standing.columns.size));
  const way: number[] = [];
  for (let k = 1; k <= steps; k++) {
    const [x, y] = [from[0] + (k / steps) * (to[0] - from[0]), from[1] + (k / steps) * (to[1] - from[1])];
    const at = columnAt(standing.columns, x, y);
    // The column at the wall shows the floor of the gap before it.
    if (!group.has(at) && !isUnseen(standing, at) && k < steps - 1) return null;
    way.push(x, y);
  }
  return way;
}

/** Whether neither the floor was seen in a column nor what stands on it. */
function isUnseen({ columns, room }: StandingPoints, c: number): boolean {
  return c < 0 || (room[c] < 0 && (columns.planes[c] & 1) === 0);
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

/** Height of the top of the columns within an outline, m; NaN where none is. */
function heightWithin({ columns, top }: StandingPoints, group: readonly number[], outline: Ring): number {
  const { table, size } = columns;
  const tops = group.filter((c) => {
    const [ix, iy] = table.coordinatesOf(c);
    return pointInRing((ix + 0.5) * size, (iy + 0.5) * size, outline) > 0;
  });
  const sorted = Float64Array.from(tops, (c) => top[c]).sort();
  return sorted[Math.floor(TOP_RANK * (sorted.length - 1))] ?? Number.NaN;
}

/** Share of an outline along which something was seen to stand, within a column's width. */
function seenShare({ columns, room }: StandingPoints, outline: Ring): number {
  const { table, size } = columns;
  let [seen, count] = [0, 0];
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    const [dx, dy] = [outline[j] - outline[i], outline[j + 1] - outline[i + 1]];
    const steps = Math.ceil(Math.hypot(dx, dy) / size);
    for (let k = 0; k < steps; k++) {
      const [ix, iy] = [outline[i] + (k / steps) * dx, outline[i + 1] + (k / steps) * dy].map((at) =>
        Math.floor(at / size),
      );
      count++;
      if (isNearStanding(table, room, ix, iy)) seen++;
    }
  }
  return seen / count;
}

function isNearStanding(
  table: StandingPoints['columns']['table'],
  room: Int32Array,
  ix: number,
  iy: number,
): boolean {
  for (let dy = -1; dy <= 1; dy++) {
    for (let dx = -1; dx <= 1; dx++) {
      const c = table.find(ix + dx, iy + dy, 0);
      if (c >= 0 && room[c] >= 0) return true;
    }
  }
  return false;
}
