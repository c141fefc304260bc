import { Clipper64, ClipType, FillRule, type Path64, type Paths64, PolyTree64 } from 'clipper2-ts';
import { polygonsOf } from '../core/geometry/poly-tree.ts';
import {
  type Bounds,
  boundsOfAll,
  orientRing,
  perimeter,
  polygonArea,
  ringsOf,
  signedArea,
  vertexCount,
} from '../core/geometry/rings.ts';
import { cellFor, SegmentGrid } from '../core/geometry/segment-grid.ts';
import { squaredDistanceToSegment } from '../core/geometry/segments.ts';
import type { Polygon, Ring } from '../core/types.ts';

/** Grid of the Booleans: steps of a micrometre, so lengths given in decimals come back digit for digit. */
export const STEPS_PER_METRE = 1e6;
/** A ring thinner than this on average is debris of rounding, not a shape. */
const DEBRIS_WIDTH = 4 / STEPS_PER_METRE;
/** A vertex this near an edge touches it, for all that files can tell, m: tables have 0.1 mm, GLB float32. */
const TOUCH = 2e-4;
/** Polygons of an area stand at least this far apart, m: well above what rounding sets apart that is meant to touch. */
const APART = 1e-5;
/** Half the side of the square knocked out where a polygon touches itself, m: just above what counts as touching. */
const PINCH_HALF = 2.5e-4;
/** Knocking out one pinch may make another; a handful of rounds has always been enough in the fuzz tests. */
export const PINCH_ROUNDS = 4;

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
  const tree = new PolyTree64();
  clipper.execute(CLIP_TYPES[operation], FillRule.Positive, tree);
  return polygonsOf(tree, (path, turn) => toRing(path, origin, turn));
}

/**
 * Makes an area fit for extrusion and for files: no vertex lies on another edge or vertex.
 *
 * Where rings touch, the extruded edge would have four faces, and rounding may even have them cross; a square of half
 * a millimetre is knocked out there.
 *
 * @param scale makes what counts as touching and the squares so many times larger
 */
export function separatePinches(polygons: readonly Polygon[], scale = 1): Polygon[] {
  let current = [...polygons];
  for (let round = 0; round < PINCH_ROUNDS; round++) {
    const pinches = pinchesOf(current, scale);
    if (pinches.length === 0) break;
    current = combine('difference', current, pinches);
  }
  return current;
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

/** Squares around the vertices of an area that lie on an edge they do not belong to. Near-linear by a grid over the edges. */
export function pinchesOf(polygons: readonly Polygon[], scale = 1): Polygon[] {
  const edges = edgesOf(polygons);
  const { x, y, polygonOf } = edges;
  if (x.length === 0) return [];
  const grid = gridOver(edges, boundsOfAll(ringsOf(polygons)));
  const half = scale * PINCH_HALF;
  const pinches: Polygon[] = [];
  for (let v = 0; v < x.length; v++) {
    const count = grid.around(x[v], y[v], scale * TOUCH);
    let isPinch = false;
    for (let k = 0; k < count && !isPinch; k++) {
      const [a, b] = [grid.u[grid.found[k]], grid.v[grid.found[k]]];
      if (a === v || b === v) continue;
      const reach = polygonOf[a] === polygonOf[v] ? scale * TOUCH : APART;
      isPinch = squaredDistanceToSegment(x[v], y[v], x[a], y[a], x[b], y[b]) < reach * reach;
    }
    if (isPinch) pinches.push({ outer: squareAround(x[v], y[v], half), holes: [] });
  }
  return pinches;
}

/** Edges by their first vertex. */
interface Edges {
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** The edge that starts where this one ends. */
  readonly next: Int32Array;
  readonly polygonOf: Int32Array;
}

function edgesOf(polygons: readonly Polygon[]): Edges {
  const count = vertexCount(polygons);
  const [x, y] = [new Float64Array(count), new Float64Array(count)];
  const [next, polygonOf] = [new Int32Array(count), new Int32Array(count)];
  let first = 0;
  polygons.forEach((polygon, p) => {
    for (const ring of ringsOf([polygon])) {
      const size = ring.length / 2;
      for (let k = 0; k < size; k++) {
        x[first + k] = ring[2 * k];
        y[first + k] = ring[2 * k + 1];
        next[first + k] = first + ((k + 1) % size);
        polygonOf[first + k] = p;
      }
      first += size;
    }
  });
  return { x, y, next, polygonOf };
}

function gridOver({ x, y, next }: Edges, bounds: Bounds): SegmentGrid {
  const grid = new SegmentGrid(x, y, bounds, cellFor(bounds, x.length));
  for (let e = 0; e < x.length; e++) grid.add(e, next[e]);
  return grid;
}

const squareAround = (x: number, y: number, half: number): Ring =>
  Float64Array.of(x - half, y - half, x + half, y - half, x + half, y + half, x - half, y + half);
