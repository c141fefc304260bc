import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { isSharp, ON_CEILING } from './ceiling-across.ts';
import { alongOf, asideOf, type Face } from './face.ts';
import { columnsAlong } from './face-bits.ts';

/** The ceiling is looked for so far behind a face, m: past the thickest inner wall. */
const FARTHEST = 0.5;
/** Share of its points that may be strays, nearer than it begins. */
const STRAY = 0.05;
/** Fewer points tell no place. */
const FEWEST = 40;
/** What noise spreads of the face itself, in deviations, is not behind it. */
const NOISES = 2;

/**
 * How far behind a stretch of a face the ceiling of what lies there begins, m: the wall is no thicker. Infinite where too
 * little of it was seen, or the face's own points reach too far.
 *
 * Its points lie evenly from there on, so a low quantile of their distances tells where they begin, strays or not.
 * O(points of the ceiling there).
 *
 * Not taken: for noisy faces, too (hard corners at 5 cm .698 → .680: their own highest points look like a ceiling's).
 *
 * @param side of the face's normal to look on, 1 or −1
 */
export function ceilingBehind(
  { positions }: PointCloud,
  columns: HeightColumns,
  face: Face,
  { from, to, side }: { readonly from: number; readonly to: number; readonly side: 1 | -1 },
): number {
  if (!isSharp(face)) return Infinity;
  const { size, overhead, overPoints, overStart } = columns;
  const bits = { from, step: size / 2, count: Math.ceil((2 * (to - from)) / size) };
  const away: number[] = [];
  for (const c of columnsAlong(columns, face, bits, FARTHEST)) {
    for (let p = overStart[c]; p < overStart[c + 1]; p++) {
      const i = 3 * overPoints[p];
      if (positions[i + 2] <= overhead[c] - ON_CEILING) continue;
      const t = alongOf(face, positions[i], positions[i + 1]);
      const aside = side * asideOf(face, positions[i], positions[i + 1]);
      if (t >= from && t < to && aside > NOISES * face.noise && aside < FARTHEST) away.push(aside);
    }
  }
  if (away.length < FEWEST) return Infinity;
  const low = Float64Array.from(away).sort()[Math.floor(STRAY * away.length)];
  return Math.max(0, (low - STRAY * FARTHEST) / (1 - STRAY));
}
