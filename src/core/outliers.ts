import { CellTable } from './cell-table.ts';
import { largestExtent, trimmedBounds } from './cloud-bounds.ts';
import type { StageContext } from './context.ts';
import { indexCells } from './outliers/cell-index.ts';
import { flagFarComponents } from './outliers/far-components.ts';
import { flagLonely, meanNeighbourDistance } from './outliers/neighbour-search.ts';
import type { Options } from './params.ts';
import { medianOf } from './robust-scale.ts';
import type { PointCloud } from './types.ts';

/** Points whose neighbour distances stand for all. */
const SAMPLE = 5_000;
/**
 * Distances past this many medians are left out of mean and deviation: far strays must not hide the near
 * ones.
 */
const CLIP_FACTOR = 10;
/**
 * Outliers are no more than this share of the points: where there are more, they are a surface scanned less
 * densely …
 */
const MOST_OUTLIERS = 0.05;
/** … so a point is none unless it is this many times as lonely as the loneliest of the others. */
const LEAST_FACTOR = 2;
/** Components lie at least this many limits apart. */
const COMPONENT_CELL = 4;
/** Cells the longest side is cut into to estimate how densely the surfaces are scanned. */
const DIVISION = 64;
/** Enough to find those cells. */
const CELL_SAMPLE = 200_000;

/**
 * Indices of the points that are no outliers, rising.
 *
 * [Stojanovic19] §3: an outlier is far from the main cluster and not part of a dense one. Two tests: the mean
 * distance to the `outlierNeighbours` nearest points is more than `outlierDeviations` deviations above the
 * mean over the cloud ([Rusu08] §4, here with mean and deviation free of the far strays themselves); or the
 * point is in a small component outside the bounding box of the largest. O(n) for clouds of even density.
 *
 * @param cloud metres; a flat one is searched in its plane
 */
export function removeOutliers(cloud: PointCloud, options: Options, context: StageContext): Uint32Array {
  const { positions } = cloud;
  const points = positions.length / 3;
  const { outlierNeighbours, outlierDeviations } = options;
  const neighbours = Math.min(outlierNeighbours, points - 1);
  const isOut = new Uint8Array(points);
  if (outlierDeviations === 0 || neighbours < 1) return unflagged(isOut);
  const limit = lonelinessLimit(positions, neighbours, outlierDeviations);
  context.progress(0.3);
  if (limit === 0) return unflagged(isOut);
  isOut.set(flagLonely(indexCells(positions, limit), neighbours));
  context.progress(0.8);
  const social = unflagged(isOut);
  const isFar = flagFarComponents(gather(positions, social), COMPONENT_CELL * limit);
  for (let i = 0; i < social.length; i++) isOut[social[i]] |= isFar[i];
  return unflagged(isOut);
}

/** Indices of the zero entries. */
function unflagged(flags: Uint8Array): Uint32Array {
  const indices = new Uint32Array(flags.length);
  let count = 0;
  for (let i = 0; i < flags.length; i++) {
    if (flags[i] === 0) indices[count++] = i;
  }
  return indices.slice(0, count);
}

/** Mean distance to the neighbours past which a point is lonely, m. */
function lonelinessLimit(positions: Float32Array, neighbours: number, deviations: number): number {
  const distances = sampleDistances(positions, neighbours).sort();
  const { mean, deviation } = momentsUpTo(distances, CLIP_FACTOR * medianOf(distances));
  const rare = distances[Math.floor((1 - MOST_OUTLIERS) * (distances.length - 1))];
  return Math.max(mean + deviations * deviation, LEAST_FACTOR * rare);
}

/** Mean neighbour distances of an even sample; cells grow until at least half of them are exact. */
function sampleDistances(positions: Float32Array, neighbours: number): Float64Array {
  const stride = Math.max(1, Math.floor(positions.length / 3 / SAMPLE));
  const distances = new Float64Array(Math.ceil(positions.length / 3 / stride));
  const nearest = new Float64Array(neighbours);
  for (let edge = surfaceSpacing(positions) * Math.sqrt(neighbours); ; edge *= 2) {
    const index = indexCells(positions, edge);
    for (let i = 0; i < distances.length; i++) {
      const p = 3 * i * stride;
      distances[i] = meanNeighbourDistance(index, positions.subarray(p, p + 3), nearest);
    }
    if (medianOf(distances.slice()) < edge) return distances;
  }
}

/**
 * Rough distance between points on the scanned surfaces: the area of the cells they occupy shared among them.
 */
function surfaceSpacing(positions: Float32Array): number {
  const points = positions.length / 3;
  const edge = largestExtent(trimmedBounds(positions)) / DIVISION || 1;
  const table = new CellTable();
  const step = 3 * Math.ceil(points / CELL_SAMPLE);
  for (let i = 0; i < positions.length; i += step) {
    table.add(
      Math.floor(positions[i] / edge),
      Math.floor(positions[i + 1] / edge),
      Math.floor(positions[i + 2] / edge),
    );
  }
  return edge * Math.sqrt(table.count / points);
}

function momentsUpTo(values: Float64Array, limit: number): { mean: number; deviation: number } {
  let [count, sum, squares] = [0, 0, 0];
  for (const value of values) {
    if (value > limit) continue;
    count++;
    sum += value;
    squares += value * value;
  }
  const mean = sum / count;
  return { mean, deviation: Math.sqrt(Math.max(0, squares / count - mean * mean)) };
}

function gather(positions: Float32Array, indices: Uint32Array): Float32Array {
  const gathered = new Float32Array(indices.length * 3);
  for (let i = 0; i < indices.length; i++) {
    const p = 3 * indices[i];
    gathered[3 * i] = positions[p];
    gathered[3 * i + 1] = positions[p + 1];
    gathered[3 * i + 2] = positions[p + 2];
  }
  return gathered;
}
