import { medianOf } from '../../robust-scale.ts';
import { JAMB_REACH, jambsIn } from './jambs.ts';
import { withoutPanes } from './panes.ts';
import { shownParts } from './shown-parts.ts';
import { FEWEST, LOOK_FROM, LOOK_TO, STEP, type WallLook } from './wall-look.ts';
import type { WallStrip } from './wall-strip.ts';

/** A bit of wall with points in more of its bits of height than this stands. */
const STANDING = 0.25;
/** Narrowest and widest opening, m. */
const NARROWEST = 0.4;
const WIDEST = 6;
/** Points nearer to floor or ceiling than this are theirs, m. */
const OFF_PLANE = 0.1;
/** The void in one face of a wall ends within so many bits of that in the other where both are an opening's. */
const FRAME_BITS = 3;
/** A reveal has no gap in depth wider than this, m. */
const DEPTH_GAP = 0.12;
/** A closed leaf stands no deeper in the wall than this, m, is flat within so much, fills so much of its void … */
export const DEEPEST_LEAF = 0.15;
const LEAF_FLATNESS = 0.03;
/** A leaf stands back from the face by more than a face is off its wall, m. */
export const LEAST_RECESS = 0.03;
const LEAF_SHARE = 0.6;
/** … in bits of this size, m, and is no wider than this, m: two leaves. */
const LEAF_STEP = 0.1;
const WIDEST_LEAF = 2;

/** A stretch of a void between two ends, each a jamb that was seen or the end of the void; m along the wall. */
export interface VoidPart {
  readonly from: number;
  readonly to: number;
  /** Ends that are jambs. */
  readonly jambs: number;
  /** Points of the reveals around the void. */
  readonly reveals: readonly number[];
  /** A leaf or a shutter fills it. */
  readonly isClosed: boolean;
  /** Both faces of a wall end at both its ends. */
  readonly isFramed: boolean;
}

/** The stretches of a wall that are void at eye height, parted at jambs. O(points · log points). */
export function voidParts(look: WallLook, band: number): VoidPart[] {
  return holesOf(look, band, facesOf(look, band)).flatMap((hole) => {
    if (isClosed(look, hole)) return [leafIn(hole)];
    return partsOf(look, { ...hole, reveals: withoutPanes(look, hole.reveals) });
  });
}

/**
 * The stretches of a wall that a leaf closes, where most points at eye height lie behind the face: it stands back in its frame,
 * but noise puts so many of its points on the face that few of them are void. O(points · log points).
 */
export function leafParts(look: WallLook, band: number): VoidPart[] {
  const [front, back] = facesOf(look, band);
  const standsBack = recesses(look.strip, look.length);
  const leaf = front.map((share, c) => (standsBack[c] === 1 ? 0 : share));
  return holesOf(look, band, [leaf, back === front ? leaf : back])
    .filter((hole) => isClosed(look, hole))
    .map(leafIn);
}

function leafIn(hole: Void): VoidPart {
  return { ...hole, jambs: 0, isClosed: true, isFramed: false };
}

/** The voids of a wall with the points of their reveals. */
function holesOf(look: WallLook, band: number, faces: readonly [Float64Array, Float64Array]): Void[] {
  const inside = revealPoints(look, band);
  const { along } = look.strip;
  return voidsOf(look, faces).map(({ from, to, isFramed }) => {
    const near = inside.filter((i) => along[i] > from - JAMB_REACH && along[i] < to + JAMB_REACH);
    return { from, to, isFramed, reveals: nearFace(look, near) };
  });
}

/** Share of the bits at eye height that stand in the two faces of a wall, for each bit along it; one twice where no other is known. */
function facesOf({ strip, length, thickness }: WallLook, band: number): [Float64Array, Float64Array] {
  const front = standing(strip, length, (d) => Math.abs(d) <= band);
  return [
    front,
    Number.isFinite(thickness) ? standing(strip, length, (d) => Math.abs(d - thickness) <= band) : front,
  ];
}

/** Stretches along which neither face stands at eye height. */
function voidsOf(
  { length, thickness }: WallLook,
  [front, back]: readonly [Float64Array, Float64Array],
): Omit<Void, 'reveals'>[] {
  const isVoid = front.map((share, k) => (share <= STANDING && back[k] <= STANDING ? 1 : 0));
  return runsOf(isVoid)
    .map(([begin, end]) => ({
      from: begin * STEP,
      to: Math.min(length, end * STEP),
      isFramed:
        Number.isFinite(thickness) &&
        [front, back].every(
          (face) => stands(face, begin - FRAME_BITS, begin) && stands(face, end, end + FRAME_BITS),
        ),
    }))
    .filter(({ from, to }) => to - from >= NARROWEST - 2 * STEP);
}

/** Whether a face stands somewhere between two bits along it. */
function stands(shares: Float64Array, begin: number, end: number): boolean {
  return shares.subarray(Math.max(0, begin), end).some((share) => share > STANDING);
}

/**
 * 1 for each bit along a face whose points at eye height lie behind it: of a leaf in its frame, noise puts many on the face,
 * so that it is no void by their count.
 */
function recesses({ count, along, deep, high }: WallStrip, length: number): Uint8Array {
  const columns = Math.max(1, Math.ceil(length / STEP));
  const depths: number[][] = Array.from({ length: columns }, () => []);
  for (let i = 0; i < count; i++) {
    if (high[i] < LOOK_FROM || high[i] >= LOOK_TO || Math.abs(deep[i]) > DEEPEST_LEAF) continue;
    depths[Math.min(columns - 1, Math.floor(along[i] / STEP))].push(deep[i]);
  }
  return Uint8Array.from(depths, (own) =>
    own.length >= FEWEST && medianOf(Float64Array.from(own)) > LEAST_RECESS ? 1 : 0,
  );
}

/** Share of the bits at eye height that have points, for each bit along a face. */
function standing(
  { count, along, deep, high }: WallStrip,
  length: number,
  isOn: (d: number) => boolean,
): Float64Array {
  const rows = Math.round((LOOK_TO - LOOK_FROM) / STEP);
  const columns = Math.max(1, Math.ceil(length / STEP));
  const hits = new Uint8Array(rows * columns);
  for (let i = 0; i < count; i++) {
    if (high[i] < LOOK_FROM || high[i] >= LOOK_TO || !isOn(deep[i])) continue;
    const column = Math.min(columns - 1, Math.floor(along[i] / STEP));
    hits[column * rows + Math.min(rows - 1, Math.floor((high[i] - LOOK_FROM) / STEP))] = 1;
  }
  const shares = new Float64Array(columns);
  for (let c = 0; c < columns; c++) {
    for (let r = 0; r < rows; r++) shares[c] += hits[c * rows + r] / rows;
  }
  // Voxels may leave a bit empty between two that stand.
  return shares.map((share, c) => Math.max(share, Math.min(shares[c - 1] ?? 0, shares[c + 1] ?? 0)));
}

function runsOf(isVoid: Float64Array): [number, number][] {
  const runs: [number, number][] = [];
  let begin = -1;
  for (let k = 0; k <= isVoid.length; k++) {
    if (isVoid[k] === 1) {
      if (begin < 0) begin = k;
    } else if (begin >= 0) {
      runs.push([begin, k]);
      begin = -1;
    }
  }
  return runs;
}

/** Points within the wall, off its faces, floor and ceiling. */
function revealPoints({ strip, thickness, ceiling }: WallLook, band: number): number[] {
  const inside: number[] = [];
  for (let i = 0; i < strip.count; i++) {
    if (strip.deep[i] <= band || strip.deep[i] >= thickness - band) continue;
    if (strip.high[i] < OFF_PLANE || strip.high[i] > ceiling - OFF_PLANE) continue;
    inside.push(i);
  }
  return inside;
}

/** Reveals begin at the face: what lies behind a gap in depth is something else outside. */
function nearFace({ strip }: WallLook, points: readonly number[]): number[] {
  const sorted = [...points].sort((a, b) => strip.deep[a] - strip.deep[b]);
  const end = sorted.findIndex((i, k) => strip.deep[i] - (k > 0 ? strip.deep[sorted[k - 1]] : 0) > DEPTH_GAP);
  return end < 0 ? sorted : sorted.slice(0, end);
}

/** Where a wall is void at eye height, m along it, and the points of its reveals there. */
type Void = Omit<VoidPart, 'jambs' | 'isClosed'>;

function partsOf(look: WallLook, hole: Void): VoidPart[] {
  const jambs = jambsIn(look.strip, hole.reveals);
  const ends = jambs.map((at) => ({ at, isJamb: true }));
  if (!jambs.some((at) => Math.abs(at - hole.from) <= JAMB_REACH))
    ends.unshift({ at: hole.from, isJamb: false });
  if (!jambs.some((at) => Math.abs(at - hole.to) <= JAMB_REACH)) ends.push({ at: hole.to, isJamb: false });
  const shown = ends.slice(1).flatMap((right, k) => shownParts(look, hole, ends[k], right));
  return shown
    .filter(([left, right]) => right.at - left.at >= NARROWEST && right.at - left.at <= WIDEST)
    .map(([left, right]) => ({
      from: left.at,
      to: right.at,
      jambs: Number(left.isJamb) + Number(right.isJamb),
      reveals: hole.reveals,
      isClosed: false,
      isFramed: hole.isFramed && ends.length === 2,
    }));
}

/** Whether an upright surface not far behind the face fills a void at eye height: a closed door in its frame. */
function isClosed({ strip }: WallLook, { from, to, reveals }: Void): boolean {
  if (to - from > WIDEST_LEAF) return false;
  const between = reveals.filter(
    (i) =>
      strip.high[i] >= LOOK_FROM && strip.high[i] < LOOK_TO && strip.along[i] > from && strip.along[i] < to,
  );
  if (between.length < FEWEST) return false;
  const depth = medianOf(Float64Array.from(between, (i) => strip.deep[i]));
  if (depth > DEEPEST_LEAF) return false;
  const bits = new Set<number>();
  const rows = Math.round((LOOK_TO - LOOK_FROM) / LEAF_STEP);
  const columns = Math.max(1, Math.round((to - from) / LEAF_STEP));
  for (const i of between) {
    if (Math.abs(strip.deep[i] - depth) > LEAF_FLATNESS) continue;
    const column = Math.min(columns - 1, Math.floor((strip.along[i] - from) / LEAF_STEP));
    bits.add(column * rows + Math.min(rows - 1, Math.floor((strip.high[i] - LOOK_FROM) / LEAF_STEP)));
  }
  return bits.size >= LEAF_SHARE * rows * columns;
}
