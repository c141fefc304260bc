import { countBins } from '../columns/bin-masks.ts';
import { binAt, type HeightColumns, topShare } from '../columns/height-columns.ts';
import { ceilingAcross } from './ceiling-across.ts';
import { alongOf, type Face, type FaceSite, pointOn } from './face.ts';
import type { FaceBits } from './face-bits.ts';
import { gapAbove } from './gap-above.ts';

/** Bits of wall along a face, m. */
export const STEP = 0.05;
/** A share of wall that counts as one. */
export const WALL_SHARE = 0.5;
/** What a wall that is only taken to go on counts. */
export const TAKEN_SHARE = 0.8;
/** Distance to either side at which a face's ceiling is looked up, m. */
const BESIDE = 0.4;
/** What the rest of a wall counts where its top is not to be seen. */
const BODY_SHARE = 0.3;

/** Height of the slice below a ceiling that a wall fills, m: cupboards hide what is farther down. */
const TOP_BAND = 0.25;
/** Where the ceiling is known to end, a wall of which so much of that slice was seen counts in full. */
const ENOUGH = 0.4;

/** How far a wall stands up along a face, bit by bit. */
export interface FaceSupport {
  /** Place along the face where the first bit begins, m. */
  readonly from: number;
  readonly step: number;
  /** Share of the height below the ceiling that has points, 0 to 1; 0 where it ends below the ceiling, or that goes on over it. */
  readonly shares: Float64Array;
  /** Whether anything was seen, 1 or 0 a bit. */
  readonly isSeen: Uint8Array;
  /** Whether the ceiling goes on over the face, 0 to 1 a bit; NaN where that is not known. */
  readonly ceiling: Float64Array;
}

/** One of the faces of a storey, and how each stands. */
export interface FaceAmong {
  readonly faces: readonly Face[];
  readonly own: readonly FaceSupport[];
  readonly i: number;
}

/**
 * Reads a face's own columns, `reach` beyond its ends. O(columns of the face).
 *
 * Not taken: reading every column near the line too. Walls seen through a slit above cupboards come out (hard rooms F1 .92
 * → .95), but so do cupboards and curtains (hard corners at 5 cm .60 → .51).
 */
export function supportAlong(site: FaceSite, face: Face, reach: number): FaceSupport {
  const { cloud, columns, ceiling } = site;
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
  const bits: FaceBits = { from, step: STEP, count };
  const over = ceilingAcross(cloud, columns, face, bits);
  const gaps = gapAbove(site, face, bits);
  const standing = (share: number, k: number) => {
    if (gaps[k] === 1) return 0;
    return Number.isNaN(over[k]) ? share : (1 - over[k]) * Math.min(1, share / ENOUGH);
  };
  return {
    from,
    step: STEP,
    shares: shares.map(standing),
    isSeen: Uint8Array.from(shares, (share) => (share > 0 ? 1 : 0)),
    ceiling: over,
  };
}

/** Share of the bins just below a ceiling that have points, or of all, which counts less. */
function standingShare(columns: HeightColumns, masks: Int32Array, k: number, ceiling: number): number {
  const bins = binAt(columns, ceiling);
  return Math.max(
    topShare(columns, masks, k, ceiling, TOP_BAND),
    BODY_SHARE * (countBins(masks, k, 0, bins) / bins),
  );
}

/** Whether a wall stands at a place along a face, m. */
export function wallAt({ from, step, shares }: FaceSupport, along: number): boolean {
  return (shares[Math.floor((along - from) / step)] ?? 0) >= WALL_SHARE;
}
