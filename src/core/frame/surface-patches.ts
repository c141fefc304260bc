import { CellTable } from '../cell-table.ts';
import { largestExtent, trimmedBounds } from '../cloud-bounds.ts';
import { medianOf } from '../robust-scale.ts';
import { type SmallestEigen, smallestEigen } from './symmetric-eigen.ts';

/**
 * More points than this are sampled by stride: the scan is sorted by lattice cell, so a stride thins evenly.
 */
const POINTS_LOOKED_AT = 1_000_000;
/** Enough for a covariance to show a plane under noise. */
const POINTS_A_PATCH = 32;
/** Fewer are stray points or the rim of a surface. */
const FEWEST_POINTS = 5;
/** A patch is a plane when its thickness is below this share of its width (standard deviations). */
const FLATNESS = 0.35;
/** … and its width no smaller than this share of its length: a line has no normal. */
const ROUNDNESS = 0.2;
/** Cells a cloud's longest side is cut into: first look, fewest and most. */
const FIRST_DIVISION = 32;
const DIVISION = { fewest: 10, most: 256 };
/** x, y, z, xx, xy, xz, yy, yz, zz of a cell, relative to its corner. */
const SUMS = 9;

/** A cloud seen as small surfaces: one a voxel, of equal size whatever the density of points. */
export interface SurfacePatches {
  readonly count: number;
  /** Edge of the voxels, source units; a patch stands for size² of surface. */
  readonly size: number;
  /** x, y, z a patch. */
  readonly centroids: Float64Array;
  /** Unit normal of unknown sign; zero where the voxel holds no plane. */
  readonly normals: Float64Array;
  /** Median thickness of the planar patches, one standard deviation: the scan's noise, source units. */
  readonly noise: number;
  /** Every stride-th point was looked at. */
  readonly stride: number;
}

/**
 * Fits a plane to the points of every voxel.
 *
 * Patches count by area, so a densely scanned wall weighs no more than a sparse one, and keep their normals,
 * so floors are told from walls even when the whole scan is tilted. Stray points fall into voxels of few
 * points and drop out. O(n), at most a million points are looked at.
 *
 * @param positions x, y, z a point, source units; not all equal
 */
export function surfacePatches(positions: Float32Array): SurfacePatches {
  const points = positions.length / 3;
  const stride = Math.ceil(points / POINTS_LOOKED_AT);
  const sampled = Math.ceil(points / stride);
  const bounds = trimmedBounds(positions);
  const extent = largestExtent(bounds) || 1;
  const first = new CellTable(sampled / POINTS_A_PATCH);
  const at = { positions, stride, sampled, origin: bounds.min };
  numberCells(at, extent / FIRST_DIVISION, first);
  const ideal = (extent / FIRST_DIVISION) * Math.sqrt((POINTS_A_PATCH * first.count) / sampled);
  const size = Math.min(extent / DIVISION.fewest, Math.max(extent / DIVISION.most, ideal));
  const table = new CellTable(sampled / POINTS_A_PATCH);
  const cellOf = numberCells(at, size, table);
  return { ...fitPatches(at, size, cellOf, table.count), stride };
}

type FittedPatches = Omit<SurfacePatches, 'stride'>;

interface Sampled {
  readonly positions: Float32Array;
  readonly stride: number;
  readonly sampled: number;
  readonly origin: Float64Array;
}

function numberCells({ positions, stride, sampled, origin }: Sampled, size: number, table: CellTable) {
  const cellOf = new Int32Array(sampled);
  const [x0, y0, z0] = origin;
  for (let i = 0; i < sampled; i++) {
    const p = 3 * i * stride;
    cellOf[i] = table.add(
      Math.floor((positions[p] - x0) / size),
      Math.floor((positions[p + 1] - y0) / size),
      Math.floor((positions[p + 2] - z0) / size),
    );
  }
  return cellOf;
}

function fitPatches(at: Sampled, size: number, cellOf: Int32Array, cells: number): FittedPatches {
  const { positions, stride, sampled } = at;
  const sums = new Float64Array(cells * SUMS);
  const counts = new Uint32Array(cells);
  const anchors = new Float64Array(cells * 3);
  for (let i = 0; i < sampled; i++) {
    const p = 3 * i * stride;
    const cell = cellOf[i];
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
  return planesOf(sums, counts, anchors, size);
}

function planesOf(
  sums: Float64Array,
  counts: Uint32Array,
  anchors: Float64Array,
  size: number,
): FittedPatches {
  const centroids = new Float64Array(anchors.length);
  const normals = new Float64Array(anchors.length);
  const thicknesses: number[] = [];
  const eigen: SmallestEigen = { values: new Float64Array(3), vector: new Float64Array(3) };
  const covariance = new Float64Array(6);
  let count = 0;
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
    centroids[3 * count] = anchors[3 * cell] + x;
    centroids[3 * count + 1] = anchors[3 * cell + 1] + y;
    centroids[3 * count + 2] = anchors[3 * cell + 2] + z;
    smallestEigen(covariance, eigen);
    const [thin, wide, long] = eigen.values;
    if (thin < FLATNESS ** 2 * wide && wide > ROUNDNESS ** 2 * long) {
      normals.set(eigen.vector, 3 * count);
      thicknesses.push(Math.sqrt(Math.max(0, thin)));
    }
    count++;
  }
  const noise = thicknesses.length > 0 ? medianOf(Float64Array.from(thicknesses)) : 0;
  return {
    count,
    size,
    centroids: centroids.slice(0, 3 * count),
    normals: normals.slice(0, 3 * count),
    noise,
  };
}
