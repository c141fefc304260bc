import type { WallStrip } from './wall-strip.ts';

/** Heights above the floor, m, at which every door and nearly every window is open and furniture seldom hides a wall. */
export const LOOK_FROM = 1.45;
export const LOOK_TO = 1.85;
/** Bits of height and length, m. */
export const STEP = 0.05;
/** Fewest points of a jamb, a head or a sill. */
export const FEWEST = 5;
/** Points this near a face are on it, m, or within so many deviations. */
const ON_FACE = 0.03;
const DEVIATIONS = 3;

/** A stretch of wall in which openings are looked for. */
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

/** Half thickness of a face, m. */
export function faceBand({ noise, thickness }: WallLook): number {
  return Math.min(Math.max(ON_FACE, DEVIATIONS * noise), thickness / 3);
}

/** Where floor or ceiling shows over this share of a width, the scan sees through. */
export const THROUGH_SHARE = 0.4;

/** A stretch along a wall, m. */
export interface Stretch {
  readonly begin: number;
  readonly end: number;
}

/** Share of a stretch over which floor or ceiling was seen within the wall. */
export function throughShare({ isThrough }: WallLook, { begin, end }: Stretch): number {
  let [through, count] = [0, 0];
  for (let along = begin; along <= end; along += STEP) {
    count++;
    if (isThrough(along)) through++;
  }
  return through / count;
}
