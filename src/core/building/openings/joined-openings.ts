import type { Opening } from '../../types.ts';

/** Ends nearer than this, m, meet … */
const MEETING = 0.15;
/** … where both go on in one direction, within this cosine: the chords of a curved wall turn a few degrees. */
const STRAIGHT = 0.97;

/** An opening with how it ends: cut off by the end of the stretch of wall that was looked at, or within that. */
export interface PlacedOpening {
  readonly opening: Opening;
  readonly isCutBefore: boolean;
  readonly isCutAfter: boolean;
}

/**
 * Openings of which a stretch of wall showed one part and the next the other, joined.
 *
 * Outlines have vertices within walls, where a face was found in two pieces or a curve bends: what was looked at ends there, and
 * an opening across it comes in halves. O(openings²).
 */
export function joinedOpenings(placed: readonly PlacedOpening[]): Opening[] {
  const rest = [...placed];
  for (let i = 0; i < rest.length; i++) {
    for (let j = 0; j < rest.length; j++) {
      const whole = i === j ? null : joinedPair(rest[i], rest[j]);
      if (whole === null) continue;
      rest[i] = whole;
      rest.splice(j, 1);
      if (j < i) i--;
      // What has grown may meet those it did not meet before.
      j = -1;
    }
  }
  return rest.map(({ opening }) => opening);
}

/** Two openings as one where the second goes on where the first was cut off; looked at from either side of a wall. */
function joinedPair(first: PlacedOpening, second: PlacedOpening): PlacedOpening | null {
  if (first.opening.type !== second.opening.type || !first.isCutAfter) return null;
  return [second, turned(second)].reduce<PlacedOpening | null>(
    (whole, next) => whole ?? goingOn(first, next),
    null,
  );
}

function goingOn(first: PlacedOpening, next: PlacedOpening): PlacedOpening | null {
  const [a, b] = [first.opening, next.opening];
  const [dx, dy] = [a.to[0] - a.from[0], a.to[1] - a.from[1]];
  const [ex, ey] = [b.to[0] - b.from[0], b.to[1] - b.from[1]];
  const isStraight = dx * ex + dy * ey >= STRAIGHT * Math.hypot(dx, dy) * Math.hypot(ex, ey);
  const gap = Math.hypot(b.from[0] - a.to[0], b.from[1] - a.to[1]);
  if (!next.isCutBefore || !isStraight || gap > MEETING) return null;
  return {
    opening: {
      type: a.type,
      from: a.from,
      to: b.to,
      sill: Math.min(a.sill, b.sill),
      head: Math.max(a.head, b.head),
      confidence: Math.min(a.confidence, b.confidence),
    },
    isCutBefore: first.isCutBefore,
    isCutAfter: next.isCutAfter,
  };
}

function turned({ opening, isCutBefore, isCutAfter }: PlacedOpening): PlacedOpening {
  return {
    opening: { ...opening, from: opening.to, to: opening.from },
    isCutBefore: isCutAfter,
    isCutAfter: isCutBefore,
  };
}
