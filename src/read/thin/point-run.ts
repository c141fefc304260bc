import type { PointChunk } from '../cloud-reader.ts';
import { isPlace } from '../is-place.ts';
import { codeOf, SIDE_BITS } from './cell-code.ts';
import { pointPriority } from './point-hash.ts';

interface Range {
  readonly begin: number;
  readonly end: number;
}

/** Points looked at together: few enough for the fastest cache. */
export const RUN_POINTS = 512;

/** Some points on their way into a store of records: where they come from, and which records they became. */
export class PointRun {
  count = 0;
  /** Their numbers where they come from. */
  readonly points = new Int32Array(RUN_POINTS);
  readonly priorities = new Int32Array(RUN_POINTS);
  /** Their cells and, by {@link findCells}, the blocks of these. */
  readonly codes = new Uint16Array(RUN_POINTS);
  readonly blockX = new Int32Array(RUN_POINTS);
  readonly blockY = new Int32Array(RUN_POINTS);
  readonly blockZ = new Int32Array(RUN_POINTS);
  /** Filled when they are stored. */
  readonly records = new Int32Array(RUN_POINTS);

  /**
   * Takes the points `begin` to `end` of a chunk, at most {@link RUN_POINTS}; those without a place are left out.
   *
   * @param bits of the chunk's coordinates
   * @param box made to hold the points taken
   */
  take({ xyz }: PointChunk, bits: Int32Array, { begin, end }: Range, { min, max }: Box): void {
    const { points, priorities } = this;
    let count = 0;
    let lowX = min[0];
    let lowY = min[1];
    let lowZ = min[2];
    let highX = max[0];
    let highY = max[1];
    let highZ = max[2];
    for (let i = begin; i < end; i++) {
      const at = Math.imul(3, i);
      if (!isPlace(xyz, at)) continue;
      const x = xyz[at];
      const y = xyz[at + 1];
      const z = xyz[at + 2];
      if (x < lowX) lowX = x;
      if (x > highX) highX = x;
      if (y < lowY) lowY = y;
      if (y > highY) highY = y;
      if (z < lowZ) lowZ = z;
      if (z > highZ) highZ = z;
      points[count] = i;
      priorities[count++] = pointPriority(bits, 2 * at);
    }
    this.count = count;
    // −0 becomes 0: one place, different bits.
    [min[0], min[1], min[2]] = [lowX + 0, lowY + 0, lowZ + 0];
    [max[0], max[1], max[2]] = [highX + 0, highY + 0, highZ + 0];
  }

  /** Finds the cells of its points, and their blocks. */
  findCells({ xyz, stride }: Places, cell: number): void {
    const { count, points, codes, blockX, blockY, blockZ } = this;
    const inverse = 1 / cell;
    for (let k = 0; k < count; k++) {
      const at = Math.imul(stride, points[k]);
      const ix = Math.floor(xyz[at] * inverse) | 0;
      const iy = Math.floor(xyz[at + 1] * inverse) | 0;
      const iz = Math.floor(xyz[at + 2] * inverse) | 0;
      codes[k] = codeOf(ix, iy, iz);
      blockX[k] = ix >> SIDE_BITS;
      blockY[k] = iy >> SIDE_BITS;
      blockZ[k] = iz >> SIDE_BITS;
    }
  }

  /** What follows the points from `begin` on that lie in one block. */
  endOfBlock(begin: number): number {
    const { count, blockX, blockY, blockZ } = this;
    const x = blockX[begin];
    const y = blockY[begin];
    const z = blockZ[begin];
    let end = begin + 1;
    while (end < count && blockX[end] === x && blockY[end] === y && blockZ[end] === z) end++;
    return end;
  }
}

/** Coordinates of points, x, y, z from every `stride` on. */
export interface Places {
  readonly xyz: Float64Array;
  readonly stride: number;
}

/** Corners of a box that grows. */
export interface Box {
  readonly min: [x: number, y: number, z: number];
  readonly max: [x: number, y: number, z: number];
}
