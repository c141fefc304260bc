import type { CellTable } from '../cell-table.ts';
import type { RoomColumns, RoomGap } from './room-columns.ts';

const FEWEST_POINTS = 2;
/** Points this share of a room's height from its floor and ceiling belong to those. */
const MARGIN = 0.1;
/** A column that spans more of the room's height stands in a wall or a door lintel, not on furniture. */
const SPAN = 0.1;
/** The fuller side must hold this many times as many columns, and by this many deviations of a count. */
const LEAD = 1.5;
const SIGNIFICANT = 3;
/** Lamps, ducts and stray reflections cover less of a room's planes; a furnished room's tables, seats and beds more. */
const LEAST_COVER = 0.04;
/** Lamps and ducts hang nearer to their ceiling than this share of the height; tables and worktops stand higher. */
const DEEP_MARGIN = 0.2;
/** Fewer columns that deep, or so many times as many as on the other side, tell nothing where little is covered. */
const FEWEST_DEEP = 9;
const DEEP_LEAD = 10;
/** Floor and ceiling of a room differ less than this in what is seen of them: rows of desks are no floor. */
const ALIKE = 0.4;
/** A column counts where its four neighbours are such columns too: undersides of lintels and window sills are narrower. */
const NEIGHBOURS = [
  [1, 0],
  [-1, 0],
  [0, 1],
  [0, -1],
] as const;

/**
 * Where the furniture stands: 1 on the lower plane of the rooms, −1 on the upper one, 0 where that is not clear.
 *
 * A column that is filled in one half of the room only, at about one height, is a table top, seat or bed – or a lamp.
 * Walls fill both halves; what reaches as far as floor or ceiling is a lintel, or a flank; counting voxels of any kind
 * instead was wrong for rooms with many doors. What covers little of the floor tells nothing, unless it stands too high
 * for a lamp turned over. O(n) a room.
 */
export function furnitureSide(columns: RoomColumns, rooms: readonly RoomGap[]): -1 | 0 | 1 {
  const { lower, upper } = sumOf(rooms, (room) => furnishedColumns(columns, room, MARGIN));
  const [less, more] = lower < upper ? [lower, upper] : [upper, lower];
  if (more - less <= SIGNIFICANT * Math.sqrt(less + more) || more <= LEAD * less) return 0;
  const side = lower > upper ? 1 : -1;
  const planes = rooms.map((room) => planeColumns(columns, room));
  const covered = planes.reduce((sum, plane) => sum + Math.max(plane.lower, plane.upper), 0);
  if (more >= LEAST_COVER * covered) return side;
  const alike = rooms.filter((_, i) => areAlike(planes[i]));
  const deep = sumOf(alike, (room) => furnishedColumns(columns, room, DEEP_MARGIN));
  const [same, other] = side > 0 ? [deep.lower, deep.upper] : [deep.upper, deep.lower];
  return same >= FEWEST_DEEP && same > DEEP_LEAD * other ? side : 0;
}

/** Columns of either side of a room. */
interface Sides {
  readonly lower: number;
  readonly upper: number;
}

function sumOf(rooms: readonly RoomGap[], count: (room: RoomGap) => Sides): Sides {
  return rooms
    .map(count)
    .reduce((sum, { lower, upper }) => ({ lower: sum.lower + lower, upper: sum.upper + upper }), {
      lower: 0,
      upper: 0,
    });
}

function areAlike({ lower, upper }: Sides): boolean {
  return Math.min(lower, upper) >= ALIKE * Math.max(lower, upper);
}

/** What furnishes either half of a room, no nearer to its plane than a share of the height. */
function furnishedColumns(columns: RoomColumns, { low, high }: RoomGap, share: number): Sides {
  const margin = share * (high - low);
  const [bottom, top] = [low + margin, high - margin];
  const { counts, lows, highs } = fillColumns(columns, { low: bottom, high: top });
  const middle = (low + high) / 2;
  const sides = Int8Array.from(counts, (count, i) => {
    if (count < FEWEST_POINTS || highs[i] - lows[i] > SPAN * (high - low)) return 0;
    if (highs[i] < middle) return lows[i] > bottom + columns.edge ? 1 : 0;
    return lows[i] > middle && highs[i] < top - columns.edge ? -1 : 0;
  });
  return countWide(columns.table, sides);
}

/** Columns that the room's planes fill, counted as furniture is. */
function planeColumns(columns: RoomColumns, { low, high }: RoomGap): Sides {
  const margin = MARGIN * (high - low);
  const [lower, upper] = [low, high].map((height) => {
    const { counts } = fillColumns(columns, { low: height - margin, high: height + margin });
    const filled = Int8Array.from(counts, (count) => (count < FEWEST_POINTS ? 0 : 1));
    return countWide(columns.table, filled).lower;
  });
  return { lower, upper };
}

/** The points between two heights, by columns. */
function fillColumns({ table, columns, heights }: RoomColumns, { low, high }: RoomGap) {
  const counts = new Uint32Array(table.count);
  const lows = new Float64Array(table.count).fill(Infinity);
  const highs = new Float64Array(table.count).fill(-Infinity);
  for (let i = 0; i < columns.length; i++) {
    const height = heights[i];
    if (height < low || height > high) continue;
    const column = columns[i];
    counts[column]++;
    if (height < lows[column]) lows[column] = height;
    if (height > highs[column]) highs[column] = height;
  }
  return { counts, lows, highs };
}

/** Columns of either side amid others of their side. */
function countWide(table: CellTable, sides: Int8Array): Sides {
  let lower = 0;
  let upper = 0;
  for (let column = 0; column < sides.length; column++) {
    const side = sides[column];
    if (side === 0) continue;
    const [u, v] = table.coordinatesOf(column);
    const isWide = NEIGHBOURS.every(([du, dv]) => sides[table.find(u + du, v + dv, 0)] === side);
    if (!isWide) continue;
    if (side > 0) lower++;
    else upper++;
  }
  return { lower, upper };
}
