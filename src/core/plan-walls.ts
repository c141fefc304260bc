import { Clipper64, ClipType, FillRule, type Paths64 } from 'clipper2-ts';
import { ClipGrid, offsetPaths } from './geometry/clip-grid.ts';
import { nestPaths } from './geometry/nest-paths.ts';
import { signedArea } from './geometry/rings.ts';
import type { Options } from './params.ts';
import type { Polygon, Ring } from './types.ts';

/** Corners are mitred up to this many offsets away, which takes angles down to 60°; sharper ones are squared. */
const MITRE_LIMIT = 2;
/** A ring thinner than this on average, m, is debris of rounding. */
const DEBRIS_WIDTH = 1e-5;

/** Metres of pen to both sides of the line it follows; together more than 0. */
export interface PenReach {
  readonly outside: number;
  readonly inside: number;
}

/** The pen that draws walls. */
export function penReach({ wallThickness, wallSide }: Pick<Options, 'wallThickness' | 'wallSide'>): PenReach {
  return wallSide === 'centre'
    ? { outside: wallThickness / 2, inside: wallThickness / 2 }
    : { outside: wallThickness, inside: 0 };
}

/**
 * The contour of a polygon drawn with a pen of some width: what a canvas stroke would cover ([Stojanovic19]
 * §3), as areas.
 *
 * Where the contour closes over a courtyard or a narrow room it fills it. Vertices of the polygon that are
 * vertices of the contour keep their coordinates to the last bit; all others are within 1 µm.
 *
 * @param polygon metres; outer ring counter-clockwise, holes clockwise
 * @returns disjoint polygons, largest first
 */
export function strokeContour({ outer, holes }: Polygon, reach: PenReach): Polygon[] {
  const grid = gridOf(outer);
  const paths = [outer, ...holes].map((ring) => grid.toPath(ring));
  const clipper = new Clipper64();
  clipper.addSubject(movedPaths(paths, reach.outside));
  clipper.addClip(movedPaths(paths, -reach.inside));
  const cut: Paths64 = [];
  clipper.execute(ClipType.Difference, FillRule.NonZero, cut);
  const polygons = nestPaths(cut, (path, turn) => grid.toRing(path, turn));
  return polygons.sort((a, b) => signedArea(b.outer) - signedArea(a.outer));
}

/** Whether the pen leaves nothing free within the polygon. */
export function fillsInside({ outer, holes }: Polygon, { inside }: PenReach): boolean {
  const grid = gridOf(outer);
  const paths = [outer, ...holes].map((ring) => grid.toPath(ring));
  return movedPaths(paths, -inside).length === 0;
}

/** Vertices that went into the grid come back to the last bit. */
function gridOf(outer: Ring): ClipGrid {
  return new ClipGrid(outer, { debris: DEBRIS_WIDTH, keepsVertices: true });
}

function movedPaths(paths: Paths64, distance: number): Paths64 {
  return distance === 0 ? paths : offsetPaths(paths, distance, MITRE_LIMIT);
}
