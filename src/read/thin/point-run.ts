import type { PointChunk } from '../cloud-reader.ts';
import { isPlace } from '../is-place.ts';
import { pointPriority } from './point-hash.ts';

/** Points looked at together: few enough for the fastest cache. */
export const RUN_POINTS = 512;

/** Some points on their way into a store of records: where they come from, and which records they became. */
export class PointRun {
  count = 0;
  /** Their numbers where they come from. */
  readonly points = new Uint32Array(RUN_POINTS);
  readonly priorities = new Int32Array(RUN_POINTS);
  /** Filled when they are stored. */
  readonly records = new Uint32Array(RUN_POINTS);

  /**
   * Takes the points `begin` to `end` of a chunk, at most {@link RUN_POINTS}; those without a place are left out.
   *
   * @param words the bits of the chunk's coordinates
   */
  take({ xyz }: PointChunk, words: Int32Array, begin: number, end: number): void {
    const { points, priorities } = this;
    let count = 0;
    for (let i = begin; i < end; i++) {
      const at = 3 * i;
      if (!isPlace(xyz, at)) continue;
      points[count] = i;
      priorities[count++] = pointPriority(words, 2 * at);
    }
    this.count = count;
  }
}

/** Corners of a box that grows. */
export interface Box {
  readonly min: [x: number, y: number, z: number];
  readonly max: [x: number, y: number, z: number];
}

/** Makes a box hold the points of a run. */
export function growBox({ min, max }: Box, xyz: Float64Array, { count, points }: PointRun): void {
  for (let axis = 0; axis < 3; axis++) {
    let [low, high] = [min[axis], max[axis]];
    for (let k = 0; k < count; k++) {
      const value = xyz[3 * points[k] + axis];
      if (value < low) low = value;
      if (value > high) high = value;
    }
    // −0 becomes 0: one place, different bits.
    [min[axis], max[axis]] = [low + 0, high + 0];
  }
}
