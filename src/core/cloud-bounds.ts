import { valueOfRank } from './robust-scale.ts';

/** Points that tell a trimmed bound well enough. */
const SAMPLES = 50_000;
/** Shares of the points that may be astray on either side without moving a trimmed bound. */
const TRIM = 0.02;

/** Along the three axes, x, y, z. */
export interface CloudBounds {
  readonly min: Float64Array;
  readonly max: Float64Array;
}

/** Exact bounds. O(n). */
export function cloudBounds(positions: Float32Array): CloudBounds {
  const min = new Float64Array(3).fill(Infinity);
  const max = new Float64Array(3).fill(-Infinity);
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    if (positions[i] < min[axis]) min[axis] = positions[i];
    if (positions[i] > max[axis]) max[axis] = positions[i];
  }
  return { min, max };
}

/**
 * Bounds of the inner 96 % along each axis, from an evenly strided sample: stray points do not stretch them.
 */
export function trimmedBounds(positions: Float32Array): CloudBounds {
  const points = positions.length / 3;
  const stride = Math.max(1, Math.floor(points / SAMPLES));
  const values = new Float32Array(Math.ceil(points / stride));
  const min = new Float64Array(3);
  const max = new Float64Array(3);
  for (let axis = 0; axis < 3; axis++) {
    for (let i = 0; i < values.length; i++) values[i] = positions[3 * i * stride + axis];
    const trimmed = Math.floor(values.length * TRIM);
    min[axis] = valueOfRank(values, trimmed);
    max[axis] = valueOfRank(values, values.length - 1 - trimmed);
  }
  return { min, max };
}

/** Longest side. */
export function largestExtent({ min, max }: CloudBounds): number {
  return Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}
