import type { Ring } from '../types.ts';
import { chainCandidates } from './hull-candidates.ts';
import { distinctPoints } from './point-order.ts';
import { orientation } from './predicates.ts';

/**
 * Convex hull by divide and conquer [Preparata77]: halves of the sorted points, their chains joined by a tangent.
 *
 * Every turn is decided by the exact predicate; vertices are strictly convex, so points on an edge are left out.
 *
 * @param xy x, y a point, any order, repeats allowed
 * @returns counter-clockwise ring from the leftmost (lowest of equals) point; fewer than three vertices when all
 *   points lie on one line. O(n log n).
 */
export function convexHull(xy: Float64Array): Ring {
  const distinct = distinctPoints(xy);
  const hull = convexHullOfSorted(distinct);
  const ring = new Float64Array(2 * hull.length);
  for (let k = 0; k < hull.length; k++) {
    ring[2 * k] = distinct[2 * hull[k]];
    ring[2 * k + 1] = distinct[2 * hull[k] + 1];
  }
  return ring;
}

/**
 * As {@link convexHull}, for distinct points in lexicographic order.
 *
 * @returns point numbers of the hull, counter-clockwise
 */
export function convexHullOfSorted(xy: Float64Array): Uint32Array {
  if (xy.length < 4) return new Uint32Array(xy.length >> 1);
  const lower = chainCandidates(xy, 1);
  const upper = chainCandidates(xy, -1);
  const lowerLength = chainOf(xy, lower, 0, lower.length, 1);
  const upperLength = chainOf(xy, upper, 0, upper.length, -1);
  const hull = new Uint32Array(lowerLength + upperLength - 2);
  hull.set(lower.subarray(0, lowerLength - 1));
  // The upper chain runs left to right too; its inner vertices close the ring from right to left.
  for (let k = 0; k < upperLength - 1; k++) hull[lowerLength - 1 + k] = upper[upperLength - 1 - k];
  return hull;
}

/** Puts the lower (side 1) or upper (side -1) hull chain of the points chain[from … to - 1] in their place; returns its length. */
function chainOf(xy: Float64Array, chain: Uint32Array, from: number, to: number, side: 1 | -1): number {
  if (to - from === 1) return 1;
  const middle = (from + to) >> 1;
  let left = from + chainOf(xy, chain, from, middle, side) - 1;
  let right = middle;
  const end = middle + chainOf(xy, chain, middle, to, side) - 1;
  for (;;) {
    if (left > from && turn(xy, chain[left - 1], chain[left], chain[right]) * side <= 0) left--;
    else if (right < end && turn(xy, chain[left], chain[right], chain[right + 1]) * side <= 0) right++;
    else break;
  }
  chain.copyWithin(left + 1, right, end + 1);
  return left + 1 - from + (end + 1 - right);
}

function turn(xy: Float64Array, a: number, b: number, c: number): number {
  return orientation(xy[2 * a], xy[2 * a + 1], xy[2 * b], xy[2 * b + 1], xy[2 * c], xy[2 * c + 1]);
}
