import { Moments } from '../../geometry/moments.ts';
import type { PointCloud } from '../../types.ts';
import { type HeightColumns, pointsOf } from '../columns/height-columns.ts';
import { biweight, FIRST_NOISE, noiseOf, reachOfNoise } from './biweight.ts';
import { alongOf, asideOf, type Face, type Line, pointOn } from './face.ts';

const FIT_ROUNDS = 4;

/** The line through the points of a line's columns, by iteratively reweighted least squares with Tukey's biweight ([Beaton74]). O(points). */
export function fitLine(cloud: PointCloud, columns: HeightColumns, line: Line): Face | null {
  const origin = pointOn(line, 0);
  const xy = pointsOf(cloud, columns, line.members, origin);
  let fit: Fit | null = { nx: line.nx, ny: line.ny, offset: 0, noise: FIRST_NOISE, support: 0 };
  const rest = new Float64Array(xy.length / 2);
  for (let round = 0; round < FIT_ROUNDS; round++) {
    fit = refit(xy, fit, rest);
    if (fit === null) return null;
  }
  const { nx, ny, noise, support } = fit;
  const offset = fit.offset + origin[0] * nx + origin[1] * ny;
  return { ...line, nx, ny, offset, noise, support, ...reachOf(columns, line.members, fit) };
}

type Fit = Omit<Face, 'from' | 'to' | 'members'>;

/** One round: the line of total least squares, points weighted by their distance to the line before. */
function refit(xy: Float64Array, before: Fit, rest: Float64Array): Fit | null {
  const reach = reachOfNoise(before.noise);
  const moments = new Moments();
  for (let i = 0; i < xy.length; i += 2) {
    const share = asideOf(before, xy[i], xy[i + 1]) / reach;
    if (share < 1 && share > -1) moments.add(xy[i], xy[i + 1], biweight(share));
  }
  if (moments.weight === 0) return null;
  const { x, y, angle } = moments.spread();
  const sign = -Math.sin(angle) * before.nx + Math.cos(angle) * before.ny < 0 ? -1 : 1;
  const [nx, ny] = [-sign * Math.sin(angle), sign * Math.cos(angle)];
  const line = { nx, ny, offset: x * nx + y * ny };
  let support = 0;
  for (let i = 0; i < xy.length; i += 2) {
    const residual = Math.abs(asideOf(line, xy[i], xy[i + 1]));
    if (residual < reach) rest[support++] = residual;
  }
  return { ...line, noise: noiseOf(rest, support), support };
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
