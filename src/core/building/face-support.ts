import type { PointCloud } from '../types.ts';
import { countBins } from './bin-masks.ts';
import { alongOf, asideOf, type Face, pointOn } from './face.ts';
import { binAt, columnAt, type HeightColumns, topShare } from './height-columns.ts';
import type { LocalCeiling } from './local-ceiling.ts';

/** Bits of wall along a face, m. */
const STEP = 0.05;
/** Distance to either side at which a face's ceiling is looked up, m. */
const BESIDE = 0.4;
/** What the rest of a wall counts where its top is not to be seen. */
const BODY_SHARE = 0.3;

/** The ceiling is looked at from so near a face, m, or past its noise … */
const NEAR = 0.02;
const NOISES = 1.5;
/** … as far as this, m: less than the thinnest wall … */
const THINNEST = 0.065;
/** … and so long a stretch, m. */
const LOOK = 0.4;
/** Fewer points of a ceiling tell nothing. */
const FEWEST = 4;
/** A ceiling with less than the first share of its points behind a face ends there, with more than the second it goes on. */
const ENDS = 0.35;
const GOES_ON = 0.7;

/** How far a wall stands up along a face, bit by bit. */
export interface FaceSupport {
  /** Place along the face where the first bit begins, m. */
  readonly from: number;
  readonly step: number;
  /** Share of the height below the ceiling that has points, 0 to 1. */
  readonly shares: Float64Array;
}

/** The storey that faces stand in. */
export interface FaceSite {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  readonly ceiling: LocalCeiling;
}

/** Reads a face's own columns, `reach` beyond its ends. O(columns of the face). */
export function supportAlong({ cloud, columns, ceiling }: FaceSite, face: Face, reach: number): FaceSupport {
  const { centres, masks, size } = columns;
  const from = face.from - reach;
  const count = Math.ceil((face.to - face.from + 2 * reach) / STEP);
  const seen = new Int32Array(2 * count);
  // A column is wider than a bit.
  const half = size / STEP / 2 + 0.5;
  for (const c of face.members) {
    const at = (alongOf(face, centres[2 * c], centres[2 * c + 1]) - from) / STEP;
    for (let k = Math.max(0, Math.floor(at - half)); k <= Math.min(count - 1, Math.floor(at + half)); k++) {
      seen[2 * k] |= masks[2 * c];
      seen[2 * k + 1] |= masks[2 * c + 1];
    }
  }
  const shares = new Float64Array(count);
  for (let k = 0; k < count; k++) {
    if (seen[2 * k] === 0 && seen[2 * k + 1] === 0) continue;
    const along = from + (k + 0.5) * STEP;
    const [left, right] = [-BESIDE, BESIDE].map((aside) => ceiling.at(...pointOn(face, along, aside)));
    shares[k] = standingShare(columns, seen, k, Math.min(left, right));
  }
  const parting = ceilingParting(cloud, columns, face, { from, count });
  return { from, step: STEP, shares: shares.map((share, k) => share * parting[k]) };
}

/**
 * Whether the ceiling ends at a face, 0 to 1 a bit: it does at a wall, while it goes on over a cupboard.
 *
 * Points of the ceiling just before and just behind the face are counted over half a metre along it.
 */
function ceilingParting(
  { positions }: PointCloud,
  columns: HeightColumns,
  face: Face,
  { from, count }: { readonly from: number; readonly count: number },
): Float64Array {
  const { size, overPoints, overStart } = columns;
  const near = Math.max(NEAR, NOISES * face.noise);
  const far = Math.max(THINNEST, near + 0.02);
  const before = new Float64Array(count);
  const behind = new Float64Array(count);
  const visited = new Set<number>();
  for (let k = 0; k < count; k++) {
    const along = from + (k + 0.5) * STEP;
    for (let across = -far; across <= far; across += size / 2) {
      const c = columnAt(columns, ...pointOn(face, along, across));
      if (c < 0 || visited.has(c)) continue;
      visited.add(c);
      for (let p = overStart[c]; p < overStart[c + 1]; p++) {
        const [px, py] = [positions[3 * overPoints[p]], positions[3 * overPoints[p] + 1]];
        const aside = asideOf(face, px, py);
        const bit = Math.floor((alongOf(face, px, py) - from) / STEP);
        if (bit < 0 || bit >= count || Math.abs(aside) < near || Math.abs(aside) > far) continue;
        if (aside > 0) before[bit]++;
        else behind[bit]++;
      }
    }
  }
  const half = Math.round(LOOK / 2 / STEP);
  return before.map((_, k) => {
    let [a, b] = [0, 0];
    for (let m = Math.max(0, k - half); m <= Math.min(count - 1, k + half); m++) {
      a += before[m];
      b += behind[m];
    }
    const [less, more] = [Math.min(a, b), Math.max(a, b)];
    return more < FEWEST ? 1 : Math.min(1, Math.max(0, (GOES_ON - less / more) / (GOES_ON - ENDS)));
  });
}

/** Share of the bins just below a ceiling that have points, or of all, which counts less. */
function standingShare(columns: HeightColumns, masks: Int32Array, k: number, ceiling: number): number {
  const bins = binAt(columns, ceiling);
  return Math.max(topShare(columns, masks, k, ceiling), BODY_SHARE * (countBins(masks, k, 0, bins) / bins));
}
