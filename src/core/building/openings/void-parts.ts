import { medianOf } from '../../robust-scale.ts';
import { withoutPanes } from './panes.ts';
import { LEVEL_SHARE, levelReach } from './reveal-levels.ts';
import { FEWEST, LOOK_FROM, LOOK_TO, STEP, THROUGH_SHARE, throughShare, type WallLook } from './wall-look.ts';
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
/** Reach around the end of a void in which its jamb is looked for, m. */
const JAMB_REACH = 0.15;
/** Width of a jamb's points along the wall, m. */
const JAMB_WIDTH = 0.06;
/** Bits of height in which a jamb is seen, m. */
const JAMB_STEP = 2 * STEP;
/** A jamb is seen over at least this height, m, no higher than so far above eye height: lintels begin there. */
const LEAST_JAMB = 0.4;
const ABOVE_LOOK = 0.1;

/** A void that goes on so far past its sill and its head, m, is hidden there: by a cupboard, not by chance. */
const LEAST_HIDDEN = 0.5;

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
  const jambs = jambsIn(look, hole);
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

interface PartEnd {
  readonly at: number;
  readonly isJamb: boolean;
}

/**
 * What a void between two ends shows: beside a jamb an opening ends where its sill and its head do, unless the scan sees through
 * what is past that. Where a void goes on, the wall behind may be hidden.
 */
function shownParts(
  look: WallLook,
  { reveals, isFramed }: Void,
  left: PartEnd,
  right: PartEnd,
): [PartEnd, PartEnd][] {
  if (isFramed) return [[left, right]];
  const between = { begin: left.at, end: right.at };
  const width = right.at - left.at;
  // Two jambs are one opening's unless hardly any of its sill and head was seen.
  const mostShown = left.isJamb && right.isJamb ? LEVEL_SHARE * width : width - LEAST_HIDDEN;
  const reachFrom = (end: PartEnd, way: 1 | -1): number | null => {
    const reach = end.isJamb ? levelReach(look.strip, reveals, between, way) : null;
    return reach !== null && reach <= mostShown ? reach : null;
  };
  const [fromLeft, fromRight] = [reachFrom(left, 1), reachFrom(right, -1)];
  const hidden = { begin: left.at + (fromLeft ?? 0), end: right.at - (fromRight ?? 0) };
  const isWhole = (fromLeft === null && fromRight === null) || hidden.end <= hidden.begin;
  if (isWhole || throughShare(look, hidden) >= THROUGH_SHARE) return [[left, right]];
  const parts: [PartEnd, PartEnd][] = [];
  if (fromLeft !== null) parts.push([left, { at: hidden.begin, isJamb: false }]);
  if (fromRight !== null) parts.push([{ at: hidden.end, isJamb: false }, right]);
  return parts;
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

/** The most heights of those that follow each other with one missing at most: stray points above and below a sill are no jamb. */
function longestRun(heights: ReadonlyMap<number, number>): number {
  if (heights.size * JAMB_STEP < LEAST_JAMB) return 0;
  let [run, longest, last] = [0, 0, Number.NEGATIVE_INFINITY];
  for (const height of [...heights.keys()].sort((a, b) => a - b)) {
    run = height - last <= 2 ? run + 1 : 1;
    longest = Math.max(longest, run);
    last = height;
  }
  return longest;
}

/** Places along a void where reveals stand upright, in order. O(points · log points). */
function jambsIn({ strip }: WallLook, { reveals }: Void): number[] {
  const below = reveals.filter((i) => strip.high[i] < LOOK_TO + ABOVE_LOOK);
  const order = below.sort((i, j) => strip.along[i] - strip.along[j]);
  const sorted = Float64Array.from(order, (i) => strip.along[i]);
  const step = (k: number) => Math.floor(strip.high[order[k]] / JAMB_STEP);
  // Points at each height within the window that ends at the point looked at.
  const heights = new Map<number, number>();
  const found: { at: number; weight: number }[] = [];
  let low = 0;
  for (let k = 0; k < sorted.length; k++) {
    heights.set(step(k), (heights.get(step(k)) ?? 0) + 1);
    for (; sorted[k] - sorted[low] > JAMB_WIDTH; low++) {
      const rest = heights.get(step(low))! - 1;
      if (rest > 0) heights.set(step(low), rest);
      else heights.delete(step(low));
    }
    const count = k + 1 - low;
    if (count < FEWEST || longestRun(heights) * JAMB_STEP < LEAST_JAMB) continue;
    found.push({ at: sorted[low + (count >> 1)], weight: heights.size + count / 1000 });
  }
  found.sort((a, b) => b.weight - a.weight);
  const kept: number[] = [];
  for (const { at } of found) if (kept.every((other) => Math.abs(other - at) > JAMB_REACH)) kept.push(at);
  return kept.sort((a, b) => a - b);
}
