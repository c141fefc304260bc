import { DEVIATION_BY_MEDIAN, sampledMedian } from '../robust-scale.ts';
import type { PointCloud } from '../types.ts';
import type { HeightColumns } from './height-columns.ts';

const FIT_ROUNDS = 8;
/** Tukey's biweight: residuals past so many deviations count nothing, but those within LEAST_REACH, m, do. */
const TUKEY = 4;
const LEAST_REACH = 0.012;
const FIRST_NOISE = 0.012;
const LEAST_NOISE = 0.0005;

/** A circle in the plan, m. */
export interface Circle {
  readonly cx: number;
  readonly cy: number;
  readonly radius: number;
}

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

/** Circle of least squares of squared distances through weighted points ([Kåsa76]); null where they lie in a line. */
export function circleThrough(
  xs: ArrayLike<number>,
  ys: ArrayLike<number>,
  ws: ArrayLike<number>,
): Circle | null {
  let [sw, mx, my] = [0, 0, 0];
  for (let i = 0; i < xs.length; i++) {
    sw += ws[i];
    mx += ws[i] * xs[i];
    my += ws[i] * ys[i];
  }
  mx /= sw;
  my /= sw;
  let [xx, xy, yy, xq, yq, q] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < xs.length; i++) {
    const [x, y, w] = [xs[i] - mx, ys[i] - my, ws[i]];
    const s = x * x + y * y;
    xx += w * x * x;
    xy += w * x * y;
    yy += w * y * y;
    xq += w * x * s;
    yq += w * y * s;
    q += w * s;
  }
  const determinant = xx * yy - xy * xy;
  if (!(determinant > 1e-9 * (xx + yy) ** 2)) return null;
  const [cx, cy] = [(xq * yy - yq * xy) / (2 * determinant), (yq * xx - xq * xy) / (2 * determinant)];
  return { cx: cx + mx, cy: cy + my, radius: Math.sqrt(cx * cx + cy * cy + q / sw) };
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
    const reach = Math.max(LEAST_REACH, TUKEY * noise);
    const normal = new Float64Array(9);
    let count = 0;
    for (const c of arc.members) {
      for (let k = start[c]; k < start[c + 1]; k++) {
        const [dx, dy] = [positions[3 * points[k]] - cx, positions[3 * points[k] + 1] - cy];
        const distance = Math.hypot(dx, dy);
        const residual = distance - radius;
        if (Math.abs(residual) >= reach) continue;
        rest[count++] = Math.abs(residual);
        const w = (1 - (residual / reach) ** 2) ** 2;
        accumulate(normal, dx / distance, dy / distance, residual, w);
      }
    }
    const step = count > 10 ? solve(normal) : null;
    if (step === null) return null;
    cx += step[0];
    cy += step[1];
    radius += step[2];
    noise = Math.max(LEAST_NOISE, DEVIATION_BY_MEDIAN * sampledMedian(rest, count));
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
