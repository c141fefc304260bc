import { FEWEST, LOOK_TO, STEP } from './wall-look.ts';
import type { WallStrip } from './wall-strip.ts';

/** Reach around the end of a void in which its jamb is looked for, m. */
export const JAMB_REACH = 0.15;
/** Width of a jamb's points along the wall, m. */
const JAMB_WIDTH = 0.06;
/** Bits of height in which a jamb is seen, m. */
const JAMB_STEP = 2 * STEP;
/** A jamb is seen over at least this height, m, no higher than so far above eye height: lintels begin there. */
const LEAST_JAMB = 0.4;
const ABOVE_LOOK = 0.1;

/** A jamb reaches up to this height above the floor, m: what ends below is the wall under a sill, seen from outside, too. */
const LEAST_TOP = 1.2;

/**
 * The most heights of those that follow each other with one missing at most, up to eye height: stray points above and below a
 * sill are no jamb.
 */
function longestRun(heights: ReadonlyMap<number, number>): number {
  if (heights.size * JAMB_STEP < LEAST_JAMB) return 0;
  let [run, longest, last] = [0, 0, Number.NEGATIVE_INFINITY];
  for (const height of [...heights.keys()].sort((a, b) => a - b)) {
    run = height - last <= 2 ? run + 1 : 1;
    if (height * JAMB_STEP >= LEAST_TOP) longest = Math.max(longest, run);
    last = height;
  }
  return longest;
}

/** Places along a void where reveals stand upright, in order. O(points · log points). */
export function jambsIn(strip: WallStrip, reveals: readonly number[]): number[] {
  const below = reveals.filter((i) => strip.high[i] < LOOK_TO + ABOVE_LOOK);
  const order = below.sort((i, j) => strip.along[i] - strip.along[j]);
  const sorted = Float64Array.from(order, (i) => strip.along[i]);
  const step = (k: number) => Math.floor(strip.high[order[k]] / JAMB_STEP);
  // Points at each height within the window that ends at the point looked at.
  const heights = new Map<number, number>();
  const found: { at: number; weight: number }[] = [];
  let low = 0;
  for (let k = 0; k < sorted.length; k++) {
    heights.set(step(k), (heights.get(step(k)) ?? 0) + 1);
    for (; sorted[k] - sorted[low] > JAMB_WIDTH; low++) {
      const rest = heights.get(step(low))! - 1;
      if (rest > 0) heights.set(step(low), rest);
      else heights.delete(step(low));
    }
    const count = k + 1 - low;
    if (count < FEWEST || longestRun(heights) * JAMB_STEP < LEAST_JAMB) continue;
    found.push({ at: sorted[low + (count >> 1)], weight: heights.size + count / 1000 });
  }
  found.sort((a, b) => b.weight - a.weight);
  const kept: number[] = [];
  for (const { at } of found) if (kept.every((other) => Math.abs(other - at) > JAMB_REACH)) kept.push(at);
  return kept.sort((a, b) => a - b);
}
