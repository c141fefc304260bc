import { Clipper64, ClipType, FillRule, type Paths64 } from 'clipper2-ts';
import type { Polygon } from '../types.ts';
import { ClipGrid, offsetPaths, STEPS_PER_METRE } from './clip-grid.ts';
import { nestPaths } from './nest-paths.ts';
import { orientRing, polygonArea, vertexCount } from './rings.ts';

/** A ring thinner than this on average, m, is debris of rounding. */
const DEBRIS_WIDTH = 4 / STEPS_PER_METRE;
/** Corners of grown areas are mitred up to this many distances away, which takes angles down to 30°; sharper ones are squared. */
const MITRE_LIMIT = 4;

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
  const grid = new ClipGrid(first, { debris: DEBRIS_WIDTH });
  const clipper = new Clipper64();
  clipper.preserveCollinear = false;
  clipper.addSubject(toPaths(subject, grid));
  if (clip.length > 0) clipper.addClip(toPaths(clip, grid));
  const paths: Paths64 = [];
  clipper.execute(CLIP_TYPES[operation], FillRule.Positive, paths);
  return nestPaths(paths, (path, turn) => grid.toRing(path, turn));
}

/**
 * An area grown by a distance, m, or shrunk by a negative one; corners stay corners.
 *
 * @returns as {@link combine}
 */
export function grow(polygons: readonly Polygon[], distance: number): Polygon[] {
  const whole = combine('union', polygons);
  if (whole.length === 0) return [];
  const grid = new ClipGrid(whole[0].outer, { debris: DEBRIS_WIDTH });
  const paths = offsetPaths(toPaths(whole, grid), distance, MITRE_LIMIT);
  return nestPaths(paths, (path, turn) => grid.toRing(path, turn));
}

/** An area without gaps narrower than a width, m, within it or between its polygons; where there are none, as it was. */
export function withoutHairlines(polygons: readonly Polygon[], width: number): readonly Polygon[] {
  const filled = closed(polygons, width);
  return vertexCount(filled) < vertexCount(polygons) ? filled : polygons;
}

/** An area with all gaps narrower than a width filled, m; vertices move by steps of the grid. */
export function closed(polygons: readonly Polygon[], width: number): Polygon[] {
  return grow(grow(polygons, width / 2), -width / 2);
}

/** Area of polygons that do not overlap, m². */
export function areaOf(polygons: readonly Polygon[]): number {
  return polygons.reduce((sum, polygon) => sum + polygonArea(polygon), 0);
}

function toPaths(polygons: readonly Polygon[], grid: ClipGrid): Paths64 {
  // Filled is what winds more often counter-clockwise than clockwise.
  return polygons.flatMap(({ outer, holes }) => [
    grid.toPath(orientRing(outer, 'counter-clockwise')),
    ...holes.map((hole) => grid.toPath(orientRing(hole, 'clockwise'))),
  ]);
}
