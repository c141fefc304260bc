import type { PointGrid } from '../geometry/point-grid.ts';
import { orientation } from '../geometry/predicates.ts';
import type { HullRing } from './hull-ring.ts';

/** Half a cell's diagonal, in cell edges: a point lies no farther than this from its cell's centre. */
const HALF_DIAGONAL = Math.SQRT1_2 * (1 + 1e-9);
/** Depths below this share of the edge are decided by the exact predicate. */
const ROUNDING = 1e-12;

/** The edge under search as a frame: origin a, u along the edge, n to its left; and the best point so far. */
interface Search {
  readonly hull: HullRing;
  readonly a: number;
  readonly b: number;
  readonly ux: number;
  readonly uy: number;
  readonly length: number;
  readonly isLeftOut: ((p: number) => boolean) | null;
  best: number;
  /** Tangent of the best point's larger end angle. */
  slope: number;
  depth: number;
  /** Distance along the edge from the best point's foot to the nearer end. */
  inner: number;
}

/**
 * The point an edge a → b opens to [Rosén14] §3: among the points inside the ring that see the edge under two angles
 * below 90°, the one whose larger angle is smallest; of equals the nearer to the edge, then the nearer to its middle, then the first by coordinates.
 *
 * The grid is walked in slabs away from the edge, each as deep as all before. A point at depth d has a tangent of at
 * least 2d / length, so the walk ends once that passes the best found; earlier points narrow each slab to a tent.
 *
 * @param isLeftOut points not to open to
 * @returns point number, -1 for none. Touches the cells between the edge and the point found, not all points.
 */
export function findOpeningPoint(
  hull: HullRing,
  a: number,
  b: number,
  isLeftOut: ((p: number) => boolean) | null = null,
): number {
  const { grid } = hull;
  const dx = grid.x[b] - grid.x[a];
  const dy = grid.y[b] - grid.y[a];
  const length = Math.sqrt(dx * dx + dy * dy);
  if (!(length > 0)) return -1;
  const search: Search = {
    hull,
    a,
    b,
    ux: dx / length,
    uy: dy / length,
    length,
    isLeftOut,
    best: -1,
    slope: Number.POSITIVE_INFINITY,
    depth: 0,
    inner: 0,
  };
  const reach = HALF_DIAGONAL * grid.cell;
  const deepest = greatestDepth(grid, search) + reach;
  let from = -reach;
  let to = grid.cell;
  while (from <= deepest) {
    const least = from - reach;
    if (least > 0 && 2 * least >= search.slope * length) break;
    scanSlab(search, from, to, least > 0 ? least / search.slope : 0);
    const useful = (search.slope * length) / 2 + reach;
    from = to;
    to = Math.min(2 * to, Math.max(useful, to + grid.cell));
  }
  return search.best;
}

/** Depth of the farthest corner of the grid's box. */
function greatestDepth(grid: PointGrid, { a, ux, uy }: Search): number {
  const left = grid.minX - grid.x[a];
  const low = grid.minY - grid.y[a];
  const width = grid.columns * grid.cell;
  const height = grid.rows * grid.cell;
  return (uy > 0 ? -uy * left : -uy * (left + width)) + (ux > 0 ? ux * (low + height) : ux * low);
}

/**
 * Weighs the points of all cells whose centre lies at a depth of `from` to `to` over the edge, `margin` in from its
 * ends. Row by row: the cells of a row are one run of points.
 */
function scanSlab(search: Search, from: number, to: number, margin: number): void {
  const { hull, a, ux, uy, length } = search;
  const { x, y, start, columns, rows, minX, minY, cell } = hull.grid;
  const reach = HALF_DIAGONAL * cell;
  const near = margin - reach;
  const far = length - margin + reach;
  if (near > far) return;
  // Cell centres relative to a, in cells: column i has x offset i + offsetX.
  const offsetX = (minX - x[a]) / cell + 0.5;
  const offsetY = (minY - y[a]) / cell + 0.5;
  const lowY = Math.min(near * uy, far * uy) + Math.min(from * ux, to * ux);
  const highY = Math.max(near * uy, far * uy) + Math.max(from * ux, to * ux);
  const firstRow = Math.max(0, Math.ceil(lowY / cell - offsetY));
  const lastRow = Math.min(rows - 1, Math.floor(highY / cell - offsetY));
  // Columns a metre of depth or of way along the edge; an edge within rounding of an axis bounds no columns by it.
  const perDepth = 1 / (uy * cell);
  const perWay = 1 / (ux * cell);
  const isLevel = !Number.isFinite(perDepth);
  const isUpright = !Number.isFinite(perWay);
  for (let row = firstRow; row <= lastRow; row++) {
    const dy = (row + offsetY) * cell;
    let low = offsetX;
    let high = columns - 1 + offsetX;
    // Depth of a centre: dy·ux - dx·uy, in [from, to]; place along the edge: dx·ux + dy·uy, in [near, far].
    if (isLevel) {
      if (dy * ux < from || dy * ux > to) continue;
    } else {
      const one = (dy * ux - from) * perDepth;
      const other = (dy * ux - to) * perDepth;
      low = Math.max(low, Math.min(one, other));
      high = Math.min(high, Math.max(one, other));
    }
    if (isUpright) {
      if (dy * uy < near || dy * uy > far) continue;
    } else {
      const one = (near - dy * uy) * perWay;
      const other = (far - dy * uy) * perWay;
      low = Math.max(low, Math.min(one, other));
      high = Math.min(high, Math.max(one, other));
    }
    const firstColumn = Math.max(0, Math.ceil(low - offsetX));
    const lastColumn = Math.min(columns - 1, Math.floor(high - offsetX));
    if (firstColumn > lastColumn) continue;
    weighPoints(search, start[row * columns + firstColumn], start[row * columns + lastColumn + 1]);
  }
}

/** Takes the best of a run of points that are not on the ring. */
function weighPoints(search: Search, from: number, to: number): void {
  const { hull, a, b, ux, uy, length } = search;
  const { x, y } = hull.grid;
  const { next } = hull;
  const ax = x[a];
  const ay = y[a];
  for (let k = from; k < to; k++) {
    const dx = x[k] - ax;
    const dy = y[k] - ay;
    const along = dx * ux + dy * uy;
    const inner = along + along < length ? along : length - along;
    if (inner <= 0) continue;
    const depth = dy * ux - dx * uy;
    if (depth > search.slope * inner || next[k] >= 0) continue;
    if (depth <= ROUNDING * length && orientation(ax, ay, x[b], y[b], x[k], y[k]) < 0) continue;
    const slope = Math.max(0, depth) / inner;
    if (slope === search.slope && !isBefore(search, k, depth, inner)) continue;
    if (search.isLeftOut?.(k)) continue;
    search.best = k;
    search.slope = slope;
    search.depth = depth;
    search.inner = inner;
  }
}

/** Whether point k, as good as the best, comes before it. */
function isBefore(search: Search, k: number, depth: number, inner: number): boolean {
  const { hull, best } = search;
  const { x, y } = hull.grid;
  if (best < 0 || depth !== search.depth) return depth < search.depth;
  if (inner !== search.inner) return inner > search.inner;
  return x[k] !== x[best] ? x[k] < x[best] : y[k] < y[best];
}
