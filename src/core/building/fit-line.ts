import { DEVIATION_BY_MEDIAN, sampledMedian } from '../robust-scale.ts';
import type { PointCloud } from '../types.ts';
import { alongOf, type Face, type Line } from './face.ts';
import type { HeightColumns } from './height-columns.ts';

const FIT_ROUNDS = 4;
/** Tukey's biweight: residuals past so many deviations count nothing … */
const TUKEY = 4;
/** … but those within this always do, m: half the step between a wall and its skirting. */
const LEAST_REACH = 0.012;
/** Deviation to start with, m. */
const FIRST_NOISE = 0.012;
/** Smallest deviation told, m: what a made-up cloud without noise has. */
const LEAST_NOISE = 0.0005;

/** The line through the points of a line's columns, by iteratively reweighted least squares with Tukey's biweight ([Beaton74]). O(points). */
export function fitLine(cloud: PointCloud, columns: HeightColumns, line: Line): Face | null {
  const { positions } = cloud;
  const { points, start } = columns;
  const [x0, y0] = [line.nx * line.offset, line.ny * line.offset];
  let size = 0;
  for (const c of line.members) size += start[c + 1] - start[c];
  const xs = new Float64Array(size);
  const ys = new Float64Array(size);
  let n = 0;
  for (const c of line.members) {
    for (let k = start[c]; k < start[c + 1]; k++, n++) {
      xs[n] = positions[3 * points[k]] - x0;
      ys[n] = positions[3 * points[k] + 1] - y0;
    }
  }
  let [nx, ny, offset, noise] = [line.nx, line.ny, 0, FIRST_NOISE];
  const rest = new Float64Array(size);
  let support = 0;
  for (let round = 0; round < FIT_ROUNDS; round++) {
    const reach = Math.max(LEAST_REACH, TUKEY * noise);
    let [sw, sx, sy, xx, xy, yy] = [0, 0, 0, 0, 0, 0];
    for (let i = 0; i < n; i++) {
      const share = (xs[i] * nx + ys[i] * ny - offset) / reach;
      if (share >= 1 || share <= -1) continue;
      const w = (1 - share * share) ** 2;
      sw += w;
      sx += w * xs[i];
      sy += w * ys[i];
      xx += w * xs[i] * xs[i];
      xy += w * xs[i] * ys[i];
      yy += w * ys[i] * ys[i];
    }
    if (sw === 0) return null;
    const [mx, my] = [sx / sw, sy / sw];
    const tangent = 0.5 * Math.atan2(2 * (xy / sw - mx * my), xx / sw - mx * mx - (yy / sw - my * my));
    const sign = -Math.sin(tangent) * nx + Math.cos(tangent) * ny < 0 ? -1 : 1;
    [nx, ny] = [-sign * Math.sin(tangent), sign * Math.cos(tangent)];
    offset = mx * nx + my * ny;
    support = 0;
    for (let i = 0; i < n; i++) {
      const residual = Math.abs(xs[i] * nx + ys[i] * ny - offset);
      if (residual < reach) rest[support++] = residual;
    }
    noise = Math.max(LEAST_NOISE, DEVIATION_BY_MEDIAN * sampledMedian(rest, support));
  }
  const whole = offset + x0 * nx + y0 * ny;
  return { ...line, nx, ny, offset: whole, noise, support, ...reachOf(columns, line.members, { nx, ny }) };
}

/** How far columns reach along a line. */
export function reachOf(
  { centres, size }: HeightColumns,
  members: readonly number[],
  line: Pick<Line, 'nx' | 'ny'>,
): Pick<Line, 'from' | 'to'> {
  let [from, to] = [Infinity, -Infinity];
  for (const c of members) {
    const along = alongOf(line, centres[2 * c], centres[2 * c + 1]);
    from = Math.min(from, along);
    to = Math.max(to, along);
  }
  return { from: from - size / 2, to: to + size / 2 };
}
