import { findBoundary } from '../boundary.ts';
import type { StageContext } from '../context.ts';
import { convexHull } from '../geometry/convex-hull.ts';
import { distinctPoints } from '../geometry/point-order.ts';
import { signedArea } from '../geometry/rings.ts';
import { meanSpacing } from '../geometry/spacing.ts';
import type { Options } from '../params.ts';
import { simplifyRing } from '../regularise/simplify-ring.ts';
import { passesOf } from '../regularise.ts';
import type { Ring } from '../types.ts';

/** Share of the squared extent below which points lie on a line. */
const ROUNDING = 1e-9;

/**
 * Concave outline of some points by gift opening, regularised with the tolerance of secondary boundaries.
 *
 * @param xy x, y a point, m
 * @returns null when the points enclose no area
 */
export function outlinePoints(xy: Float64Array, options: Options, context: StageContext): Ring | null {
  const ring = concaveRing(xy, options, context);
  if (!ring) return null;
  const { secondaryEpsilon: epsilon, visvalingamEpsilon } = options;
  const areaEpsilon = visvalingamEpsilon === 'auto' ? epsilon ** 2 : visvalingamEpsilon;
  return simplifyRing(ring, { epsilon, areaEpsilon, passes: passesOf(options) });
}

/** Concave outline of some points by gift opening; null when they enclose no area. */
export function concaveRing(xy: Float64Array, options: Options, context: StageContext): Ring | null {
  const points = distinctPoints(xy);
  if (points.length < 6) return null;
  const hull = convexHull(points);
  if (hull.length < 6 || signedArea(hull) <= ROUNDING * squaredExtent(hull)) return null;
  // Gaps are bridged in walls of rooms; around a structure every opening is its shape.
  const ownOptions: Options = { ...options, boundary: 'gift-opening', bridgeGap: 0 };
  const slice = { xy: points, band: [0, 0] as const, spacing: meanSpacing(points) };
  const { polygons } = findBoundary(slice, ownOptions, { ...context, warn: () => {} });
  return polygons[0].outer;
}

function squaredExtent(ring: Ring): number {
  let squared = 0;
  for (let i = 2; i < ring.length; i += 2) {
    squared = Math.max(squared, (ring[i] - ring[0]) ** 2 + (ring[i + 1] - ring[1]) ** 2);
  }
  return squared;
}
