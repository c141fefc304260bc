/** Cells a side of a block as a power of two: a surface crosses it in some thousand cells, which fit the cache; 32 are the bits of a word. */
export const SIDE_BITS = 5;
export const SIDE = 1 << SIDE_BITS;
/** Bits of a cell's coordinate that tell its place in the block. */
export const IN_BLOCK = SIDE - 1;
export const BLOCK_CELLS = 1 << (3 * SIDE_BITS);

/** A cell's number in its block: x fastest. */
export function codeOf(ix: number, iy: number, iz: number): number {
  return ((((iz & IN_BLOCK) << SIDE_BITS) | (iy & IN_BLOCK)) << SIDE_BITS) | (ix & IN_BLOCK);
}
