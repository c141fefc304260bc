import { CellTable } from '../cell-table.ts';
import type { Vec3 } from '../types.ts';
import { multiply, type Rotation, rotate, rotationToZ } from './rotation.ts';
import type { SurfacePatches } from './surface-patches.ts';

/** Columns a patch edge: with 32 points a patch, a column through a table top holds three or four. */
const COLUMNS_A_PATCH = 3;
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

/** The space between two neighbouring planes, along the up vector from the positions' origin. */
export interface RoomGap {
  readonly low: number;
  readonly high: number;
}

/**
 * Where the furniture stands: 1 on the lower plane of the rooms, −1 on the upper one, 0 where that is not
 * clear.
 *
 * A column that is filled in one half of the room only, at about one height, is a table top, seat or bed – or
 * a lamp. Walls fill both halves; what reaches as far as floor or ceiling is a lintel, or a flank; counting voxels
 * of any kind instead was wrong for rooms with many doors. What covers
 * little of the floor tells nothing, unless it stands too high for a lamp turned over. O(n), at most a million points are looked at.
 *
 * @param upright source axes → plan axes
 * @param up estimate of up, source axes
 */
export function furnitureSide(
  positions: Float32Array,
  { size, stride }: SurfacePatches,
  rotation: { readonly upright: Rotation; readonly up: Vec3 },
  rooms: readonly RoomGap[],
): -1 | 0 | 1 {
  const { upright, up } = rotation;
  const r = multiply(rotationToZ(rotate(upright, up)), upright);
  const sampled = { positions, stride, r, edge: size / COLUMNS_A_PATCH };
  const all = { lower: 0, upper: 0 };
  const deep = { lower: 0, upper: 0 };
  let planes = 0;
  for (const room of rooms) {
    addTo(all, furnishedColumns(sampled, room, MARGIN));
    const [low, high] = [planeColumns(sampled, room, room.low), planeColumns(sampled, room, room.high)];
    planes += Math.max(low, high);
    if (Math.min(low, high) < ALIKE * Math.max(low, high)) continue;
    addTo(deep, furnishedColumns(sampled, room, DEEP_MARGIN));
  }
  const [less, more] = all.lower < all.upper ? [all.lower, all.upper] : [all.upper, all.lower];
  if (more - less <= SIGNIFICANT * Math.sqrt(less + more) || more <= LEAD * less) return 0;
  const side = all.lower > all.upper ? 1 : -1;
  const [same, other] = side > 0 ? [deep.lower, deep.upper] : [deep.upper, deep.lower];
  const isDeep = same >= FEWEST_DEEP && same > DEEP_LEAD * other;
  return isDeep || more >= LEAST_COVER * planes ? side : 0;
}

/** Columns of either side of a room. */
interface Sides {
  lower: number;
  upper: number;
}

function addTo(sum: Sides, { lower, upper }: Sides): void {
  sum.lower += lower;
  sum.upper += upper;
}

interface Sampled {
  readonly positions: Float32Array;
  readonly stride: number;
  readonly r: Rotation;
  readonly edge: number;
}

/** What furnishes either half of a room, no nearer to its plane than a share of the height. */
function furnishedColumns(sampled: Sampled, { low, high }: RoomGap, share: number): Sides {
  const margin = share * (high - low);
  const [bottom, top] = [low + margin, high - margin];
  const { table, counts, lows, highs } = fillColumns(sampled, { low: bottom, high: top });
  const middle = (low + high) / 2;
  const sides = Int8Array.from(counts, (count, i) => {
    if (count < FEWEST_POINTS || highs[i] - lows[i] > SPAN * (high - low)) return 0;
    if (highs[i] < middle) return lows[i] > bottom + sampled.edge ? 1 : 0;
    return lows[i] > middle && highs[i] < top - sampled.edge ? -1 : 0;
  });
  return countWide(table, sides);
}

/** Columns that the room's plane at `height` fills, counted as furniture is. */
function planeColumns(sampled: Sampled, { low, high }: RoomGap, height: number): number {
  const margin = MARGIN * (high - low);
  const { table, counts } = fillColumns(sampled, { low: height - margin, high: height + margin });
  const sides = Int8Array.from(counts, (count) => (count < FEWEST_POINTS ? 0 : 1));
  return countWide(table, sides).lower;
}

/** The points between two heights, by columns. */
function fillColumns({ positions, stride, r, edge }: Sampled, { low, high }: RoomGap) {
  const table = new CellTable();
  const counts: number[] = [];
  const lows: number[] = [];
  const highs: number[] = [];
  for (let p = 0; p < positions.length; p += 3 * stride) {
    const [x, y, z] = [positions[p], positions[p + 1], positions[p + 2]];
    const height = r[6] * x + r[7] * y + r[8] * z;
    if (height < low || height > high) continue;
    const u = Math.floor((r[0] * x + r[1] * y + r[2] * z) / edge);
    const column = table.add(u, Math.floor((r[3] * x + r[4] * y + r[5] * z) / edge), 0);
    counts[column] = (counts[column] ?? 0) + 1;
    lows[column] = Math.min(lows[column] ?? height, height);
    highs[column] = Math.max(highs[column] ?? height, height);
  }
  return { table, counts, lows, highs };
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
