import { convexHullOfSorted } from '../geometry/convex-hull.ts';
import { buildPointGrid, type PointGrid } from '../geometry/point-grid.ts';
import { orientation } from '../geometry/predicates.ts';
import { boundsOf } from '../geometry/rings.ts';
import { SegmentGrid } from '../geometry/segment-grid.ts';
import { segmentsTouch } from '../geometry/segments.ts';
import type { Ring } from '../types.ts';

/** Point cells a segment cell is wide: few cells for a long edge, few edges a cell. */
const SEGMENT_CELL = 4;
/** Cell edge in mean spacings: about ten points a cell in an evenly filled area. */
const CELL_SPACINGS = 3;

/**
 * A ring being opened: a subset of the points of a grid, linked counter-clockwise. An edge goes by its first point.
 */
export interface HullRing {
  readonly grid: PointGrid;
  /** Next and previous point on the ring; -1 for points that are not on it. */
  readonly next: Int32Array;
  readonly previous: Int32Array;
  /** Every edge the ring ever had; those with `next[u] === v` still count. */
  readonly edges: SegmentGrid;
}

/**
 * The convex hull of points as a ring to open.
 *
 * @param sorted distinct points in lexicographic order, so that nothing depends on the order given
 */
export function startFromConvexHull(sorted: Float64Array, spacing: number): HullRing {
  const grid = buildPointGrid(sorted, CELL_SPACINGS * spacing);
  const n = grid.x.length;
  const next = new Int32Array(n).fill(-1);
  const previous = new Int32Array(n).fill(-1);
  const edges = new SegmentGrid(grid.x, grid.y, boundsOf(sorted), SEGMENT_CELL * grid.cell);
  const placeOf = new Uint32Array(n);
  for (let i = 0; i < n; i++) placeOf[grid.source[i]] = i;
  const hull = convexHullOfSorted(sorted).map((point) => placeOf[point]);
  for (let k = 0; k < hull.length; k++) {
    const a = hull[k];
    const b = hull[(k + 1) % hull.length];
    next[a] = b;
    previous[b] = a;
    edges.add(a, b);
  }
  return { grid, next, previous, edges };
}

/** Puts p between a and next[a]. */
export function insertPoint({ next, previous, edges }: HullRing, a: number, p: number): void {
  const b = next[a];
  next[a] = p;
  previous[p] = a;
  next[p] = b;
  previous[b] = p;
  edges.add(a, p);
  edges.add(p, b);
}

/** Takes p off the ring again; the edge it had opened is still in the index. */
export function removePoint({ next, previous }: HullRing, p: number): void {
  const a = previous[p];
  const b = next[p];
  next[a] = b;
  previous[b] = a;
  next[p] = -1;
  previous[p] = -1;
}

/** Whether a → p → b in place of the edge a → b would touch the ring anywhere but in a and b. Exact. */
export function isBlocked(hull: HullRing, a: number, p: number, b: number): boolean {
  return meetsRing(hull, a, p, a, b) || meetsRing(hull, b, p, a, b);
}

/** Whether the segment from ring point `from` to p touches the ring beyond `from`, the edge a → b left out. */
function meetsRing(hull: HullRing, from: number, p: number, a: number, b: number): boolean {
  const { grid, next, edges } = hull;
  const { x, y } = grid;
  const count = edges.along(from, p);
  const { u: firsts, v: seconds, found } = edges;
  const left = Math.min(x[from], x[p]);
  const right = Math.max(x[from], x[p]);
  for (let k = 0; k < count; k++) {
    const u = firsts[found[k]];
    const v = seconds[found[k]];
    if (next[u] !== v || (u === a && v === b)) continue;
    if ((x[u] < left && x[v] < left) || (x[u] > right && x[v] > right)) continue;
    if (u === from || v === from) {
      if (isAlong(grid, from, p, u === from ? v : u)) return true;
    } else if (segmentsTouch(x[from], y[from], x[p], y[p], x[u], y[u], x[v], y[v])) return true;
  }
  return false;
}

/** Whether p and q lie in the same direction from `from`, exactly. */
function isAlong({ x, y }: PointGrid, from: number, p: number, q: number): boolean {
  if (orientation(x[from], y[from], x[p], y[p], x[q], y[q]) !== 0) return false;
  return (x[p] - x[from]) * (x[q] - x[from]) + (y[p] - y[from]) * (y[q] - y[from]) > 0;
}

/** Length of the edge a → next[a]. */
export function lengthOf({ grid: { x, y }, next }: HullRing, a: number): number {
  const dx = x[next[a]] - x[a];
  const dy = y[next[a]] - y[a];
  return Math.sqrt(dx * dx + dy * dy);
}

/** Signed area of three points, positive counter-clockwise. */
export function triangleArea({ grid: { x, y } }: HullRing, a: number, b: number, c: number): number {
  return ((x[b] - x[a]) * (y[c] - y[a]) - (x[c] - x[a]) * (y[b] - y[a])) / 2;
}

/** Some point on the ring: the first in grid order. */
export function firstPoint({ next }: HullRing): number {
  let point = 0;
  while (next[point] < 0) point++;
  return point;
}

/** The points on the ring in order, from the first in grid order. */
export function ringPoints(hull: HullRing): number[] {
  const first = firstPoint(hull);
  const points = [first];
  for (let at = hull.next[first]; at !== first; at = hull.next[at]) points.push(at);
  return points;
}

/** The ring's coordinates, from its first point in grid order. */
export function coordinatesOf(hull: HullRing): Ring {
  const { x, y } = hull.grid;
  const points = ringPoints(hull);
  const ring = new Float64Array(2 * points.length);
  for (let k = 0; k < points.length; k++) {
    ring[2 * k] = x[points[k]];
    ring[2 * k + 1] = y[points[k]];
  }
  return ring;
}
