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
import { STEPS_PER_METRE } from './geometry/areas.ts';
import { nestPaths } from './geometry/nest-paths.ts';
import { orientRing, perimeter, signedArea } from './geometry/rings.ts';
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
  const grid = new LocalGrid(outer);
  const paths = [outer, ...holes].map((ring) => grid.toPath(ring));
  const clipper = new Clipper64();
  clipper.addSubject(offsetPaths(paths, reach.outside));
  clipper.addClip(offsetPaths(paths, -reach.inside));
  const cut: Paths64 = [];
  clipper.execute(ClipType.Difference, FillRule.NonZero, cut);
  const polygons = nestPaths(cut, (path, turn) => grid.toRing(path, turn));
  return polygons.sort((a, b) => signedArea(b.outer) - signedArea(a.outer));
}

/** Whether the pen leaves nothing free within the polygon. */
export function fillsInside({ outer, holes }: Polygon, { inside }: PenReach): boolean {
  const grid = new LocalGrid(outer);
  return (
    offsetPaths(
      [outer, ...holes].map((ring) => grid.toPath(ring)),
      -inside,
    ).length === 0
  );
}

function offsetPaths(paths: Paths64, distance: number): Paths64 {
  if (distance === 0) return paths;
  const offset = new ClipperOffset(MITRE_LIMIT);
  offset.addPaths(paths, JoinType.Miter, EndType.Polygon);
  const grown: Paths64 = [];
  offset.execute(distance * STEPS_PER_METRE, grown);
  return grown;
}

/** Metres to whole micrometres around a ring and back, vertices that went in coming back unrounded. */
class LocalGrid {
  readonly #x: number;
  readonly #y: number;
  readonly #exact = new Map<string, readonly [x: number, y: number]>();

  constructor(ring: Ring) {
    this.#x = Math.round(ring[0]);
    this.#y = Math.round(ring[1]);
  }

  toPath(ring: Ring): Path64 {
    const path: Path64 = [];
    for (let i = 0; i < ring.length; i += 2) {
      const x = Math.round((ring[i] - this.#x) * STEPS_PER_METRE);
      const y = Math.round((ring[i + 1] - this.#y) * STEPS_PER_METRE);
      path.push({ x, y });
      this.#exact.set(`${x} ${y}`, [ring[i], ring[i + 1]]);
    }
    return path;
  }

  /** Null for what rounding left over. */
  toRing(path: Path64, turn: 'counter-clockwise' | 'clockwise'): Ring | null {
    const ring = new Float64Array(2 * path.length);
    path.forEach(({ x, y }, i) => {
      const exact = this.#exact.get(`${x} ${y}`);
      ring[2 * i] = exact?.[0] ?? (this.#x * STEPS_PER_METRE + x) / STEPS_PER_METRE;
      ring[2 * i + 1] = exact?.[1] ?? (this.#y * STEPS_PER_METRE + y) / STEPS_PER_METRE;
    });
    const isDebris = path.length < 3 || Math.abs(signedArea(ring)) < (perimeter(ring) / 2) * DEBRIS_WIDTH;
    return isDebris ? null : orientRing(ring, turn);
  }
}
