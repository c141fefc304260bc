import { type Clusters, clusterPoints } from '../kmeans.ts';
import { evenSample } from './even-sample.ts';

/** Clusters tried at most: a room with more than seven structures is better counted by eye. */
const MOST_CLUSTERS = 8;
/** Points compared with each other; more change the mean by less than 0.01. */
const SAMPLE = 400;

/**
 * Number of structures that clustering suggests: one less than the number of clusters, from two on, with the greatest
 * mean silhouette ([Rousseeuw87]). The paper leaves the number to the eye and to such methods ([Stojanovic19] §3.1).
 *
 * @param xy x, y a point
 * @returns at least 1; 0 for fewer than three distinct points. O(sample²) a number of clusters.
 */
export function proposeCount(xy: Float64Array, seed: number): number {
  const sample = evenSample(xy, SAMPLE);
  const distances = distancesBetween(sample);
  const most = Math.min(MOST_CLUSTERS, sample.length / 2 - 1);
  let best = 0;
  let greatest = -Infinity;
  for (let k = 2; k <= most; k++) {
    const silhouette = meanSilhouette(distances, clusterPoints(sample, k, seed));
    if (silhouette <= greatest) continue;
    greatest = silhouette;
    best = k - 1;
  }
  return best;
}

/** Of each point to those before it, one after the other. */
function distancesBetween(xy: Float64Array): Float64Array {
  const n = xy.length / 2;
  const distances = new Float64Array((n * (n - 1)) / 2);
  let at = 0;
  for (let i = 0; i < n; i++) {
    const [x, y] = [xy[2 * i], xy[2 * i + 1]];
    for (let j = 0; j < i; j++) distances[at++] = Math.sqrt((xy[2 * j] - x) ** 2 + (xy[2 * j + 1] - y) ** 2);
  }
  return distances;
}

/** Mean over the points of (b − a) / max(a, b): a within their cluster, b to the nearest other one. */
function meanSilhouette(distances: Float64Array, { clusterOf, sizes }: Clusters): number {
  const sums = distancesToClusters(distances, clusterOf, sizes.length);
  let total = 0;
  clusterOf.forEach((own, i) => {
    // By convention 0 for a point alone.
    if (sizes[own] < 2) return;
    const within = sums[i * sizes.length + own] / (sizes[own] - 1);
    let nearest = Infinity;
    for (let c = 0; c < sizes.length; c++) {
      if (c !== own && sizes[c] > 0) nearest = Math.min(nearest, sums[i * sizes.length + c] / sizes[c]);
    }
    if (Number.isFinite(nearest)) total += (nearest - within) / Math.max(nearest, within);
  });
  return total / clusterOf.length;
}

/** Sum of the distances of each point to those of each cluster, clusters of a point together. */
function distancesToClusters(distances: Float64Array, clusterOf: Uint8Array, clusters: number): Float64Array {
  const sums = new Float64Array(clusterOf.length * clusters);
  let at = 0;
  for (let i = 0; i < clusterOf.length; i++) {
    const own = clusterOf[i];
    for (let j = 0; j < i; j++) {
      const distance = distances[at++];
      sums[i * clusters + clusterOf[j]] += distance;
      sums[j * clusters + own] += distance;
    }
  }
  return sums;
}
