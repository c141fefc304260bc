import { medianOf } from '../frame/robust-scale.ts';
import type { WallStrip } from './wall-strip.ts';

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
}

/**
 * Doors, windows and passages of a stretch of wall.
 *
 * A void at eye height in every face of the wall is an opening where points within the wall show its reveals, or where the
 * scan sees through both faces; otherwise something hides the wall. Jambs, head and sill are then read off the reveals.
 * O(points).
 */
export function findOpenings(look: WallLook): FoundOpening[] {
  const { strip, length, thickness, noise } = look;
  const band = Math.min(Math.max(ON_FACE, 3 * noise), Number.isFinite(thickness) ? thickness / 2 : Infinity);
  const isFace = (d: number) => Math.abs(d) <= band;
  const isBack = (d: number) => Math.abs(d - thickness) <= band;
  const front = standing(strip, length, isFace);
  const back = Number.isFinite(thickness) ? standing(strip, length, isBack) : front;
  const isVoid = front.map((share, k) => (share <= STANDING && back[k] <= STANDING ? 1 : 0));
  const inner = reveals(look, band);
  return runsOf(isVoid).flatMap(([from, to]) => openingAt(look, inner, { from: from * STEP, to: to * STEP, band }) ?? []);
}

/** Share of the bits at eye height that have points, for each bit along a face. */
function standing({ count, along, deep, high }: WallStrip, length: number, isOn: (d: number) => boolean): Float64Array {
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

/** Points within the wall. */
function reveals({ strip, thickness, ceiling }: WallLook, band: number): number[] {
  const inside: number[] = [];
  const deepest = Number.isFinite(thickness) ? thickness - band / 2 : Infinity;
  for (let i = 0; i < strip.count; i++) {
    if (strip.deep[i] <= band / 2 || strip.deep[i] >= deepest) continue;
    if (strip.high[i] < 0.1 || strip.high[i] > ceiling - 0.1) continue;
    inside.push(i);
  }
  return inside;
}

interface VoidRun {
  readonly from: number;
  readonly to: number;
  readonly band: number;
}

function openingAt(look: WallLook, inner: readonly number[], { from, to, band }: VoidRun): FoundOpening | null {
  const { strip, thickness, ceiling } = look;
  if (to - from < NARROWEST - 2 * STEP || to - from > WIDEST) return null;
  const near = inner.filter((i) => strip.along[i] > from - JAMB_REACH && strip.along[i] < to + JAMB_REACH);
  const left = jambAt(strip, near, from);
  const right = jambAt(strip, near, to);
  const [begin, end] = [left ?? faceEnd(look, from, band, -1), right ?? faceEnd(look, to, band, 1)];
  if (end - begin < NARROWEST) return null;
  const margin = Math.min(0.1, (end - begin) / 4);
  const between = near.filter((i) => strip.along[i] > begin + margin && strip.along[i] < end - margin);
  const headLevel = levelOf(between.map((i) => strip.high[i]).filter((z) => z > LOOK_TO - 0.05));
  const sillLevel = levelOf(between.map((i) => strip.high[i]).filter((z) => z < LOOK_FROM + 0.05));
  const isPaired = Number.isFinite(thickness);
  const evidence = [left, right, headLevel, sillLevel].filter((part) => part !== null).length;
  if (evidence < (isPaired ? 1 : 2)) return null;
  const { sill, head } = heightsOf(look, { begin: begin + margin, end: end - margin, band }, headLevel, sillLevel);
  if (head - sill < 0.3) return null;
  const isLow = sill <= DOOR_SILL && head >= LEAST_HEAD;
  const type = !isLow ? 'window' : ceiling - head <= NO_LINTEL ? 'passage' : 'door';
  const depths = near.map((i) => strip.deep[i]).sort((a, b) => a - b);
  const reveal = depths.length >= FEWEST ? depths[Math.floor(0.98 * (depths.length - 1))] : Number.NaN;
  return { type, from: begin, to: end, sill: isLow ? 0 : sill, head, reveal, confidence: Math.min(1, evidence / 3) };
}

/** Where the reveal beside a void's end stands, by its points. */
function jambAt({ along, high }: WallStrip, near: readonly number[], end: number): number | null {
  const beside = near.filter((i) => Math.abs(along[i] - end) <= JAMB_REACH && high[i] > 0.2 && high[i] < LOOK_TO + 0.1);
  if (beside.length < FEWEST) return null;
  const place = densest(beside.map((i) => along[i]));
  const on = beside.filter((i) => Math.abs(along[i] - place) <= 0.03);
  const heights = on.map((i) => high[i]);
  if (on.length < FEWEST || Math.max(...heights) - Math.min(...heights) < LEAST_JAMB) return null;
  return medianOf(Float64Array.from(on, (i) => along[i]));
}

/** Middle of the six centimetres that hold most values. */
function densest(values: readonly number[]): number {
  const sorted = Float64Array.from(values).sort();
  let [best, most, low] = [sorted[0], 0, 0];
  for (let k = 0; k < sorted.length; k++) {
    while (sorted[k] - sorted[low] > 0.06) low++;
    if (k - low + 1 > most) {
      most = k - low + 1;
      best = (sorted[k] + sorted[low]) / 2;
    }
  }
  return best;
}

/** Where the faces end beside a void. */
function faceEnd({ strip, thickness }: WallLook, end: number, band: number, side: 1 | -1): number {
  let best = end;
  let gap = Infinity;
  for (let i = 0; i < strip.count; i++) {
    if (strip.high[i] < LOOK_FROM || strip.high[i] > LOOK_TO) continue;
    const isOn = Math.abs(strip.deep[i]) <= band || Math.abs(strip.deep[i] - thickness) <= band;
    const beyond = side * (strip.along[i] - end) + 2 * STEP;
    if (!isOn || beyond < 0 || beyond > gap) continue;
    gap = beyond;
    best = strip.along[i];
  }
  return best;
}

/** The height at which most of some points lie, if enough do. */
function levelOf(heights: readonly number[]): number | null {
  if (heights.length < FEWEST) return null;
  const level = densest(heights);
  const on = heights.filter((z) => Math.abs(z - level) <= 0.03);
  return on.length >= FEWEST ? medianOf(Float64Array.from(on)) : null;
}

/** Sill and head: read off the reveals, else from where the faces go on. */
function heightsOf(
  look: WallLook,
  { begin, end, band }: { readonly begin: number; readonly end: number; readonly band: number },
  headLevel: number | null,
  sillLevel: number | null,
) {
  const { strip, thickness, ceiling } = look;
  const rows = Math.ceil(ceiling / STEP);
  const columns = Math.max(1, Math.floor((end - begin) / STEP));
  const hits = new Uint8Array(rows * columns);
  for (let i = 0; i < strip.count; i++) {
    const isOn = Math.abs(strip.deep[i]) <= band || Math.abs(strip.deep[i] - thickness) <= band;
    if (!isOn || strip.along[i] < begin || strip.along[i] >= end || strip.high[i] < 0 || strip.high[i] >= ceiling) continue;
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
  const headByFace = top >= rows ? ceiling : top * STEP;
  const sillByFace = bottom < 0 ? 0 : (bottom + 1) * STEP;
  const head = headLevel !== null && Math.abs(headLevel - headByFace) < 0.3 ? headLevel : headByFace;
  const sill = sillLevel !== null && Math.abs(sillLevel - sillByFace) < 0.3 ? sillLevel : sillByFace;
  return { sill, head };
}
