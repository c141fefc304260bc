import { ringsOf } from '../core/geometry/rings.ts';
import type { Opening, Ring } from '../core/types.ts';
import type { Depth, OpeningBox } from '../solid/opening-boxes.ts';

/** The wall's depth is looked up this far within an opening, m: at its very end the wall may end as well. */
const WITHIN = 1e-2;
/** Rounding of a wall's faces, m. */
const TOUCH = 1e-3;
/** A wall that is this much deeper at one jamb than at the other has a corner or another wall there, m. */
const SAME_WALL = 0.02;

/**
 * How deep the wall is at an opening's two jambs, as it is drawn: where it runs into a corner at one of them, as deep as
 * in the middle.
 */
export function jambDepths({ opening, walls, depth }: OpeningBox): readonly [Depth, Depth] {
  const { from, to } = opening;
  const rings = ringsOf(walls);
  const within = Math.min(WITHIN / Math.hypot(to[0] - from[0], to[1] - from[1]), 0.25);
  const at = (share: number) => {
    const own = depthAcross(rings, opening, share, depth);
    return own.low < own.high ? own : depth;
  };
  const [left, right] = [at(within), at(1 - within)];
  if (Math.abs(left.low - right.low) <= SAME_WALL && Math.abs(left.high - right.high) <= SAME_WALL) {
    return [left, right];
  }
  const middle = at(0.5);
  return [middle, middle];
}

/** Where a line across the wall, at a share of an opening's axis, meets walls first and last within a depth. */
function depthAcross(walls: readonly Ring[], { from, to }: Opening, share: number, within: Depth): Depth {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  let [low, high] = [Infinity, -Infinity];
  for (const ring of walls) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const a = (ring[j] - from[0]) * ux + (ring[j + 1] - from[1]) * uy - share * length;
      const b = (ring[i] - from[0]) * ux + (ring[i + 1] - from[1]) * uy - share * length;
      if (a > 0 === b > 0) continue;
      const at = a / (a - b);
      const [x, y] = [ring[j] + at * (ring[i] - ring[j]), ring[j + 1] + at * (ring[i + 1] - ring[j + 1])];
      const aside = (y - from[1]) * ux - (x - from[0]) * uy;
      if (aside < within.low - TOUCH || aside > within.high + TOUCH) continue;
      [low, high] = [Math.min(low, aside), Math.max(high, aside)];
    }
  }
  return { low, high };
}
