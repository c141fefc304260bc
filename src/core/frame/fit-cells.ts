import { type SmallestEigen, smallestEigen } from './symmetric-eigen.ts';

/** Fewer are stray points or the rim of a surface. */
export const FEWEST_POINTS = 5;
/** A patch is a plane when its thickness is below this share of its width (standard deviations). */
const FLATNESS = 0.35;
/** … and its width no smaller than this share of its length: a line has no normal. */
const ROUNDNESS = 0.2;
/** x, y, z, xx, xy, xz, yy, yz, zz of a cell, relative to its corner. */
const SUMS = 9;

/** Every stride-th of a cloud's points. */
export interface SampledPoints {
  readonly positions: Float32Array;
  readonly stride: number;
  readonly sampled: number;
  readonly origin: Float64Array;
}

/** Planes of least squares through the points of cells. */
export interface FittedCells {
  readonly counts: Uint32Array;
  readonly centroids: Float64Array;
  /** Zero where the points are no plane. */
  readonly normals: Float64Array;
  readonly isPlane: Uint8Array;
  /** One standard deviation across the plane. */
  readonly thickness: Float64Array;
}

/**
 * Fits a plane to the points of each cell. O(n + cells).
 *
 * @param cellOf cell of each sampled point; −1 for points that are left out
 */
export function fitCells(at: SampledPoints, cellOf: Int32Array, cells: number): FittedCells {
  const { positions, stride, sampled } = at;
  const sums = new Float64Array(cells * SUMS);
  const counts = new Uint32Array(cells);
  const anchors = new Float64Array(cells * 3);
  for (let i = 0; i < sampled; i++) {
    const p = 3 * i * stride;
    const cell = cellOf[i];
    if (cell < 0) continue;
    if (counts[cell]++ === 0) anchors.set(positions.subarray(p, p + 3), 3 * cell);
    const x = positions[p] - anchors[3 * cell];
    const y = positions[p + 1] - anchors[3 * cell + 1];
    const z = positions[p + 2] - anchors[3 * cell + 2];
    const s = cell * SUMS;
    sums[s] += x;
    sums[s + 1] += y;
    sums[s + 2] += z;
    sums[s + 3] += x * x;
    sums[s + 4] += x * y;
    sums[s + 5] += x * z;
    sums[s + 6] += y * y;
    sums[s + 7] += y * z;
    sums[s + 8] += z * z;
  }
  return planesOf(sums, counts, anchors);
}

/** @param anchors the first point of each cell, which its sums are relative to; becomes the centroids */
function planesOf(sums: Float64Array, counts: Uint32Array, anchors: Float64Array): FittedCells {
  const normals = new Float64Array(anchors.length);
  const isPlane = new Uint8Array(counts.length);
  const thickness = new Float64Array(counts.length);
  const eigen: SmallestEigen = { values: new Float64Array(3), vector: new Float64Array(3) };
  const covariance = new Float64Array(6);
  for (let cell = 0; cell < counts.length; cell++) {
    const n = counts[cell];
    if (n < FEWEST_POINTS) continue;
    const s = cell * SUMS;
    const [x, y, z] = [sums[s] / n, sums[s + 1] / n, sums[s + 2] / n];
    covariance[0] = sums[s + 3] / n - x * x;
    covariance[1] = sums[s + 4] / n - x * y;
    covariance[2] = sums[s + 5] / n - x * z;
    covariance[3] = sums[s + 6] / n - y * y;
    covariance[4] = sums[s + 7] / n - y * z;
    covariance[5] = sums[s + 8] / n - z * z;
    anchors[3 * cell] += x;
    anchors[3 * cell + 1] += y;
    anchors[3 * cell + 2] += z;
    smallestEigen(covariance, eigen);
    const [thin, wide, long] = eigen.values;
    if (!(thin < FLATNESS ** 2 * wide && wide > ROUNDNESS ** 2 * long)) continue;
    normals.set(eigen.vector, 3 * cell);
    isPlane[cell] = 1;
    thickness[cell] = Math.sqrt(Math.max(0, thin));
  }
  return { counts, centroids: anchors, normals, isPlane, thickness };
}
