import type { Ring } from '../types.ts';
import type { Strip } from './strip-points.ts';

/**
 * The strip along a stretch of hull, a little shorter than the stretch and `reach` deeper.
 *
 * It lies along the whole stretch: its ends, outermost of the noise, may lie askew to it.
 *
 * @param chain x, y a vertex, at least two; its left is the room
 * @param margin what is left out at both ends, m: there the neighbours' points begin
 * @param reach how far the points go on behind the innermost vertex, m
 * @returns null when the ends are no guide to the direction of what is between
 */
export function stripAlong(chain: Float64Array, margin: number, reach: number): Strip | null {
  const last = chain.length - 2;
  const [ax, ay, bx, by] = [chain[0], chain[1], chain[last], chain[last + 1]];
  const [x, y, ux, uy] = lineThrough(chain);
  const start = (ax - x) * ux + (ay - y) * uy;
  const end = (bx - x) * ux + (by - y) * uy;
  if (end - start < Math.hypot(bx - ax, by - ay) / 2) return null;
  let [low, high] = [0, 0];
  for (let k = 0; k < chain.length; k += 2) {
    const across = (chain[k + 1] - y) * ux - (chain[k] - x) * uy;
    low = Math.min(low, across);
    high = Math.max(high, across);
  }
  const indent = Math.min(margin, (end - start) / 4);
  return { x, y, ux, uy, along: [start + indent, end - indent], across: [low, high + reach] };
}

/** The stretch of a ring from one vertex on to another, x, y a vertex. */
export function chainBetween(ring: Ring, from: number, to: number): Float64Array {
  const n = ring.length / 2;
  const steps = (to - from + n) % n;
  const chain = new Float64Array(2 * steps + 2);
  for (let k = 0; k <= steps; k++) {
    const v = (from + k) % n;
    chain[2 * k] = ring[2 * v];
    chain[2 * k + 1] = ring[2 * v + 1];
  }
  return chain;
}

/** Middle and unit direction of a chain from its first to its last vertex, by total least squares over its length. */
function lineThrough(chain: Float64Array): readonly [x: number, y: number, ux: number, uy: number] {
  const [x0, y0] = chain;
  let [sum, sumX, sumY, sumXX, sumXY, sumYY] = [0, 0, 0, 0, 0, 0];
  for (let k = 0; k + 3 < chain.length; k += 2) {
    const [dx, dy] = [chain[k + 2] - chain[k], chain[k + 3] - chain[k + 1]];
    const [x, y] = [chain[k] + dx / 2 - x0, chain[k + 1] + dy / 2 - y0];
    const weight = Math.hypot(dx, dy);
    sum += weight;
    sumX += weight * x;
    sumY += weight * y;
    // A twelfth: the variance of a uniform stretch about its middle.
    sumXX += weight * (x * x + (dx * dx) / 12);
    sumXY += weight * (x * y + (dx * dy) / 12);
    sumYY += weight * (y * y + (dy * dy) / 12);
  }
  const [x, y] = [sumX / sum, sumY / sum];
  const angle = Math.atan2(2 * (sumXY / sum - x * y), sumXX / sum - x * x - (sumYY / sum - y * y)) / 2;
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const last = chain.length - 2;
  const sign = ux * (chain[last] - x0) + uy * (chain[last + 1] - y0) < 0 ? -1 : 1;
  return [x0 + x, y0 + y, sign * ux, sign * uy];
}
