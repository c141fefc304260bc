import {
  Clipper64,
  ClipperOffset,
  ClipType,
  EndType,
  FillRule,
  JoinType,
  type Path64,
  type Paths64,
} from 'clipper2-ts';
import type { Polygon, Ring } from '../types.ts';
import { nestPaths } from './nest-paths.ts';
import { orientRing, perimeter, polygonArea, signedArea } from './rings.ts';

/** Grid of the Booleans: steps of a micrometre, so lengths given in decimals come back digit for digit. */
export const STEPS_PER_METRE = 1e6;
/** A ring thinner than this on average is debris of rounding, not a shape. */
const DEBRIS_WIDTH = 4 / STEPS_PER_METRE;
/** Corners of grown areas are mitred up to this many distances away, which takes angles down to 30°; sharper ones are squared. */
const MITRE_LIMIT = 4;

/** Whole metres that are subtracted before rounding. */
type Origin = readonly [x: number, y: number];

type PlanarOperation = 'union' | 'difference' | 'intersection';

const CLIP_TYPES: Record<PlanarOperation, ClipType> = {
  union: ClipType.Union,
  difference: ClipType.Difference,
  intersection: ClipType.Intersection,
};

/**
 * A Boolean operation of two areas, exact on a grid of about a micrometre.
 *
 * Coordinates are rounded relative to a local origin, because the sweep is exact on integers only; clipper2-ts was
 * chosen over polygon-clipping (throws on plans), polyclip-ts (slow) and martinez (wrong).
 *
 * @param subject polygons, metres; may overlap, the area is their union
 * @param clip as `subject`
 * @returns disjoint polygons: outer rings counter-clockwise, holes clockwise, no needless vertices
 */
export function combine(
  operation: PlanarOperation,
  subject: readonly Polygon[],
  clip: readonly Polygon[] = [],
): Polygon[] {
  const first = subject[0]?.outer ?? clip[0]?.outer;
  if (first === undefined) return [];
  const origin: Origin = [Math.round(first[0]), Math.round(first[1])];
  const clipper = new Clipper64();
  clipper.preserveCollinear = false;
  clipper.addSubject(toPaths(subject, origin));
  if (clip.length > 0) clipper.addClip(toPaths(clip, origin));
  const paths: Paths64 = [];
  clipper.execute(CLIP_TYPES[operation], FillRule.Positive, paths);
  return nestPaths(paths, (path, turn) => toRing(path, origin, turn));
}

/**
 * An area grown by a distance, m, or shrunk by a negative one; corners stay corners.
 *
 * @returns as {@link combine}
 */
export function grow(polygons: readonly Polygon[], distance: number): Polygon[] {
  const whole = combine('union', polygons);
  if (whole.length === 0) return [];
  const origin: Origin = [Math.round(whole[0].outer[0]), Math.round(whole[0].outer[1])];
  const offset = new ClipperOffset(MITRE_LIMIT);
  offset.addPaths(toPaths(whole, origin), JoinType.Miter, EndType.Polygon);
  const paths: Paths64 = [];
  offset.execute(distance * STEPS_PER_METRE, paths);
  return nestPaths(paths, (path, turn) => toRing(path, origin, turn));
}

/** Area of polygons that do not overlap, m². */
export function areaOf(polygons: readonly Polygon[]): number {
  return polygons.reduce((sum, polygon) => sum + polygonArea(polygon), 0);
}

function toPaths(polygons: readonly Polygon[], origin: Origin): Paths64 {
  const paths: Paths64 = [];
  const add = (ring: Ring, turn: 'counter-clockwise' | 'clockwise') => {
    // Filled is what winds more often counter-clockwise than clockwise.
    const turned = orientRing(ring, turn);
    const path: Path64 = [];
    for (let i = 0; i < turned.length; i += 2) {
      path.push({ x: toSteps(turned[i], origin[0]), y: toSteps(turned[i + 1], origin[1]) });
    }
    paths.push(path);
  };
  for (const { outer, holes } of polygons) {
    add(outer, 'counter-clockwise');
    for (const hole of holes) add(hole, 'clockwise');
  }
  return paths;
}

const toSteps = (metres: number, origin: number): number => Math.round((metres - origin) * STEPS_PER_METRE);
/** One division, so the result is the double nearest to the decimal. */
const toMetres = (steps: number, origin: number): number =>
  (origin * STEPS_PER_METRE + steps) / STEPS_PER_METRE;

function toRing(path: Path64, origin: Origin, turn: 'counter-clockwise' | 'clockwise'): Ring | null {
  const ring = Float64Array.from(
    path.flatMap(({ x, y }) => [toMetres(x, origin[0]), toMetres(y, origin[1])]),
  );
  const isDebris = path.length < 3 || Math.abs(signedArea(ring)) < (perimeter(ring) / 2) * DEBRIS_WIDTH;
  return isDebris ? null : orientRing(ring, turn);
}
