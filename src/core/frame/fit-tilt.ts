import { DEVIATION_BY_MEDIAN, medianOf } from '../robust-scale.ts';
import type { Vec3 } from '../types.ts';
import { alignment, type HeightPlane, heightsAlong } from './height-planes.ts';
import { multiply, type Rotation, rotate, rotationToZ } from './rotation.ts';
import type { SurfacePatches } from './surface-patches.ts';

/** A tilt that leans a 3 m wall by less than 5 mm hides in scan noise and is left alone. */
const LEAST_TILT = (0.1 * Math.PI) / 180;
/** Past this the scan is not "nearly upright": a person must say what is up. */
export const MOST_TILT = (15 * Math.PI) / 180;
/** Standard errors a slope must be away from zero. */
const SIGNIFICANT = 4;
/** Patches further than this many deviations from the plane are not part of it. */
const CUT = 3;
const ROUNDS = 6;
const CONE_COSINE = Math.cos((8 * Math.PI) / 180);
const WALL_COSINE = 0.3;
const FEWEST_PATCHES = 6;
/** Residuals below this share of a patch edge are rounding. */
const ROUNDING = 1e-6;

/** A plane fitted across a cloud. */
interface FittedPlane {
  /** Unit normal in plan axes, up. */
  readonly normal: Vec3;
  /** Standard error of its slope, radians. */
  readonly error: number;
}

/**
 * The true up of a tilted cloud from its floor or its ceiling, or null where it stands level already.
 *
 * Least squares through patch centroids, those far off cut in rounds; of the two the one counts that makes the walls more
 * upright, for the ground outside may lie beside the floor. The tilt must exceed the error of the fit and must make the
 * walls more upright than they are, so that a ramp or a sloped ceiling does not tilt a level scan. O(patches).
 *
 * @param upright rotation to plan axes without levelling
 * @param normal estimate of up, source axes
 * @param levels floor and ceiling along `normal`, those that were found
 * @returns unit vector, plan axes
 */
export function fitTilt(
  patches: SurfacePatches,
  upright: Rotation,
  normal: Vec3,
  levels: readonly HeightPlane[],
): Vec3 | null {
  const lean = (up: Vec3) => wallLean(patches, upright, up);
  const [fitted] = levels
    .flatMap((plane) => fitPlane(patches, upright, normal, plane) ?? [])
    .sort((a, b) => lean(a.normal) - lean(b.normal));
  if (!fitted) return null;
  const tilt = Math.hypot(fitted.normal[0], fitted.normal[1]);
  if (tilt < Math.max(LEAST_TILT, SIGNIFICANT * fitted.error)) return null;
  return lean(fitted.normal) <= lean([0, 0, 1]) ? fitted.normal : null;
}

function fitPlane(
  patches: SurfacePatches,
  upright: Rotation,
  normal: Vec3,
  { height }: HeightPlane,
): FittedPlane | null {
  const heights = heightsAlong(patches, normal);
  // In axes where the estimate is up, the plane is z = slope · (x, y) + offset with a slope near 0.
  const local = multiply(rotationToZ(rotate(upright, normal)), upright);
  const points: number[] = [];
  for (let i = 0; i < patches.count; i++) {
    if (Math.abs(heights[i] - height) > patches.size) continue;
    if (Math.abs(alignment(patches, i, normal)) < CONE_COSINE) continue;
    const at = 3 * i;
    points.push(
      ...rotate(local, [patches.centroids[at], patches.centroids[at + 1], patches.centroids[at + 2]]),
    );
  }
  const fit = robustSlopes(Float64Array.from(points), ROUNDING * patches.size);
  if (!fit) return null;
  const length = Math.hypot(fit.slopeX, fit.slopeY, 1);
  const inLocal: Vec3 = [-fit.slopeX / length, -fit.slopeY / length, 1 / length];
  const back = rotationToZ(rotate(upright, normal));
  return { normal: rotate(transpose(back), inLocal), error: fit.error };
}

function transpose(r: Rotation): Rotation {
  return [r[0], r[3], r[6], r[1], r[4], r[7], r[2], r[5], r[8]];
}

/** z = slopeX · x + slopeY · y + offset, by least squares in rounds that cut what lies far off. */
function robustSlopes(
  points: Float64Array,
  leastLimit: number,
): { slopeX: number; slopeY: number; error: number } | null {
  const count = points.length / 3;
  let limit = Infinity;
  let fit: PlaneSums | null = null;
  const residuals = new Float64Array(count);
  for (let round = 0; round < ROUNDS; round++) {
    const next = leastSquares(points, residuals, limit);
    if (!next) return null;
    fit = next;
    for (let i = 0; i < count; i++) {
      const z = fit.offset + fit.slopeX * points[3 * i] + fit.slopeY * points[3 * i + 1];
      residuals[i] = Math.abs(points[3 * i + 2] - z);
    }
    limit = Math.max(leastLimit, CUT * DEVIATION_BY_MEDIAN * medianOf(residuals.slice()));
  }
  if (!fit) return null;
  let squares = 0;
  let used = 0;
  for (const residual of residuals) {
    if (residual > limit) continue;
    squares += residual ** 2;
    used++;
  }
  const error = Math.sqrt(squares / Math.max(1, used - 3) / fit.leastSpread);
  return { slopeX: fit.slopeX, slopeY: fit.slopeY, error };
}

interface PlaneSums {
  readonly slopeX: number;
  readonly slopeY: number;
  readonly offset: number;
  /** Smallest second moment of the points seen from above. */
  readonly leastSpread: number;
}

function leastSquares(points: Float64Array, residuals: Float64Array, limit: number): PlaneSums | null {
  let [n, mx, my, mz] = [0, 0, 0, 0];
  for (let i = 0; i < residuals.length; i++) {
    if (residuals[i] > limit) continue;
    n++;
    mx += points[3 * i];
    my += points[3 * i + 1];
    mz += points[3 * i + 2];
  }
  if (n < FEWEST_PATCHES) return null;
  [mx, my, mz] = [mx / n, my / n, mz / n];
  let [xx, xy, yy, xz, yz] = [0, 0, 0, 0, 0];
  for (let i = 0; i < residuals.length; i++) {
    if (residuals[i] > limit) continue;
    const [x, y, z] = [points[3 * i] - mx, points[3 * i + 1] - my, points[3 * i + 2] - mz];
    xx += x * x;
    xy += x * y;
    yy += y * y;
    xz += x * z;
    yz += y * z;
  }
  const determinant = xx * yy - xy * xy;
  if (determinant <= Number.EPSILON * xx * yy) return null;
  const slopeX = (xz * yy - yz * xy) / determinant;
  const slopeY = (yz * xx - xz * xy) / determinant;
  const leastSpread = (xx + yy - Math.hypot(xx - yy, 2 * xy)) / 2;
  return { slopeX, slopeY, offset: mz - slopeX * mx - slopeY * my, leastSpread };
}

/** Sum of the leans of the wall patches against `up` (plan axes), as sines. */
function wallLean({ count, normals }: SurfacePatches, upright: Rotation, up: Vec3): number {
  let sum = 0;
  for (let i = 0; i < count; i++) {
    const normal = rotate(upright, [normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]]);
    if (Math.abs(normal[2]) > WALL_COSINE) continue;
    sum += Math.abs(normal[0] * up[0] + normal[1] * up[1] + normal[2] * up[2]);
  }
  return sum;
}
