import { columnAt } from '../columns/height-columns.ts';
import { LEAST_HITS } from '../columns/wall-columns.ts';
import { asideOf, type Face, pointOn } from './face.ts';
import { reachOf } from './fit-line.ts';
import type { FreeColumns } from './free-columns.ts';

/** Columns whose points lie on average so near a line, m, lie on it; beside noisier faces clutter does, too, m. */
const ON_LINE = 0.015;
const MOST_NOISE = 0.01;
/** So far past an end, m, columns that no face has taken are looked for: past a row of a scanner that looks along the face. */
const PAST_END = 0.2;

/**
 * A face with the columns past its ends that lie on its line and that no other face has taken: beside a corner, and where a
 * wall was seen in rows, columns make no line with their neighbours. Takes them. O(columns past the ends).
 */
export function withEnds({ columns, isFree }: FreeColumns, face: Face): Face {
  if (face.noise > MOST_NOISE) return face;
  const { centres, size, hits, bins } = columns;
  const past: number[] = [];
  for (const way of [1, -1]) {
    const end = way > 0 ? face.to : face.from;
    for (let off = 0; off < PAST_END; off += size / 2) {
      for (const across of [-ON_LINE, 0, ON_LINE]) {
        const c = columnAt(columns, ...pointOn(face, end + way * off, across));
        // What hangs below the ceiling only may be a beam.
        if (c < 0 || isFree[c] === 0 || hits[c] < LEAST_HITS * bins) continue;
        if (Math.abs(asideOf(face, centres[2 * c], centres[2 * c + 1])) > ON_LINE) continue;
        isFree[c] = 0;
        past.push(c);
      }
    }
  }
  if (past.length === 0) return face;
  const members = [...face.members, ...past];
  return { ...face, members, ...reachOf(columns, members, face) };
}
