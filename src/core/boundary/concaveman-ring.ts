import concaveman from 'concaveman';
import { convexHull } from '../geometry/convex-hull.ts';
import { orientRing } from '../geometry/rings.ts';
import { isSimpleRing } from '../geometry/simplicity.ts';
import type { Ring } from '../types.ts';

/** Concavity grows by this factor when the ring crosses itself … */
const CALMER = 2;
/** … so many times before the convex hull stands in. */
const ATTEMPTS = 4;

/**
 * Concave hull after [Park12] by the `concaveman` package, the yardstick of gift opening.
 *
 * The package promises no simple ring; one that touches itself is made again with twice the concavity.
 *
 * @param points distinct points, x, y each, m
 * @param concavity relative; 1 follows every dent, below 2 crossings grow likely
 * @returns simple counter-clockwise ring, vertices among the points
 */
export function concavemanRing(points: Float64Array, concavity: number): Ring {
  const pairs: number[][] = [];
  for (let i = 0; i < points.length; i += 2) pairs.push([points[i], points[i + 1]]);
  for (let attempt = 0; attempt < ATTEMPTS; attempt++) {
    const hull = concaveman(pairs, concavity * CALMER ** attempt);
    const ring = Float64Array.from(withoutClosing(hull).flat());
    if (isSimpleRing(ring)) return orientRing(ring, 'counter-clockwise');
  }
  return convexHull(points);
}

/** The package repeats the first vertex at the end. */
function withoutClosing(hull: number[][]): number[][] {
  const first = hull[0];
  const last = hull[hull.length - 1];
  return hull.length > 1 && first[0] === last[0] && first[1] === last[1] ? hull.slice(0, -1) : hull;
}
