import type { HullRing } from './hull-ring.ts';

/** A pocket may widen behind its mouth by this much per metre of depth: walls up to 6° off parallel. */
const WIDENING = 0.1;
/** A pocket may slant by this much per metre of depth, either way: 45°. */
const STEEPEST_SLANT = 1;
/** A pocket may take this share of the area the ring encloses. */
const LARGEST_SHARE = 0.5;
/** A mouth no wider than a thick wall, m, … */
const CAVITY_MOUTH = 0.5;
/**
 * … with a pocket deeper than this many mouths, leads into the hollow between a wall's two faces. A shaft as narrow and
 * deep looks the same from its points, and is closed too.
 */
export const CAVITY_DEPTHS = 4;

/**
 * An edge under trial: what lies behind it is opened to the end, and then judged.
 *
 * Behind the mouth of a recess its scanned sides keep the outline within a strip that starts from the mouth, straight
 * or slanting. Behind a gap in a wall lies a room, wider than the gap: the outline fits no such strip, or what it
 * holds on to is thin air.
 */
export interface Pocket {
  readonly ax: number;
  readonly ay: number;
  /** Along the mouth; the depth direction is (-uy, ux). */
  readonly ux: number;
  readonly uy: number;
  readonly length: number;
  /** How far beside the mouth noise may put a point, m. */
  readonly tolerance: number;
  /** Area of the ring before, m². */
  readonly areaBefore: number;
  /** Pockets around it. */
  readonly level: number;
  readonly outer: Pocket | null;
  /** Slants (sideways per depth) of the strips that hold all points so far. */
  leastSlant: number;
  mostSlant: number;
  depth: number;
}

/** A pocket before anything is opened. */
export function startPocket(
  { grid: { x, y }, next }: HullRing,
  a: number,
  facts: Pick<Pocket, 'length' | 'tolerance' | 'areaBefore' | 'outer'>,
): Pocket {
  const b = next[a];
  const { length, tolerance, areaBefore, outer } = facts;
  return {
    ax: x[a],
    ay: y[a],
    ux: (x[b] - x[a]) / length,
    uy: (y[b] - y[a]) / length,
    length,
    tolerance,
    areaBefore,
    level: outer === null ? 0 : outer.level + 1,
    outer,
    leastSlant: -STEEPEST_SLANT,
    mostSlant: STEEPEST_SLANT,
    depth: 0,
  };
}

/** Whether the pocket, and every pocket around it, still fits a strip with point p in it. */
export function fits(pocket: Pocket | null, { grid }: HullRing, p: number): boolean {
  for (let at = pocket; at !== null; at = at.outer) {
    const along = alongMouth(at, grid.x[p], grid.y[p]);
    const depth = depthBehind(at, grid.x[p], grid.y[p]);
    const least = Math.max(at.leastSlant, leastSlantFor(at, along, depth));
    if (least > Math.min(at.mostSlant, mostSlantFor(at, along, depth))) return false;
  }
  return true;
}

/** Takes point p into the pocket and every pocket around it. */
export function takeIn(pocket: Pocket | null, { grid }: HullRing, p: number): void {
  for (let at = pocket; at !== null; at = at.outer) {
    const along = alongMouth(at, grid.x[p], grid.y[p]);
    const depth = depthBehind(at, grid.x[p], grid.y[p]);
    at.leastSlant = Math.max(at.leastSlant, leastSlantFor(at, along, depth));
    at.mostSlant = Math.min(at.mostSlant, mostSlantFor(at, along, depth));
    at.depth = Math.max(at.depth, depth);
  }
}

/** What points taken in have changed in the pockets around one, to {@link restore} it. */
export function snapshot(outer: Pocket | null): number[] {
  const values: number[] = [];
  for (let at = outer; at !== null; at = at.outer) values.push(at.leastSlant, at.mostSlant, at.depth);
  return values;
}

export function restore(outer: Pocket | null, values: readonly number[]): void {
  let k = 0;
  for (let at = outer; at !== null; at = at.outer) {
    at.leastSlant = values[k++];
    at.mostSlant = values[k++];
    at.depth = values[k++];
  }
}

function alongMouth({ ax, ay, ux, uy }: Pocket, x: number, y: number): number {
  return (x - ax) * ux + (y - ay) * uy;
}

function depthBehind({ ax, ay, ux, uy }: Pocket, x: number, y: number): number {
  return Math.max(0, (y - ay) * ux - (x - ax) * uy);
}

/** The least slant of a strip that holds a point; beyond the steepest when none does. */
function leastSlantFor({ length, tolerance }: Pocket, along: number, depth: number): number {
  const right = along - length - tolerance;
  if (depth === 0) return right > 0 ? STEEPEST_SLANT + 1 : -STEEPEST_SLANT;
  return right / depth - WIDENING;
}

/** The most one, likewise. */
function mostSlantFor({ tolerance }: Pocket, along: number, depth: number): number {
  const left = along + tolerance;
  if (depth === 0) return left < 0 ? -STEEPEST_SLANT - 1 : STEEPEST_SLANT;
  return left / depth + WIDENING;
}

/** Whether a pocket takes more of the ring than a recess would: the room itself. */
export function isWholeRoom({ areaBefore }: Pocket, area: number): boolean {
  return areaBefore - area > LARGEST_SHARE * areaBefore;
}

/** Whether a pocket is the hollow between the two faces of a wall. */
export function isCavity({ length, depth }: Pocket): boolean {
  return length <= CAVITY_MOUTH && depth > CAVITY_DEPTHS * length;
}
