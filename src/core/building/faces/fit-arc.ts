import type { Circle } from '../../geometry/circle.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { biweight, FIRST_NOISE, noiseOf, reachOfNoise } from './biweight.ts';

const FIT_ROUNDS = 8;

/** A run of columns along a circle; angles counter-clockwise, radians, `from` < `to`. */
export interface Arc extends Circle {
  readonly from: number;
  readonly to: number;
  readonly members: readonly number[];
}

/** An arc fitted to points. */
export interface CurvedFace extends Arc {
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
  return { ...arc, cx, cy, radius, noise };
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
