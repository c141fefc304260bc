/** Odd multipliers without pattern: the digits of the golden ratio, and those of MurmurHash3 [Appleby11]. */
const A = 0x9e3779b1;
const B = 0x85ebca77;
const C = 0xc2b2ae3d;
const D = 0x27d4eb2f;
const E = 0x165667b1;
const F = 0xcc9e2d51;

/** Cells a side of a block as a power of two: cells of a block lie side by side in a table. */
const BLOCK_BITS = 2;
const IN_BLOCK = (1 << BLOCK_BITS) - 1;

/** Mask of the upper half of a float64. */
const WITHOUT_SIGN = 0x7fffffff;

/** Bits of x, y and z of a cell's 63-bit name. */
const AXIS_BITS = 21;
const AXIS_MASK = (1 << AXIS_BITS) - 1;
/** So many cells apart along an axis, cells have the same name: 16 km with cells of 8 mm. */
export const CELLS_TOLD_APART = 1 << AXIS_BITS;

/** Lower half of the name of a cell. */
export function cellKey(ix: number, iy: number): number {
  return (ix & AXIS_MASK) | (iy << AXIS_BITS);
}

/** Upper half of the name of a cell. */
export function cellMate(iy: number, iz: number): number {
  return ((iy & AXIS_MASK) >>> (32 - AXIS_BITS)) | (iz << (2 * AXIS_BITS - 32));
}

/**
 * Where a cell belongs in a table, before its size is taken into account.
 *
 * Blocks of cells are scattered, cells stay in their block: a scan that runs along a wall finds the next cell in cache.
 */
export function cellPlace(ix: number, iy: number, iz: number): number {
  // Cells of one name must meet in one place.
  const x = Math.imul((ix & AXIS_MASK) >> BLOCK_BITS, A);
  const y = Math.imul((iy & AXIS_MASK) >> BLOCK_BITS, B);
  const z = Math.imul((iz & AXIS_MASK) >> BLOCK_BITS, C);
  const block = finish(x + y + z);
  const within = (((iz & IN_BLOCK) << BLOCK_BITS) | (iy & IN_BLOCK)) << BLOCK_BITS;
  // Flipped by bits of the block: walls fill the same layer of many blocks.
  return (block << (3 * BLOCK_BITS)) | ((within | (ix & IN_BLOCK)) ^ (block >>> (32 - 3 * BLOCK_BITS)));
}

/**
 * A number that looks random but depends on nothing except the bits of a point's float64 coordinates, and neither on their
 * order nor on their signs: a cloud whose axes are named otherwise keeps the same points.
 */
export function pointPriority(words: Int32Array, at: number): number {
  const x = coordinateHash(words[at], words[at + 1]);
  const y = coordinateHash(words[at + 2], words[at + 3]);
  return finish(x + y + coordinateHash(words[at + 4], words[at + 5]));
}

/** Of the two halves of a float64, its sign left out; not linear, or sums of coordinates would be told apart, not places. */
function coordinateHash(low: number, high: number): number {
  const h = Math.imul(low, A) + Math.imul(high & WITHOUT_SIGN, B);
  return Math.imul(h ^ (h >>> 15), C);
}

/** Lower half of the 64-bit name of a point that has a cell of its own; another hash than its priority. */
export function pointKey(words: Int32Array, at: number): number {
  const x = Math.imul(words[at], D) + Math.imul(words[at + 1], E);
  const y = Math.imul(words[at + 2], F) + Math.imul(words[at + 3], A);
  return finish(x + y + Math.imul(words[at + 4], B) + Math.imul(words[at + 5], C));
}

/** Upper half of that name. */
export function pointMate(words: Int32Array, at: number): number {
  const x = Math.imul(words[at], F) + Math.imul(words[at + 1], C);
  const y = Math.imul(words[at + 2], B) + Math.imul(words[at + 3], E);
  return finish(x + y + Math.imul(words[at + 4], A) + Math.imul(words[at + 5], D));
}

/** The finaliser of MurmurHash3: every bit of the sum reaches every bit of the result. */
function finish(sum: number): number {
  let h = sum | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
