import { bitCount } from '../bit-count.ts';
import type { RoomColumns, RoomGap } from './room-columns.ts';

/** A room's height is cut into so many layers, one bit each; the outermost two at either end hold its planes. */
const LAYERS = 16;
const TOP = LAYERS - 1;
const PLANE_LAYERS = 2;
/** Layers between the planes. */
const INNER = ((1 << (LAYERS - 2 * PLANE_LAYERS)) - 1) << PLANE_LAYERS;
const PLANE = (1 << PLANE_LAYERS) - 1;
/** A lintel is at least this many layers high, below the ceiling's own … */
const LEAST_LINTEL = 2;
/** … and leaves at least half of the height open: what reaches lower hides no doorway. */
const LOWEST_HEAD = LAYERS / 2;
/** Layers that a wall fills between floor and ceiling; a scan's thin spots leave some out. */
const WALL_LAYERS = 9;
/** Shares of the room's height: past the wall a lintel is in, and from the middle of a double door to its jambs. */
const BEYOND = 0.15;
const JAMB = 0.6;
/** Ways that a wall may run, evenly spread over half a turn: none is further than a wall's thickness off at its jambs. */
const WAYS = Array.from({ length: 8 }, (_, k) => (Math.PI * k) / 8).map(
  (angle) => [Math.cos(angle), Math.sin(angle)] as const,
);
/** Lintels this long together, in heights of their room: the two faces of one narrow door. */
const LEAST_LENGTH = 0.5;
/** Counters, parapets and beams between walls look like doorways turned over; doorways are many times as many. */
const LEAD = 3;

/**
 * Where the doorways end: 1 at the lower plane of the rooms, −1 at the upper one, 0 where that is not clear.
 *
 * Doorways reach down to the floor and leave a lintel below the ceiling. Sought are columns filled from one plane to no
 * further than the middle and empty from there on, in line with a wall on both sides, with free space and the other
 * plane before and behind: a window has no floor outside, a cupboard no free space behind. Ours. O(n) a room.
 */
export function doorwaySide(columns: RoomColumns, rooms: readonly RoomGap[]): -1 | 0 | 1 {
  let [lower, upper] = [0, 0];
  for (const room of rooms) {
    const height = (room.high - room.low) / columns.edge;
    const filled = fillLayers(columns, room);
    lower += lintelColumns({ columns, filled, height }) / height;
    upper += lintelColumns({ columns, filled: filled.map(turnedOver), height }) / height;
  }
  if (Math.max(lower, upper) < LEAST_LENGTH) return 0;
  if (Math.max(lower, upper) <= LEAD * Math.min(lower, upper)) return 0;
  return lower > upper ? 1 : -1;
}

interface Layered {
  readonly columns: RoomColumns;
  /** A column's layers that hold points, lowest first. */
  readonly filled: Uint16Array;
  /** Of the room, in edges. */
  readonly height: number;
}

function fillLayers({ table, columns, heights }: RoomColumns, { low, high }: RoomGap): Uint16Array {
  const filled = new Uint16Array(table.count);
  const perLayer = (high - low) / LAYERS;
  for (let i = 0; i < columns.length; i++) {
    const layer = Math.floor((heights[i] - low) / perLayer);
    // Half of a plane's points lie beyond it.
    if (layer >= -1 && layer <= LAYERS) filled[columns[i]] |= 1 << Math.min(TOP, Math.max(0, layer));
  }
  return filled;
}

function turnedOver(layers: number): number {
  let turned = 0;
  for (let k = 0; k < LAYERS; k++) turned |= ((layers >> k) & 1) << (TOP - k);
  return turned;
}

/** Columns through the lintels of doorways that reach down to the lower plane. */
function lintelColumns(room: Layered): number {
  let count = 0;
  for (let column = 0; column < room.filled.length; column++) {
    if (!isLintel(room.filled[column])) continue;
    const [u, v] = room.columns.table.coordinatesOf(column);
    if (WAYS.some((way) => isInDoorway(room, u, v, way))) count++;
  }
  return count;
}

/** Filled from the ceiling down to a head, empty from there to the floor. */
function isLintel(layers: number): boolean {
  let head = TOP - 1;
  while (head >= LOWEST_HEAD && (layers >> head) & 1) head--;
  const below = ((1 << (head + 1)) - 1) & INNER;
  return TOP - 1 - head >= LEAST_LINTEL && head >= LOWEST_HEAD - 1 && (layers & below) === 0;
}

/** Whether a wall along (−y, x) goes on at both sides, and free floor lies before and behind it. */
function isInDoorway(room: Layered, u: number, v: number, [x, y]: readonly [number, number]): boolean {
  const beyond = BEYOND * room.height;
  return (
    isFree(room, Math.round(u + beyond * x), Math.round(v + beyond * y)) &&
    isFree(room, Math.round(u - beyond * x), Math.round(v - beyond * y)) &&
    meetsWall(room, u, v, [-y, x]) &&
    meetsWall(room, u, v, [y, -x])
  );
}

/** Nothing stands or hangs there, and the lower plane is seen there or beside. */
function isFree(room: Layered, u: number, v: number): boolean {
  if ((layersAt(room, u, v) & INNER) !== 0) return false;
  for (let du = -1; du <= 1; du++) {
    for (let dv = -1; dv <= 1; dv++) if (layersAt(room, u + du, v + dv) & PLANE) return true;
  }
  return false;
}

/** Whether a wall stands that way, and nothing before it in the opening. */
function meetsWall(room: Layered, u: number, v: number, [x, y]: readonly [number, number]): boolean {
  for (let step = 1; step <= JAMB * room.height; step++) {
    const inner = layersAt(room, Math.round(u + step * x), Math.round(v + step * y)) & INNER;
    if (bitCount(inner) >= WALL_LAYERS) return true;
    if (inner & ((1 << (LOWEST_HEAD - 1)) - 1)) return false;
  }
  return false;
}

function layersAt({ columns, filled }: Layered, u: number, v: number): number {
  return filled[columns.table.find(u, v, 0)] ?? 0;
}
