import type { Circle } from '../../geometry/circle.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { biweight, FIRST_NOISE, noiseOf, reachOfNoise } from './biweight.ts';

const FIT_ROUNDS = 8;
const CIRCLE_ROUNDS = 4;

/** A run of columns along a circle; angles counter-clockwise, radians, `from` < `to`. */
export interface Arc extends Circle {
  readonly from: number;
  readonly to: number;
  readonly members: readonly number[];
}

/** An arc fitted to points. */
export interface CurvedFace extends Arc {
  /** Its columns tell for sure that it is a wall; others are furniture mostly. */
  readonly isSure: boolean;
  /** Standard deviation of its points across it, m. */
  readonly noise: number;
}

/** The circle through the points of an arc's columns, by Gauss-Newton steps with Tukey's biweight. O(points). */
export function fitArc(cloud: PointCloud, { points, start }: HeightColumns, arc: Arc): CurvedFace | null {
  const { positions } = cloud;
  let { cx, cy, radius } = arc;
  let noise = FIRST_NOISE;
  let size = 0;
  for (const c of arc.members) size += start[c + 1] - start[c];
  const rest = new Float64Array(size);
  for (let round = 0; round < FIT_ROUNDS; round++) {
    const reach = reachOfNoise(noise);
    const normal = new Float64Array(9);
    let count = 0;
    for (const c of arc.members) {
      for (let k = start[c]; k < start[c + 1]; k++) {
        const [dx, dy] = [positions[3 * points[k]] - cx, positions[3 * points[k] + 1] - cy];
        const distance = Math.hypot(dx, dy);
        const residual = distance - radius;
        if (Math.abs(residual) >= reach) continue;
        rest[count++] = Math.abs(residual);
        accumulate(normal, dx / distance, dy / distance, residual, biweight(residual / reach));
      }
    }
    const step = count > 10 ? solve(normal) : null;
    if (step === null) return null;
    cx += step[0];
    cy += step[1];
    radius += step[2];
    noise = noiseOf(rest, count);
  }
  return { ...arc, cx, cy, radius, noise, isSure: false };
}

/** The circle nearest to columns by their hits, which least squares of squared distances draws too small. O(members). */
export function nearestCircle(columns: HeightColumns, members: readonly number[], start: Circle): Circle {
  const { centres, hits } = columns;
  let { cx, cy, radius } = start;
  for (let round = 0; round < CIRCLE_ROUNDS; round++) {
    const normal = new Float64Array(9);
    for (const c of members) {
      const [dx, dy] = [centres[2 * c] - cx, centres[2 * c + 1] - cy];
      const distance = Math.hypot(dx, dy);
      if (distance > 0) accumulate(normal, dx / distance, dy / distance, distance - radius, hits[c]);
    }
    const step = solve(normal);
    if (step === null) break;
    cx += step[0];
    cy += step[1];
    radius += step[2];
  }
  return { cx, cy, radius };
}

/** How far columns reach around a circle: all of it but the widest gap between them. */
export function reachAround(
  { centres, size }: HeightColumns,
  members: readonly number[],
  { cx, cy, radius }: Circle,
): Pick<Arc, 'from' | 'to'> {
  const angles = Float64Array.from(members, (c) =>
    Math.atan2(centres[2 * c + 1] - cy, centres[2 * c] - cx),
  ).sort();
  const last = angles.length - 1;
  let [from, widest] = [angles[0], angles[0] + 2 * Math.PI - angles[last]];
  for (let i = 0; i < last; i++) {
    const gap = angles[i + 1] - angles[i];
    if (gap > widest) [from, widest] = [angles[i + 1], gap];
  }
  const half = Math.min(size, widest * radius) / 2 / radius;
  return { from: from - half, to: from + 2 * Math.PI - widest + half };
}

/** Sums of the normal equations for a shift of the centre along (ux, uy) and a change of radius. */
function accumulate(n: Float64Array, ux: number, uy: number, residual: number, w: number): void {
  n[0] += w * ux * ux;
  n[1] += w * ux * uy;
  n[2] += w * ux;
  n[3] += w * uy * uy;
  n[4] += w * uy;
  n[5] += w;
  n[6] += w * ux * residual;
  n[7] += w * uy * residual;
  n[8] += w * residual;
}

/** Cramer's rule on the symmetric 3 × 3 system. */
function solve([a, b, c, d, e, f, p, q, r]: Float64Array): readonly [number, number, number] | null {
  const determinant = a * (d * f - e * e) - b * (b * f - e * c) + c * (b * e - d * c);
  if (Math.abs(determinant) < 1e-12 * f ** 3) return null;
  return [
    (p * (d * f - e * e) - b * (q * f - e * r) + c * (q * e - d * r)) / determinant,
    (a * (q * f - r * e) - p * (b * f - e * c) + c * (b * r - q * c)) / determinant,
    (a * (d * r - e * q) - b * (b * r - q * c) + p * (b * e - d * c)) / determinant,
  ];
}
