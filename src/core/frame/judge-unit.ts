import { cloudBounds, largestExtent, trimmedBounds } from '../cloud-bounds.ts';
import type { Options } from '../params.ts';
import { sayScale } from '../source-coordinates.ts';
import type { FrameUnit, Scan, Unit } from '../types.ts';
import { findGravity } from './gravity.ts';
import type { HeightPlane } from './height-planes.ts';
import { surfacePatches } from './surface-patches.ts';

const METRES: Readonly<Record<Exclude<Unit, 'px'>, number>> = {
  m: 1,
  cm: 0.01,
  mm: 0.001,
  ft: 0.3048,
  'us-ft': 1200 / 3937,
};
/** Tried in this order; a US survey foot cannot be told from a foot (2 ppm). */
const CANDIDATES = ['m', 'mm', 'cm', 'ft'] as const;
/** Distance from a floor to its ceiling, m: a cellar to a hall. */
const STOREY_HEIGHT = { least: 2, most: 6 };
/** Planes nearer than this to floor or ceiling, m, are tables, steps and lowered ceilings; others part two storeys. */
const HEADROOM = 1;
/** Longest side of a scanned interior, m: a closet to an airport. */
export const EXTENT = { least: 1, most: 1000 };
/** Longest side expected where no storey height tells more, m: a room to a hall. */
const USUAL_EXTENT = { least: 2, most: 200 };
/** Longest side of a canvas that a slice is drawn on, px: a 4K screen. */
const MAX_CANVAS = 4096;

/** The unit of a scan's coordinates. */
export interface JudgedUnit {
  readonly unit: FrameUnit;
  readonly metresPerUnit: number;
  /** One sentence. */
  readonly reason: string;
  /** Neither given nor stated, and not plain metres with a storey height to show for it. */
  readonly isGuess: boolean;
}

type UnitOptions = Pick<Options, 'unit' | 'metresPerUnit' | 'pixelsPerMetre' | 'up'>;
type UnitScan = Pick<Scan, 'positions' | 'isSlice' | 'unit'>;

/** The scale or unit a person gave, or the unit the file states; null where it must be judged. */
export function statedUnit(scan: Pick<Scan, 'unit'>, options: Omit<UnitOptions, 'up'>): JudgedUnit | null {
  if (options.metresPerUnit !== 'auto') return scaled(options.metresPerUnit);
  if (options.unit !== 'auto') return stated(options.unit, options, 'it was given');
  if (scan.unit !== undefined) return stated(scan.unit, options, 'the file states it');
  return null;
}

/**
 * The unit of a scan just read: given, stated, or judged from storey height and extent.
 *
 * Ours. A candidate is plausible when two of the cloud's strong horizontal planes are a storey apart; among
 * those the one with the largest planes wins. Two storeys in metres are not one in feet: what a plane halfway up covers
 * does not count. O(n), at most a million points are looked at.
 *
 * @param scan source axes and units; positions not all equal
 */
export function judgeUnit(scan: UnitScan, options: UnitOptions): JudgedUnit {
  const known = statedUnit(scan, options);
  if (known) return known;
  if (scan.isSlice) return judgeSliceUnit(scan, options);
  const bounds = cloudBounds(scan.positions);
  const isFlat = [0, 1, 2].some((axis) => bounds.max[axis] === bounds.min[axis]);
  const { positions } = scan;
  const planes = isFlat ? [] : findGravity(positions, surfacePatches(positions), options.up).planes.strong;
  return judgeUnitFrom(planes, largestExtent(trimmedBounds(positions)));
}

/**
 * Ready slices are drawn in canvas pixels ([Stojanovic19] §4), unless that would make a room smaller than a cupboard: then
 * somebody has saved metres; or the canvas larger than any screen: then millimetres.
 */
export function judgeSliceUnit({ positions }: UnitScan, options: UnitOptions): JudgedUnit {
  const pixels = stated('px', options, 'ready slices are drawn in canvas pixels');
  const extent = largestExtent(trimmedBounds(positions));
  const metres = extent * pixels.metresPerUnit;
  const unit = metres < EXTENT.least ? 'm' : extent > MAX_CANVAS ? 'mm' : 'px';
  if (unit === 'px' || !isWithin(extent * METRES[unit], USUAL_EXTENT)) return pixels;
  const reason = `The unit is taken for ${unit}: in canvas pixels the slice would be ${format(metres)} m wide.`;
  return { unit, metresPerUnit: METRES[unit], reason, isGuess: true };
}

/**
 * Judges from what {@link judgeUnit} measures.
 *
 * @param planes strong horizontal planes, source units, lowest first
 * @param extent longest side, source units
 */
export function judgeUnitFrom(planes: readonly HeightPlane[], extent: number): JudgedUnit {
  let best = { unit: 'm' as (typeof CANDIDATES)[number], area: 0, height: 0 };
  for (const unit of CANDIDATES) {
    if (!isWithin(extent * METRES[unit], EXTENT)) continue;
    const storey = largestStorey(planes, METRES[unit]);
    if (storey.area > best.area) best = { unit, ...storey };
  }
  if (best.area > 0) {
    const { unit, height } = best;
    const storey = `${format(height)} ${unit}`;
    const metres = unit === 'm' ? '' : `, ${format(height * METRES[unit])} m`;
    const reason = `The unit is ${unit}: floor and ceiling are ${storey} apart${metres}.`;
    return { unit, metresPerUnit: METRES[unit], reason, isGuess: unit !== 'm' };
  }
  const unit = CANDIDATES.find((candidate) => isWithin(extent * METRES[candidate], USUAL_EXTENT)) ?? 'm';
  const reason = `The unit is taken for ${unit}: no storey height shows, and the longest side is ${format(extent)} ${unit}.`;
  return { unit, metresPerUnit: METRES[unit], reason, isGuess: true };
}

function largestStorey(planes: readonly HeightPlane[], metresPerUnit: number) {
  let best = { area: 0, height: 0 };
  for (const low of planes) {
    for (const high of planes) {
      const height = high.height - low.height;
      if (!isWithin(height * metresPerUnit, STOREY_HEIGHT)) continue;
      const area = Math.min(low.area, high.area) - areaBetween(planes, low, high, HEADROOM / metresPerUnit);
      if (area > best.area) best = { area, height };
    }
  }
  return best;
}

/** Of the largest plane that is further than `reach` from both. */
function areaBetween(
  planes: readonly HeightPlane[],
  low: HeightPlane,
  high: HeightPlane,
  reach: number,
): number {
  const between = planes.filter(({ height }) => height - low.height > reach && high.height - height > reach);
  return Math.max(0, ...between.map(({ area }) => area));
}

function scaled(metresPerUnit: number): JudgedUnit {
  const reason = `${sayScale('custom', metresPerUnit)}: the scale was given.`;
  return { unit: 'custom', metresPerUnit, reason, isGuess: false };
}

function stated(
  unit: Unit,
  { pixelsPerMetre }: Pick<UnitOptions, 'pixelsPerMetre'>,
  why: string,
): JudgedUnit {
  const metresPerUnit = unit === 'px' ? 1 / pixelsPerMetre : METRES[unit];
  return { unit, metresPerUnit, reason: `The unit is ${unit}: ${why}.`, isGuess: false };
}

function isWithin(value: number, { least, most }: { least: number; most: number }): boolean {
  return value >= least && value <= most;
}

function format(value: number): string {
  return value.toLocaleString('en-GB', { maximumSignificantDigits: 3, useGrouping: false });
}
