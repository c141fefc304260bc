import { medianOf } from '../../robust-scale.ts';
import { FEWEST, LOOK_FROM, LOOK_TO, STEP, type Stretch } from './wall-look.ts';
import type { WallStrip } from './wall-strip.ts';

/** Heads and sills may reach so far into the heights looked at, m. */
const INTO_LOOK = 0.05;
/** A sill or a head is level within this, m … */
const LEVEL_REACH = 0.03;
/** … and seen over this share of the width. */
export const LEVEL_SHARE = 0.4;
/** Sill or head go on over breaks up to this, m … */
const LEVEL_BREAK = 0.25;
/** … and are told from chance by this length, m. */
const LEAST_LEVEL = 0.4;

/** Heights above the floor, m, of the head and the sill that reveals show; null where they show none. */
export function revealLevels(
  strip: WallStrip,
  reveals: readonly number[],
  { begin, end }: Stretch,
): { readonly head: number | null; readonly sill: number | null } {
  const between = reveals.filter((i) => strip.along[i] > begin && strip.along[i] < end);
  const above = between.filter((i) => strip.high[i] > LOOK_TO - INTO_LOOK);
  const below = between.filter((i) => strip.high[i] < LOOK_FROM + INTO_LOOK);
  return { head: levelOf(strip, above, end - begin), sill: levelOf(strip, below, end - begin) };
}

/**
 * How far from one end of a void its sill or its head was seen, m; null where neither was, over enough of a length.
 *
 * @param way 1 from the beginning on, −1 from the end back
 */
export function levelReach(
  strip: WallStrip,
  reveals: readonly number[],
  { begin, end }: Stretch,
  way: 1 | -1,
): number | null {
  const past = (i: number) => (way === 1 ? strip.along[i] - begin : end - strip.along[i]);
  const own = reveals.filter((i) => strip.along[i] > begin && strip.along[i] < end);
  const groups = [
    own.filter((i) => strip.high[i] > LOOK_TO - INTO_LOOK),
    own.filter((i) => strip.high[i] < LOOK_FROM + INTO_LOOK),
  ];
  const reaches = groups.map((points) => {
    const near = points.filter((i) => past(i) < LEAST_LEVEL);
    if (near.length < FEWEST) return 0;
    const level = densest(near.map((i) => strip.high[i]));
    const on = points.filter((i) => Math.abs(strip.high[i] - level) <= LEVEL_REACH);
    let reach = 0;
    for (const at of Float64Array.from(on, past).sort()) if (at - reach <= LEVEL_BREAK) reach = at;
    return reach;
  });
  const reach = Math.max(...reaches);
  return reach >= LEAST_LEVEL ? reach : null;
}

/** The height at which most of some points lie, if they cover enough of a width there. */
function levelOf({ along, high }: WallStrip, points: readonly number[], width: number): number | null {
  if (points.length < FEWEST) return null;
  const level = densest(points.map((i) => high[i]));
  const on = points.filter((i) => Math.abs(high[i] - level) <= LEVEL_REACH);
  const bits = new Set(on.map((i) => Math.floor(along[i] / (2 * STEP))));
  const isSeen = on.length >= FEWEST && (bits.size * 2 * STEP) / width >= LEVEL_SHARE;
  return isSeen ? medianOf(Float64Array.from(on, (i) => high[i])) : null;
}

/** Middle of the stretch of twice {@link LEVEL_REACH} that holds most values. */
function densest(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  let [best, most, low] = [sorted[0], 0, 0];
  for (let k = 0; k < sorted.length; k++) {
    while (sorted[k] - sorted[low] > 2 * LEVEL_REACH) low++;
    if (k - low + 1 > most) {
      most = k - low + 1;
      best = (sorted[k] + sorted[low]) / 2;
    }
  }
  return best;
}
