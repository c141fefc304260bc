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
import { completeShell } from './complete-shell.ts';
import { fitSides } from './fit-sides.ts';

/** Share of the squared extent below which points lie on a line. */
const ROUNDING = 1e-9;

/**
 * A concave outline with less than this share of the convex hull's area fell in through a side no scanner
 * saw.
 */
const LEAST_FILL = 0.5;

export interface StructureOutline {
  /** Simple, counter-clockwise. */
  readonly ring: Ring;
  /** A side was not seen, so the ring is completed. */
  readonly isOpen: boolean;
}

/**
 * Outer face of a structure that stands free: its concave outline; when one side of it was not seen, the
 * circle or rectangle its points lie on, else their convex hull.
 *
 * @param xy x, y a point, m
 * @returns null when the points enclose no area
 */
export function outlineStructure(
  xy: Float64Array,
  noise: number,
  options: Options,
  context: StageContext,
): StructureOutline | null {
  const concave = concaveRing(xy, options, context);
  if (!concave) return null;
  const hull = convexHull(xy);
  const whole = completeShell(xy);
  const isOpen = signedArea(concave) < LEAST_FILL * signedArea(whole ?? hull);
  if (isOpen && whole) return { ring: whole, isOpen };
  const epsilon = Math.min(options.secondaryEpsilon, Math.max(3 * noise, 0.05 * Math.sqrt(signedArea(hull))));
  const sides = simplifyRing(isOpen ? hull : concave, { epsilon, areaEpsilon: 0, passes: ['douglas-peucker'] });
  return { ring: fitSides(sides, xy, noise), isOpen };
}

/**
 * Concave outline of some points by gift opening, regularised with the tolerance of secondary boundaries.
 *
 * @param xy x, y a point, m
 * @returns null when the points enclose no area
 */
export function outlinePoints(xy: Float64Array, options: Options, context: StageContext): Ring | null {
  const ring = concaveRing(xy, options, context);
  return ring && simplifyRing(ring, passesFor(options));
}

function concaveRing(xy: Float64Array, options: Options, context: StageContext): Ring | null {
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

function passesFor(options: Options) {
  const { secondaryEpsilon: epsilon, visvalingamEpsilon } = options;
  const areaEpsilon = visvalingamEpsilon === 'auto' ? epsilon ** 2 : visvalingamEpsilon;
  return { epsilon, areaEpsilon, passes: passesOf(options) };
}

function squaredExtent(ring: Ring): number {
  let squared = 0;
  for (let i = 2; i < ring.length; i += 2) {
    squared = Math.max(squared, (ring[i] - ring[0]) ** 2 + (ring[i + 1] - ring[1]) ** 2);
  }
  return squared;
}
