import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { alongOf, asideOf, type Face } from './face.ts';
import { columnsAlong, type FaceBits } from './face-bits.ts';

/** The ceiling is looked at from so near a face, m, or past its noise, in deviations … */
const NEAR = 0.02;
const NOISES = 1.5;
/** … as far as this, m, less than the thinnest wall, or so much past its noise … */
const THINNEST = 0.065;
const LEAST_WIDTH = 0.02;
/** … over so long a stretch, m … */
const LOOK = 0.4;
/** … and beside that, where a wall's own points reach no more, how densely it was seen, m. */
const BESIDE_FROM = 0.1;
const BESIDE_TO = 0.35;
/** Points of a wall nearer to the ceiling than this cannot be told from it, m. */
export const ON_CEILING = 0.05;
/** Fewer points to be expected of a ceiling tell nothing … */
const FEWEST = 4;
/** … nor do points farther apart than so many widths of the strip: it may run between their rows. */
const MOST_SPACING = 1.5;
/** A side with less than this share of the other's ceiling is no measure for it. */
const LEAST_BESIDE = 0.5;
/** What is counted behind a face is taken for so many standard errors more: few points are no proof of an end. */
const ERRORS = 0.5;
/** A ceiling with less than the first share of its points behind a face ends there, with more than the second it goes on. */
const ENDS = 0.35;
const GOES_ON = 0.7;

/** Points of the ceiling beside each bit of a face: near and farther, on the side of its normal, then on the other. */
const KINDS = 4;

/**
 * Whether the ceiling goes on across a face, 0 to 1 a bit: it does over a cupboard, while it ends at a wall; NaN where
 * too little of it was seen.
 *
 * Points of the ceiling just behind the face are compared with what its density before the face lets expect there, along
 * the face itself: past the ends of a pilaster the ceiling goes on. The
 * wall's own highest points, which noise spreads evenly to both sides, are taken off: they are what is too many just before
 * it. O(points of the ceiling near the face).
 *
 * Not taken: a look over 0.8 or 1.2 m where 0.4 m holds too few points (hard corners at 5 cm .60 → .61, but a corridor is
 * split where the look reaches past it: rooms of the scenes .996 → .980); one whole standard error (hard corners .61, clean
 * rooms 1.00 → .99); a look past the ends of the face where it is short (clean corners at 5 cm .953 → .947 and .943 → .929);
 * one moved along the face so that it stays within it (.953 → .950).
 */
export function ceilingAcross(
  cloud: PointCloud,
  columns: HeightColumns,
  face: Face,
  bits: FaceBits,
): Float64Array {
  const strip = stripBeside(face);
  const counts = countBeside(cloud, columns, face, bits, strip);
  const half = Math.round(LOOK / 2 / bits.step);
  const [first, last] = [face.from, face.to].map((end) => Math.round((end - bits.from) / bits.step));
  return Float64Array.from({ length: bits.count }, (_, k) => {
    const isOn = k >= first && k < last;
    const from = Math.max(isOn ? first : 0, k - half);
    const to = Math.min(isOn ? last : bits.count, k + half + 1);
    const sums = [0, 0, 0, 0];
    for (let at = KINDS * from; at < KINDS * to; at++) sums[at % KINDS] += counts[at];
    return goesOn(sums, strip, (to - from) * bits.step);
  });
}

/** Points of the ceiling beside some bits of a face, past its noise but within the thinnest wall: on the side of its normal, and on the other. */
export function ceilingBeside(
  cloud: PointCloud,
  columns: HeightColumns,
  face: Face,
  bits: FaceBits,
): readonly [ahead: number, behind: number] {
  const counts = countBeside(cloud, columns, face, bits, stripBeside(face));
  const beside = [0, 0] as [number, number];
  for (let k = 0; k < bits.count; k++) {
    beside[0] += counts[KINDS * k];
    beside[1] += counts[KINDS * k + 2];
  }
  return beside;
}

/** Distances from a face between which its ceiling is counted, m. */
interface Strip {
  readonly near: number;
  readonly far: number;
}

/** Whether a face's own points stay out of the strip beside it, so that the end of a ceiling there is sure. */
export function isSharp({ noise }: Face): boolean {
  return NOISES * noise <= NEAR;
}

function stripBeside({ noise }: Face): Strip {
  const near = Math.max(NEAR, NOISES * noise);
  return { near, far: Math.max(THINNEST, near + LEAST_WIDTH) };
}

function countBeside(
  { positions }: PointCloud,
  columns: HeightColumns,
  face: Face,
  bits: FaceBits,
  { near, far }: Strip,
): Uint32Array {
  const { from, step, count } = bits;
  const { overhead, overPoints, overStart } = columns;
  const counts = new Uint32Array(KINDS * count);
  const take = (x: number, y: number) => {
    const bit = Math.floor((alongOf(face, x, y) - from) / step);
    if (bit < 0 || bit >= count) return;
    const aside = asideOf(face, x, y);
    const away = Math.abs(aside);
    const kind = KINDS * bit + (aside > 0 ? 0 : 2);
    if (away >= near && away <= far) counts[kind]++;
    else if (away >= BESIDE_FROM && away <= BESIDE_TO) counts[kind + 1]++;
  };
  for (const c of columnsAlong(columns, face, bits, BESIDE_TO)) {
    for (let p = overStart[c]; p < overStart[c + 1]; p++) {
      const i = 3 * overPoints[p];
      if (positions[i + 2] > overhead[c] - ON_CEILING) take(positions[i], positions[i + 1]);
    }
  }
  return counts;
}

function goesOn(sums: readonly number[], { near, far }: Strip, length: number): number {
  const width = far - near;
  const shares = [0, 2].flatMap((before) => {
    const behind = 2 - before;
    const beside = sums[before + 1];
    const expected = (beside * width) / (BESIDE_TO - BESIDE_FROM);
    if (expected < FEWEST || beside < LEAST_BESIDE * sums[behind + 1]) return [];
    const spacing = Math.sqrt(((BESIDE_TO - BESIDE_FROM) * length) / beside);
    if (spacing > MOST_SPACING * width) return [];
    const own = Math.max(0, sums[before] - expected);
    const rest = Math.max(0, sums[behind] - own);
    return [(rest + ERRORS * Math.sqrt(rest)) / expected];
  });
  if (shares.length === 0) return Number.NaN;
  return Math.min(1, Math.max(0, (Math.min(...shares) - ENDS) / (GOES_ON - ENDS)));
}
