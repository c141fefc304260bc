import { cellKey, cellMate, cellPlace, pointKey, pointMate, pointPriority } from './cell-hash.ts';

/** Points hashed together: enough to fetch much from memory at once, few enough for the fastest cache. */
export const RUN_POINTS = 256;

/** Words of a name as a power of two: those two that tell the cell, and {@link PLACE} and {@link PRIORITY}. */
export const NAME_SHIFT = 2;
export const MATE = 1;
/** Where the search for the cell begins, before the size of the table is taken into account. */
export const PLACE = 2;
export const PRIORITY = 3;

/** The names of the cells of a run of points, and the points' priorities. */
export class HashedRun {
  /** Of point k from k << NAME_SHIFT on. */
  readonly names = new Int32Array(RUN_POINTS << NAME_SHIFT);

  /**
   * @param words the bits of `xyz`
   * @param cell edge, or 0 where every point has a cell of its own
   */
  hash(
    { xyz, words }: { readonly xyz: Float64Array; readonly words: Int32Array },
    { begin, end }: { readonly begin: number; readonly end: number },
    cell: number,
  ): void {
    if (cell > 0) this.#nameCells(xyz, begin, end, 1 / cell);
    else this.#namePoints(words, begin, end);
    const { names } = this;
    let name = 0;
    for (let i = 6 * begin; i < 6 * end; i += 6, name += 1 << NAME_SHIFT) {
      names[name + PRIORITY] = pointPriority(words, i);
    }
  }

  #nameCells(xyz: Float64Array, begin: number, end: number, inverse: number): void {
    const { names } = this;
    let name = 0;
    for (let i = 3 * begin; i < 3 * end; i += 3, name += 1 << NAME_SHIFT) {
      const ix = Math.floor(xyz[i] * inverse) | 0;
      const iy = Math.floor(xyz[i + 1] * inverse) | 0;
      const iz = Math.floor(xyz[i + 2] * inverse) | 0;
      names[name] = cellKey(ix, iy);
      names[name + MATE] = cellMate(iy, iz);
      names[name + PLACE] = cellPlace(ix, iy, iz);
    }
  }

  #namePoints(words: Int32Array, begin: number, end: number): void {
    const { names } = this;
    let name = 0;
    for (let i = 6 * begin; i < 6 * end; i += 6, name += 1 << NAME_SHIFT) {
      names[name] = pointKey(words, i);
      names[name + MATE] = pointMate(words, i);
      names[name + PLACE] = names[name];
    }
  }
}
