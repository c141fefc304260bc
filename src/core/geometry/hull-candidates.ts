import { orientation } from './predicates.ts';

/** Fewer points are sorted out no faster than they are hulled. */
const FEW = 64;

/**
 * The points that may be vertices of the convex hull: all but those strictly inside the octagon of the points farthest
 * in eight directions [Akl78]. Exact: each edge of the octagon is asked with the robust predicate.
 *
 * @param xy distinct points in lexicographic order
 * @returns their numbers, in order. O(n).
 */
export function hullCandidates(xy: Float64Array): Uint32Array {
  const n = xy.length >> 1;
  const candidates = new Uint32Array(n);
  const octagon = n < FEW ? [] : extremes(xy);
  let count = 0;
  for (let i = 0; i < n; i++) if (!isInside(xy, octagon, i)) candidates[count++] = i;
  return candidates.subarray(0, count);
}

/** Points farthest right, up right, up, …: counter-clockwise, without repeats. */
function extremes(xy: Float64Array): number[] {
  const found = new Uint32Array(8);
  const best = new Float64Array(8).fill(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < xy.length; i += 2) {
    const x = xy[i];
    const y = xy[i + 1];
    const sum = x + y;
    const difference = y - x;
    if (x > best[0]) [best[0], found[0]] = [x, i >> 1];
    if (sum > best[1]) [best[1], found[1]] = [sum, i >> 1];
    if (y > best[2]) [best[2], found[2]] = [y, i >> 1];
    if (difference > best[3]) [best[3], found[3]] = [difference, i >> 1];
    if (-x > best[4]) [best[4], found[4]] = [-x, i >> 1];
    if (-sum > best[5]) [best[5], found[5]] = [-sum, i >> 1];
    if (-y > best[6]) [best[6], found[6]] = [-y, i >> 1];
    if (-difference > best[7]) [best[7], found[7]] = [-difference, i >> 1];
  }
  return [...found].filter((point, k) => point !== found[(k + 7) % 8]);
}

/** Whether a point lies strictly left of every edge of a ring of three points or more. */
function isInside(xy: Float64Array, ring: readonly number[], i: number): boolean {
  for (let k = 0; k < ring.length; k++) {
    const a = 2 * ring[k];
    const b = 2 * ring[k + 1 === ring.length ? 0 : k + 1];
    if (orientation(xy[a], xy[a + 1], xy[b], xy[b + 1], xy[2 * i], xy[2 * i + 1]) <= 0) return false;
  }
  return ring.length > 2;
}
