import { combine, grow } from '../../geometry/areas.ts';
import { signedArea } from '../../geometry/rings.ts';
import type { Polygon } from '../../types.ts';

/** Gaps between rooms close where they are this much narrower than the pen, m. */
const SLACK = 0.01;
/** Holes smaller than this are shafts and thick walls, not courtyards, m². */
const SMALLEST_COURTYARD = 4;
/** Vertices nearer than this to the line of their neighbours are debris of the offsets, m. */
const STRAIGHT = 0.001;

/**
 * The outline of all rooms and the walls between them: the closing of the rooms by half the thickest inner wall.
 *
 * @param thickest of the walls between rooms, m
 */
export function primaryOutline(rooms: readonly Polygon[], thickest: number): Polygon[] {
  const reach = thickest / 2 + SLACK;
  const closed = grow(grow(rooms, reach), -reach);
  return combine('union', [...closed, ...rooms]).map(({ outer, holes }) => ({
    outer: withoutDebris(outer),
    holes: holes.filter((hole) => -signedArea(hole) >= SMALLEST_COURTYARD).map(withoutDebris),
  }));
}

/** A ring without vertices that lie on the way from their neighbour to the next, or all but so: the straightest goes first. */
export function withoutDebris(ring: Float64Array): Float64Array {
  let current = ring;
  while (current.length > 8) {
    let [at, least] = [0, Infinity];
    for (let i = 0; i < current.length; i += 2) {
      const aside = asideOf(current, i);
      if (aside < least) [at, least] = [i, aside];
    }
    if (least >= STRAIGHT) break;
    current = Float64Array.from([...current.subarray(0, at), ...current.subarray(at + 2)]);
  }
  return current;
}

/** Distance of the vertex at `i` from the line through its neighbours, m. */
function asideOf(ring: Float64Array, i: number): number {
  const [p, q] = [(i + ring.length - 2) % ring.length, (i + 2) % ring.length];
  const [ux, uy] = [ring[q] - ring[p], ring[q + 1] - ring[p + 1]];
  const length = Math.hypot(ux, uy);
  return length === 0 ? 0 : Math.abs((ring[i] - ring[p]) * uy - (ring[i + 1] - ring[p + 1]) * ux) / length;
}
