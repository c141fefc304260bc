import { kmeans } from 'ml-kmeans';
import { distinctPoints } from './geometry/point-order.ts';

/**
 * Points handed to ml-kmeans; more are sampled evenly and assigned to the nearest centre afterwards (100 k:
 * 0.5 s).
 */
const SAMPLE = 20_000;
const ITERATIONS = 100;

/** Points of the plane parted into clusters. */
export interface Clusters {
  /** Cluster of each point. */
  readonly clusterOf: Uint8Array;
  /** x, y a cluster: the mean of its points. */
  readonly centres: Float64Array;
  /** Points of each cluster. */
  readonly sizes: Uint32Array;
}

/**
 * k-means clusters of points in the plane, started by k-means++ ([Arthur07]) with a seed ([Stojanovic19]
 * §3.1).
 *
 * Clusters are numbered from left to right, so numbers do not depend on the start.
 *
 * @param xy x, y a point
 * @param k clusters, at most 255; fewer come back when there are fewer distinct points
 */
export function clusterPoints(xy: Float64Array, k: number, seed: number): Clusters {
  const centres = findCentres(xy, k, seed);
  const points = xy.length / 2;
  const clusterOf = new Uint8Array(points);
  const sizes = new Uint32Array(centres.length / 2);
  const sums = new Float64Array(centres.length);
  for (let i = 0; i < points; i++) {
    const cluster = nearestCentre(centres, xy[2 * i], xy[2 * i + 1]);
    clusterOf[i] = cluster;
    sizes[cluster]++;
    sums[2 * cluster] += xy[2 * i];
    sums[2 * cluster + 1] += xy[2 * i + 1];
  }
  return {
    clusterOf,
    sizes,
    centres: sums.map((sum, at) => (sizes[at >> 1] > 0 ? sum / sizes[at >> 1] : centres[at])),
  };
}

/** x, y a centre, from left to right. */
function findCentres(xy: Float64Array, k: number, seed: number): Float64Array {
  // In lexicographic order, so that the order given does not steer the start.
  const distinct = distinctPoints(xy);
  const points = distinct.length / 2;
  if (points <= k) return distinct;
  const stride = Math.ceil(points / SAMPLE);
  const sample: number[][] = [];
  for (let i = 0; i < points; i += stride) sample.push([distinct[2 * i], distinct[2 * i + 1]]);
  const { centroids } = kmeans(sample, k, { seed, initialization: 'kmeans++', maxIterations: ITERATIONS });
  centroids.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  return Float64Array.from(centroids.flat());
}

function nearestCentre(centres: Float64Array, x: number, y: number): number {
  let nearest = 0;
  let least = Infinity;
  for (let at = 0; at < centres.length; at += 2) {
    const squared = (centres[at] - x) ** 2 + (centres[at + 1] - y) ** 2;
    if (squared >= least) continue;
    least = squared;
    nearest = at >> 1;
  }
  return nearest;
}
