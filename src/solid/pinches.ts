import { combine } from '../core/geometry/areas.ts';
import { type Bounds, boundsOfAll, ringsOf, vertexCount } from '../core/geometry/rings.ts';
import { cellFor, SegmentGrid } from '../core/geometry/segment-grid.ts';
import { squaredDistanceToSegment } from '../core/geometry/segments.ts';
import type { Polygon, Ring } from '../core/types.ts';

/** A vertex this near an edge touches it, for all that files can tell, m: tables have 0.1 mm, GLB float32. */
const TOUCH = 2e-4;
/** Polygons of an area stand at least this far apart, m: well above what rounding sets apart that is meant to touch. */
const APART = 1e-5;
/** Half the side of the square knocked out where a polygon touches itself, m: just above what counts as touching. */
const PINCH_HALF = 2.5e-4;
/** Knocking out one pinch may make another; a handful of rounds has always been enough in the fuzz tests. */
export const PINCH_ROUNDS = 4;

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
