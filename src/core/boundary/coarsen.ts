import { lengthOf } from './hull-ring.ts';
import { insertInto, type Opening, type OpeningRules, takeBack } from './opening.ts';

/** Numbers an insertion takes in the log. */
const LOG_STRIDE = 3;

/**
 * Closes what was opened beyond `openingLength`, but for the way to each bridge: what is a gap does not hang on how
 * coarse an outline is wished, and the walls at its ends stay on the ring.
 *
 * Insertions form a forest, each splitting an edge that an earlier one made. All are taken back; then those that split
 * an edge longer than `openingLength`, or lead to a bridge, are made again where the one before them is. O(insertions).
 */
export function coarsen(opening: Opening, rules: OpeningRules): void {
  const { hull, log, bridges } = opening;
  const count = log.length / LOG_STRIDE;
  const points = Int32Array.from({ length: count }, (_, turn) => log[LOG_STRIDE * turn]);
  /** When a point came on the ring; -1 for those of the convex hull. */
  const turnOf = new Int32Array(hull.next.length).fill(-1);
  for (let turn = 0; turn < count; turn++) turnOf[points[turn]] = turn;
  const isKept = new Uint8Array(count);
  const keep = (turn: number) => {
    if (turn >= 0) isKept[turn] = 1;
  };
  for (let k = 0; k < bridges.length; k += 2) keep(Math.max(turnOf[bridges[k]], turnOf[bridges[k + 1]]));
  const from = new Int32Array(count);
  const before = new Int32Array(count);
  const isLong = new Uint8Array(count);
  for (let turn = count - 1; turn >= 0; turn--) {
    const a = hull.previous[points[turn]];
    takeBack(opening, LOG_STRIDE * turn);
    from[turn] = a;
    before[turn] = Math.max(turnOf[a], turnOf[hull.next[a]]);
    isLong[turn] = lengthOf(hull, a) > rules.openingLength ? 1 : 0;
    if (isKept[turn] === 1) keep(before[turn]);
  }
  for (let turn = 0; turn < count; turn++) {
    const isReached = before[turn] < 0 || isKept[before[turn]] === 1;
    if (isReached && isLong[turn] === 1) isKept[turn] = 1;
    if (isKept[turn] === 1) insertInto(opening, rules, from[turn], points[turn]);
  }
}
