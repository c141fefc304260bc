import type { StageContext } from '../context.ts';
import { convexHull } from '../geometry/convex-hull.ts';
import { signedArea } from '../geometry/rings.ts';
import type { Options } from '../params.ts';
import { restoreCorners } from '../regularise/restore-corners.ts';
import { simplifyRing } from '../regularise/simplify-ring.ts';
import type { Ring, Slice } from '../types.ts';
import { completeShell } from './complete-shell.ts';
import { concaveRing } from './outline-points.ts';

/**
 * A concave outline with less than this share of the area of its convex hull fell in through a side no scanner
 * saw.
 */
const LEAST_FILL = 0.5;
/** Sides may leave the points by so many deviations of the noise … */
const LOOSENESS_DEVIATIONS = 3;
/** … or by this share of the structure's size: more would make a square of a circle. */
const LOOSENESS = 0.05;

export interface StructureOutline {
  /** Simple, counter-clockwise. */
  readonly outline: Ring;
  /** How a side that was not seen was made up: none was, by the circle or rectangle of the others, by the convex hull. */
  readonly completion: 'none' | 'shape' | 'hull';
}

/**
 * Outer face of a structure that stands free: its concave outline, sides laid through the middle of their points; when
 * one side was not seen, the circle or rectangle the points lie on, else their convex hull.
 *
 * `secondaryEpsilon` is the tolerance of the sides, unless the structure is too small for it.
 *
 * @param points of the structure; spacing of the slice
 * @param noise standard deviation of points across a face, m
 * @returns null when the points enclose no area
 */
export function outlineStructure(
  points: Pick<Slice, 'xy' | 'spacing'>,
  noise: number,
  options: Options,
  context: StageContext,
): StructureOutline | null {
  const { xy } = points;
  // The primary boundary's opening length, if a person set one, fits rooms.
  const concave = concaveRing(xy, { ...options, openingLength: 'auto' }, context);
  if (!concave) return null;
  const hull = convexHull(xy);
  const whole = completeShell(xy);
  const isOpen = signedArea(concave) < LEAST_FILL * signedArea(whole ?? hull);
  if (isOpen && whole) return { outline: whole, completion: 'shape' };
  const loose = Math.max(LOOSENESS_DEVIATIONS * noise, LOOSENESS * Math.sqrt(signedArea(hull)));
  const epsilon = Math.min(options.secondaryEpsilon, loose);
  const outer = isOpen ? hull : concave;
  const sides = simplifyRing(outer, { epsilon, areaEpsilon: 0, passes: ['douglas-peucker'] });
  const [outline] = restoreCorners([sides], [outer], points, { bandwidth: noise });
  return { outline, completion: isOpen ? 'hull' : 'none' };
}
