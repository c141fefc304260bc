import { freeOnLine, ON_LINE, withMembers } from './columns-on-line.ts';
import type { Face } from './face.ts';
import type { FreeColumns } from './free-columns.ts';

/** Beside faces noisier than this, m, clutter lies on their line, too. */
const MOST_NOISE = 0.01;
/** So far past an end, m, columns that no face has taken are looked for: past a row of a scanner that looks along the face. */
const PAST_END = 0.2;

/**
 * A face with the columns past its ends that lie on its line and that no other face has taken: beside a corner, and where a
 * wall was seen in rows, columns make no line with their neighbours. Takes them. O(columns past the ends).
 */
export function withEnds(walls: FreeColumns, face: Face): Face {
  if (face.noise > MOST_NOISE) return face;
  const past = new Set<number>();
  for (const way of [1, -1]) {
    const end = way > 0 ? face.to : face.from;
    for (let off = 0; off < PAST_END; off += walls.columns.size / 2) {
      for (const c of freeOnLine(walls, face, end + way * off, ON_LINE)) past.add(c);
    }
  }
  return withMembers(walls, face, [...past]);
}
