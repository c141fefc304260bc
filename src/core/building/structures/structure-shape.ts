import { circleRing, circleThrough, offCircle } from '../../geometry/circle.ts';
import { medianOf } from '../../robust-scale.ts';
import type { Ring } from '../../types.ts';

/** Points lie on a shape when they are this share of its size off it, root mean square, or so many deviations of their noise. */
const LOOSENESS = 0.05;
const NOISES = 2;
/** A circle's points see this share of it at least: less bends too little to tell its radius. */
const LEAST_ARC = 0.3;
/** A rectangle narrower than this, m, is a face or a pipe … */
export const THINNEST = 0.15;
/** … unless it is so many deviations of noise wide: then it is the bend of a circle. */
const BEND_NOISES = 4;
/** Directions of a rectangle tried over a quarter turn, then around the best, radians. */
const TURNS = 36;
const FINE_TURNS = 8;
/** Share of the points beyond each end of a box that may be stray. */
const STRAY = 0.02;
/** A side is settled where this share of all points is nearest to it, so often. */
const LEAST_SHARE = 0.05;
const SETTLINGS = 3;
/** Points that a shape is fitted to, at most. */
const SAMPLE = 600;
/** Bits of a side, m, and share of those in its middle part that have points where it was seen. */
const BIT = 0.05;
const MIDDLE = 0.7;
const LEAST_SEEN = 0.6;

/** A rectangle by its sides along and across a unit direction, m. */
export interface Rectangle {
  readonly ux: number;
  readonly uy: number;
  /** Least along, greatest along, least across, greatest across. */
  readonly sides: readonly [number, number, number, number];
}

/** What the points of a structure's faces lie on. */
export interface StructureShape {
  readonly outline: Ring;
  /** Null of a circle. */
  readonly rectangle: Rectangle | null;
  /** Whether each side of the rectangle was seen, in the order of its sides. */
  readonly seen: readonly boolean[];
}

/**
 * The circle or rectangle that points scatter about; null where neither explains them.
 *
 * Ours. Sides run through the median of their points, so that noise does not widen them as a box around all would; a side
 * that was not seen is where its neighbours end. Circle by [Kåsa76]. O(points).
 *
 * @param xy x, y a point, m
 * @param noise standard deviation of points across a face, m
 */
export function structureShape(xy: Float64Array, noise: number): StructureShape | null {
  const points = sampled(xy);
  const circle = wholeCircle(points, noise);
  const { rectangle, rms } = bestRectangle(points);
  const [a, b] = sizeOf(rectangle);
  const isLoose = rms > Math.max(LOOSENESS * Math.min(a, b), NOISES * noise);
  const isBent = Math.min(a, b) < THINNEST && Math.min(a, b) > BEND_NOISES * noise;
  if (circle && (isLoose || isBent || circle.rms <= rms))
    return { outline: circle.outline, rectangle: null, seen: [] };
  if (isLoose) return null;
  return { outline: ringOf(rectangle), rectangle, seen: seenSides(xy, rectangle, noise) };
}

/** Its length along and across, m. */
export function sizeOf({ sides: [left, right, low, high] }: Rectangle): readonly [number, number] {
  return [right - left, high - low];
}

/** Counter-clockwise. */
export function ringOf({ ux, uy, sides: [left, right, low, high] }: Rectangle): Ring {
  const corners = [
    [left, low],
    [right, low],
    [right, high],
    [left, high],
  ];
  return Float64Array.from(corners.flatMap(([a, b]) => [a * ux - b * uy, a * uy + b * ux]));
}

function sampled(xy: Float64Array): Float64Array {
  const count = xy.length / 2;
  const step = Math.max(1, count / SAMPLE);
  const taken = Math.floor(count / step);
  return Float64Array.from({ length: 2 * taken }, (_, i) => xy[2 * Math.floor((i >> 1) * step) + (i & 1)]);
}

function wholeCircle(xy: Float64Array, noise: number): { outline: Ring; rms: number } | null {
  const circle = circleThrough(xy);
  if (!circle) return null;
  const { rms, arc } = offCircle(xy, circle);
  if (arc < LEAST_ARC || rms > Math.max(LOOSENESS * circle.radius, NOISES * noise)) return null;
  return { outline: circleRing(circle), rms };
}

/** A rectangle and how far points scatter about it, m root mean square. */
interface Fit {
  readonly rectangle: Rectangle;
  readonly rms: number;
}

function bestRectangle(xy: Float64Array): Fit {
  const step = Math.PI / 2 / TURNS;
  const bestOf = (angles: readonly number[]) => {
    const fits = angles.map((angle) => ({ angle, fit: rectangleAt(xy, angle) }));
    return fits.reduce((best, other) => (other.fit.rms < best.fit.rms ? other : best));
  };
  const coarse = bestOf(Array.from({ length: TURNS }, (_, k) => k * step));
  const around = Array.from({ length: 2 * FINE_TURNS + 1 }, (_, k) => k / FINE_TURNS - 1);
  return bestOf(around.map((k) => coarse.angle + k * step)).fit;
}

function rectangleAt(xy: Float64Array, angle: number): Fit {
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const count = xy.length / 2;
  const along = Float64Array.from({ length: count }, (_, i) => xy[2 * i] * ux + xy[2 * i + 1] * uy);
  const across = Float64Array.from({ length: count }, (_, i) => xy[2 * i + 1] * ux - xy[2 * i] * uy);
  let sides = [...rangeOf(along), ...rangeOf(across)] as [number, number, number, number];
  let squares = 0;
  for (let round = 0; round <= SETTLINGS; round++) {
    const own: number[][] = [[], [], [], []];
    squares = 0;
    for (let i = 0; i < count; i++) {
      const side = nearestSide(sides, along[i], across[i]);
      const at = side < 2 ? along[i] : across[i];
      own[side].push(at);
      squares += (at - sides[side]) ** 2;
    }
    if (round === SETTLINGS) break;
    sides = sides.map((at, k) =>
      own[k].length >= LEAST_SHARE * count ? medianOf(Float64Array.from(own[k])) : at,
    ) as [number, number, number, number];
  }
  return { rectangle: { ux, uy, sides }, rms: Math.sqrt(squares / count) };
}

function rangeOf(values: Float64Array): readonly [number, number] {
  const sorted = Float64Array.from(values).sort();
  const stray = Math.floor(STRAY * sorted.length);
  return [sorted[stray], sorted[sorted.length - 1 - stray]];
}

function nearestSide(sides: Rectangle['sides'], along: number, across: number): number {
  let [best, least] = [0, Infinity];
  for (let k = 0; k < 4; k++) {
    const away = Math.abs((k < 2 ? along : across) - sides[k]);
    if (away < least) [best, least] = [k, away];
  }
  return best;
}

function seenSides(xy: Float64Array, { ux, uy, sides }: Rectangle, noise: number): boolean[] {
  const reach = Math.max(BIT / 2, 3 * noise);
  const bits = [0, 1, 2, 3].map((k) => {
    const [from, to] = k < 2 ? [sides[2], sides[3]] : [sides[0], sides[1]];
    const begin = from + ((1 - MIDDLE) / 2) * (to - from);
    const count = Math.max(1, Math.round((MIDDLE * (to - from)) / BIT));
    return { begin, step: (MIDDLE * (to - from)) / count, isHit: new Uint8Array(count) };
  });
  for (let i = 0; i < xy.length; i += 2) {
    const [along, across] = [xy[i] * ux + xy[i + 1] * uy, xy[i + 1] * ux - xy[i] * uy];
    const k = nearestSide(sides, along, across);
    if (Math.abs((k < 2 ? along : across) - sides[k]) > reach) continue;
    const at = Math.floor(((k < 2 ? across : along) - bits[k].begin) / bits[k].step);
    if (at >= 0 && at < bits[k].isHit.length) bits[k].isHit[at] = 1;
  }
  return bits.map(({ isHit }) => isHit.reduce((sum, hit) => sum + hit, 0) >= LEAST_SEEN * isHit.length);
}
