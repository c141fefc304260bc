import { medianOf } from '../robust-scale.ts';
import type { Opening } from '../types.ts';
import type { WallStretch, WallStrip } from './wall-strip.ts';

/** Heights above the floor, m, at which every door and nearly every window is open and furniture seldom hides a wall. */
const LOOK_FROM = 1.45;
const LOOK_TO = 1.85;
/** Bits of height and length, m. */
const STEP = 0.05;
/** A bit of wall with points in more of its bits of height than this stands. */
const STANDING = 0.25;
/** Points this near a face are on it, m, or within three deviations. */
const ON_FACE = 0.03;
/** Narrowest and widest opening, m. */
const NARROWEST = 0.4;
const WIDEST = 6;
/** Reach around the end of a void in which its jamb is looked for, m. */
const JAMB_REACH = 0.15;
/** Fewest points of a jamb, a head or a sill. */
const FEWEST = 5;
/** Width of a jamb's points along the wall, m. */
const JAMB_WIDTH = 0.06;
/** Points nearer to floor or ceiling than this are theirs, m. */
const OFF_PLANE = 0.1;
/** A reveal has no gap in depth wider than this, m. */
const DEPTH_GAP = 0.12;
/** A sill or a head is level within this, m. */
const LEVEL_REACH = 0.03;
/** … and seen over this share of the width. */
const LEVEL_SHARE = 0.4;
/** Where floor or ceiling shows over this share of a width, the scan sees through. */
const THROUGH_SHARE = 0.4;
/** Least height of an opening, m. */
const LEAST_OPEN = 0.3;
/** A jamb is seen over at least this height, m. */
const LEAST_JAMB = 0.4;
/** A door's sill is no higher, its head no lower, m. */
const DOOR_SILL = 0.15;
const LEAST_HEAD = 1.8;
/** An opening whose head is this near the ceiling has no lintel, m. */
const NO_LINTEL = 0.12;

/** A hole in a wall: reach along its face and heights above the floor, m. */
export interface FoundOpening {
  readonly type: 'door' | 'window' | 'passage';
  readonly from: number;
  readonly to: number;
  readonly sill: number;
  readonly head: number;
  /** Depth of its reveals, m; NaN where none was seen. */
  readonly reveal: number;
  readonly confidence: number;
}

export interface WallLook {
  readonly strip: WallStrip;
  readonly length: number;
  /** Of a wall between two rooms, m; infinite where only one face is known. */
  readonly thickness: number;
  /** Standard deviation of points across the faces, m. */
  readonly noise: number;
  /** Height of the ceiling above the floor, m. */
  readonly ceiling: number;
  /** Whether floor or ceiling was seen within the wall, at a place along it. */
  isThrough(along: number): boolean;
}

/** Where a wall is void at eye height, m along it, and the points of its reveals there. */
interface Void {
  readonly from: number;
  readonly to: number;
  readonly reveals: readonly number[];
}

/**
 * Doors, windows and passages of a stretch of wall.
 *
 * A void at eye height in every face of the wall may be an opening or hidden. Reveals tell: points within the wall, which
 * stand upright at jambs and lie level at sills and heads. Jambs part a void; a part is an opening where sill or head is seen
 * over most of its width, or where the scan sees through beside a jamb. O(points).
 */
export function findOpenings(look: WallLook): FoundOpening[] {
  const band = faceBand(look);
  const inside = revealPoints(look, band);
  return voidsOf(look, band).flatMap(([from, to]) => {
    const { along } = look.strip;
    const near = inside.filter((i) => along[i] > from - JAMB_REACH && along[i] < to + JAMB_REACH);
    const hole = { from, to, reveals: nearFace(look, near) };
    return partsOf(look, hole).flatMap((part) => openingIn(look, hole, part, band) ?? []);
  });
}

/** Half thickness of a face, m. */
function faceBand({ noise, thickness }: WallLook): number {
  return Math.min(Math.max(ON_FACE, 3 * noise), thickness / 3);
}

/** Stretches along which nothing stands at eye height. */
function voidsOf({ strip, length, thickness }: WallLook, band: number): [number, number][] {
  const front = standing(strip, length, (d) => Math.abs(d) <= band);
  const back = Number.isFinite(thickness)
    ? standing(strip, length, (d) => Math.abs(d - thickness) <= band)
    : front;
  const isVoid = front.map((share, k) => (share <= STANDING && back[k] <= STANDING ? 1 : 0));
  return runsOf(isVoid)
    .map(([from, to]): [number, number] => [from * STEP, Math.min(length, to * STEP)])
    .filter(([from, to]) => to - from >= NARROWEST - 2 * STEP);
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

/** A stretch of a void between two ends, each a jamb that was seen or the end of the void. */
interface Part {
  readonly from: number;
  readonly to: number;
  readonly jambs: number;
}

function partsOf(look: WallLook, hole: Void): Part[] {
  const jambs = jambsIn(look, hole);
  const ends = jambs.map((at) => ({ at, isJamb: true }));
  if (!jambs.some((at) => Math.abs(at - hole.from) <= JAMB_REACH))
    ends.unshift({ at: hole.from, isJamb: false });
  if (!jambs.some((at) => Math.abs(at - hole.to) <= JAMB_REACH)) ends.push({ at: hole.to, isJamb: false });
  const parts: Part[] = [];
  for (let k = 1; k < ends.length; k++) {
    const [left, right] = [ends[k - 1], ends[k]];
    if (right.at - left.at < NARROWEST || right.at - left.at > WIDEST) continue;
    parts.push({ from: left.at, to: right.at, jambs: Number(left.isJamb) + Number(right.isJamb) });
  }
  return parts;
}

/** Places along a void where reveals stand upright, in order. */
function jambsIn({ strip }: WallLook, { reveals }: Void): number[] {
  const below = reveals.filter((i) => strip.high[i] < LOOK_TO + 0.1);
  const sorted = below.map((i) => ({ at: strip.along[i], z: strip.high[i] })).sort((a, b) => a.at - b.at);
  const found: { at: number; weight: number }[] = [];
  let low = 0;
  for (let k = 0; k < sorted.length; k++) {
    while (sorted[k].at - sorted[low].at > JAMB_WIDTH) low++;
    const window = sorted.slice(low, k + 1);
    const steps = new Set(window.map(({ z }) => Math.floor(z / (2 * STEP)))).size;
    if (window.length < FEWEST || steps * 2 * STEP < LEAST_JAMB) continue;
    found.push({ at: window[window.length >> 1].at, weight: steps + window.length / 1000 });
  }
  found.sort((a, b) => b.weight - a.weight);
  const kept: number[] = [];
  for (const { at } of found) if (kept.every((other) => Math.abs(other - at) > JAMB_REACH)) kept.push(at);
  return kept.sort((a, b) => a - b);
}

function openingIn(
  look: WallLook,
  { reveals }: Void,
  { from, to, jambs }: Part,
  band: number,
): FoundOpening | null {
  const { strip, thickness, ceiling } = look;
  const margin = Math.min(0.1, (to - from) / 4);
  const between = reveals.filter((i) => strip.along[i] > from + margin && strip.along[i] < to - margin);
  const width = to - from - 2 * margin;
  const head = levelOf(
    strip,
    between.filter((i) => strip.high[i] > LOOK_TO - 0.05),
    width,
  );
  const sill = levelOf(
    strip,
    between.filter((i) => strip.high[i] < LOOK_FROM + 0.05),
    width,
  );
  const through = throughShare(look, from + margin, to - margin);
  const isPaired = Number.isFinite(thickness);
  const isSeen = head.share >= LEVEL_SHARE || sill.share >= LEVEL_SHARE;
  if (!isSeen && !(isPaired && jambs > 0 && through >= THROUGH_SHARE)) return null;
  const faces = faceHeights(look, { begin: from + margin, end: to - margin, band });
  const bottom = sill.share >= LEVEL_SHARE ? sill.height : faces.sill;
  const top = head.share >= LEVEL_SHARE ? head.height : faces.head;
  if (top - bottom < LEAST_OPEN) return null;
  const isLow = bottom <= DOOR_SILL && top >= LEAST_HEAD;
  const type = !isLow ? 'window' : ceiling - top <= NO_LINTEL ? 'passage' : 'door';
  const evidence =
    jambs + (head.share >= LEVEL_SHARE ? 1 : 0) + (isLow ? through : sill.share >= LEVEL_SHARE ? 1 : 0);
  return {
    type,
    from,
    to,
    sill: isLow ? 0 : bottom,
    head: top,
    reveal: deepest(
      strip,
      reveals.filter((i) => strip.along[i] > from - 0.05 && strip.along[i] < to + 0.05),
    ),
    confidence: Math.min(1, evidence / 3),
  };
}

function deepest({ deep }: WallStrip, points: readonly number[]): number {
  if (points.length < FEWEST) return Number.NaN;
  const depths = Float64Array.from(points, (i) => deep[i]).sort();
  return depths[Math.floor(0.98 * (depths.length - 1))];
}

function throughShare({ isThrough }: WallLook, from: number, to: number): number {
  let [through, count] = [0, 0];
  for (let along = from; along <= to; along += STEP) {
    count++;
    if (isThrough(along)) through++;
  }
  return through / count;
}

interface Level {
  readonly height: number;
  /** Part of the width over which it was seen. */
  readonly share: number;
}

/** The height at which most of some points lie, and how much of a width they cover. */
function levelOf({ along, high }: WallStrip, points: readonly number[], width: number): Level {
  if (points.length < FEWEST) return { height: Number.NaN, share: 0 };
  const level = densest(points.map((i) => high[i]));
  const on = points.filter((i) => Math.abs(high[i] - level) <= LEVEL_REACH);
  const bits = new Set(on.map((i) => Math.floor(along[i] / (2 * STEP))));
  return {
    height: medianOf(Float64Array.from(on, (i) => high[i])),
    share: on.length < FEWEST ? 0 : Math.min(1, (bits.size * 2 * STEP) / width),
  };
}

/** Middle of the stretch of twice {@link LEVEL_REACH} that holds most values. */
function densest(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  let [best, most, low] = [sorted[0], 0, 0];
  for (let k = 0; k < sorted.length; k++) {
    while (sorted[k] - sorted[low] > 2 * LEVEL_REACH) low++;
    if (k - low + 1 > most) {
      most = k - low + 1;
      best = (sorted[k] + sorted[low]) / 2;
    }
  }
  return best;
}

/** Heights between which no face stands over most of a width, around eye height. */
function faceHeights(
  { strip, thickness, ceiling }: WallLook,
  { begin, end, band }: { readonly begin: number; readonly end: number; readonly band: number },
) {
  const rows = Math.ceil(ceiling / STEP);
  const columns = Math.max(1, Math.floor((end - begin) / STEP));
  const hits = new Uint8Array(rows * columns);
  for (let i = 0; i < strip.count; i++) {
    const isOn = Math.abs(strip.deep[i]) <= band || Math.abs(strip.deep[i] - thickness) <= band;
    if (
      !isOn ||
      strip.along[i] < begin ||
      strip.along[i] >= end ||
      strip.high[i] < 0 ||
      strip.high[i] >= ceiling
    )
      continue;
    const column = Math.min(columns - 1, Math.floor((strip.along[i] - begin) / STEP));
    hits[Math.min(rows - 1, Math.floor(strip.high[i] / STEP)) * columns + column] = 1;
  }
  const isWall = Array.from({ length: rows }, (_, r) => {
    let sum = 0;
    for (let c = 0; c < columns; c++) sum += hits[r * columns + c];
    return sum >= 0.4 * columns;
  });
  const middle = Math.round((LOOK_FROM + LOOK_TO) / 2 / STEP);
  let top = middle;
  while (top < rows && !isWall[top]) top++;
  let bottom = middle;
  while (bottom >= 0 && !isWall[bottom]) bottom--;
  return { head: top >= rows ? ceiling : top * STEP, sill: bottom < 0 ? 0 : (bottom + 1) * STEP };
}

/** A hole of a stretch of wall in the plan, its line `deep` behind the face, m. */
export function placeOpening(
  { type, from, to, sill, head, confidence }: FoundOpening,
  { x, y, ux, uy }: WallStretch,
  deep: number,
): Opening {
  const at = (along: number) => [x + along * ux + deep * uy, y + along * uy - deep * ux] as const;
  return { type, from: at(from), to: at(to), sill, head, confidence };
}
