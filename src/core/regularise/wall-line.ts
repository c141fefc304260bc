import { Moments } from '../geometry/moments.ts';
import { firstFace } from './face-offset.ts';
import type { Strip, StripPoints } from './strip-points.ts';

export type Point = readonly [x: number, y: number];

/** A line along a wall's face, fitted to the points an edge stands for. */
export interface WallLine {
  readonly x: number;
  readonly y: number;
  /** Unit direction, within 45° of the edge's. */
  readonly ux: number;
  readonly uy: number;
  /** Standard deviation of the face's points across the line, m. */
  readonly deviation: number;
}

/** Fewer points are no wall: a few tell little of their own noise. */
const FEWEST_POINTS = 5;
/** The points must reach over this share of the strip, else the line would be guessed beyond them. */
const LEAST_EXTENT = 0.5;
/**
 * Tukey's biweight: points farther than the cutoff do not count. 4.685 standard deviations are the usual cutoff, 95 % as
 * efficient as least squares; with it the weighted deviation of normal noise is 0.91 of the true one.
 */
const CUTOFF = 4.685;
const WEIGHTED_DEVIATION = 0.91;
/** A round that changes the cutoff by less than this share was the last, if it is not the twelfth. */
const SETTLED = 1e-3;
const MOST_ROUNDS = 12;
/** Of the bandwidth; points without noise would leave a cutoff of 0. */
const LEAST_CUTOFF = 0.01;

/** Lines that turn by less meet too far along to tell where: a gentle bend. Sine of 8°. */
const LEAST_SINE = Math.sin((8 * Math.PI) / 180);

/** A line in the frame of its strip: through a point, at an angle to the strip. */
interface Fit {
  readonly along: number;
  readonly across: number;
  readonly angle: number;
  readonly deviation: number;
}

/**
 * The line of the face an edge stands on: total least squares, reweighted by Tukey's biweight, begun at the first dense
 * face from outside, so that neither the other face of the wall nor furniture draws it inwards.
 *
 * @param points those in the strip
 * @param bandwidth m; see {@link firstFace}
 * @returns null when too few points, or too short a stretch of them, lie along the edge. O(points).
 */
export function fitWallLine(points: StripPoints, strip: Strip, bandwidth: number): WallLine | null {
  if (points.size < FEWEST_POINTS) return null;
  const face = firstFace(points.across, points.size, strip.across, bandwidth);
  if (face === null) return null;
  const [from, to] = strip.along;
  let fit: Fit | null = { along: (from + to) / 2, across: face.peak, angle: 0, deviation: 0 };
  let cutoff = 2 * bandwidth;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    fit = refit(points, fit, { cutoff, end: face.end, leastExtent: LEAST_EXTENT * (to - from) });
    if (fit === null) return null;
    const wanted = Math.max(LEAST_CUTOFF * bandwidth, Math.min(2 * bandwidth, CUTOFF * fit.deviation));
    const change = Math.abs(wanted - cutoff);
    cutoff = wanted;
    if (change < SETTLED * cutoff) break;
  }
  return inPlan(fit, strip);
}

interface Limits {
  readonly cutoff: number;
  /** Points farther across belong to another face. */
  readonly end: number;
  readonly leastExtent: number;
}

/** One round: weights by the distance to the line before, then total least squares. */
function refit(points: StripPoints, before: Fit, { cutoff, end, leastExtent }: Limits): Fit | null {
  const [cos, sin] = [Math.cos(before.angle), Math.sin(before.angle)];
  const moments = new Moments();
  let count = 0;
  let [first, last] = [Number.POSITIVE_INFINITY, Number.NEGATIVE_INFINITY];
  for (let k = 0; k < points.size; k++) {
    const a = points.along[k] - before.along;
    const b = points.across[k] - before.across;
    const distance = (b * cos - a * sin) / cutoff;
    if (distance <= -1 || distance >= 1 || points.across[k] > end) continue;
    moments.add(a, b, (1 - distance * distance) ** 2);
    count++;
    if (a < first) first = a;
    if (a > last) last = a;
  }
  if (count < FEWEST_POINTS || last - first < leastExtent) return null;
  const { x, y, angle, variance } = moments.spread();
  if (Math.abs(angle) > Math.PI / 4) return null;
  const deviation = Math.sqrt(variance) / WEIGHTED_DEVIATION;
  return { along: before.along + x, across: before.across + y, angle, deviation };
}

function inPlan({ along, across, angle, deviation }: Fit, { x, y, ux, uy }: Strip): WallLine {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return {
    x: x + along * ux - across * uy,
    y: y + along * uy + across * ux,
    ux: cos * ux - sin * uy,
    uy: cos * uy + sin * ux,
    deviation,
  };
}

/** Where two lines meet; null when they are nearly parallel. */
export function meetingOf(a: WallLine, b: WallLine): Point | null {
  const sine = a.ux * b.uy - a.uy * b.ux;
  if (Math.abs(sine) < LEAST_SINE) return null;
  const along = ((b.x - a.x) * b.uy - (b.y - a.y) * b.ux) / sine;
  return [a.x + along * a.ux, a.y + along * a.uy];
}

/** The point of a line nearest to another. */
export function projectOnto(line: WallLine, [x, y]: Point): Point {
  const across = distanceToLine(line, [x, y]);
  return [x + across * line.uy, y - across * line.ux];
}

/** Positive to the left of the line. */
export function distanceToLine({ x, y, ux, uy }: WallLine, point: Point): number {
  return (point[1] - y) * ux - (point[0] - x) * uy;
}
