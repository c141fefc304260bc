import { boundsOf } from './rings.ts';

/** Points per cell aimed at over the bounding box: cells stay fewer than points, so an empty box costs little. */
const POINTS_PER_CELL = 0.5;

/**
 * A uniform grid over points. Points are kept in cell order, row by row, so the points of neighbouring cells of a
 * row are one contiguous run: those of cells (column a … b, row r) are `start[r · columns + a]` to
 * `start[r · columns + b + 1]`.
 */
export interface PointGrid {
  /** Coordinates in cell order. */
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Number each point had in the input. */
  readonly source: Uint32Array;
  /** First point of each cell; one entry more than cells. */
  readonly start: Uint32Array;
  readonly columns: number;
  readonly rows: number;
  readonly minX: number;
  readonly minY: number;
  /** Cell edge. */
  readonly cell: number;
}

/**
 * Sorts points into a {@link PointGrid} by counting; within a cell the input order is kept.
 *
 * @param xy x, y a point; finite, at least one
 * @param cell wished cell edge; coarsened until cells are at most twice the points. O(n).
 */
export function buildPointGrid(xy: Float64Array, cell = 0): PointGrid {
  const n = xy.length >> 1;
  const { minX, minY, maxX, maxY } = boundsOf(xy);
  const edge = cellEdge(maxX - minX, maxY - minY, n, cell);
  const columns = Math.floor((maxX - minX) / edge) + 1;
  const rows = Math.floor((maxY - minY) / edge) + 1;
  const start = new Uint32Array(columns * rows + 1);
  const cellOf = new Uint32Array(n);
  for (let i = 0; i < n; i++) {
    const column = Math.floor((xy[2 * i] - minX) / edge);
    const row = Math.floor((xy[2 * i + 1] - minY) / edge);
    cellOf[i] = row * columns + column;
    start[cellOf[i] + 1]++;
  }
  for (let c = 0; c < columns * rows; c++) start[c + 1] += start[c];
  const x = new Float64Array(n);
  const y = new Float64Array(n);
  const source = new Uint32Array(n);
  const next = start.slice(0, columns * rows);
  for (let i = 0; i < n; i++) {
    const at = next[cellOf[i]]++;
    x[at] = xy[2 * i];
    y[at] = xy[2 * i + 1];
    source[at] = i;
  }
  return { x, y, source, start, columns, rows, minX, minY, cell: edge };
}

/** The wished edge, or the smallest that keeps cells within twice the points; 1 for a box without extent. */
function cellEdge(width: number, height: number, n: number, wished: number): number {
  const byArea = Math.sqrt((width * height * POINTS_PER_CELL) / n);
  const byLength = (Math.max(width, height) * POINTS_PER_CELL) / n;
  return Math.max(wished, byArea, byLength) || 1;
}

/**
 * Squared distance from point `i` (cell order) to its nearest other point, by rings of cells growing around it.
 *
 * The grid must be built from points sorted by x.
 *
 * @returns infinity for a single point
 */
export function squaredDistanceToNearest(grid: PointGrid, i: number): number {
  const { x, y, columns, rows, cell } = grid;
  const column = Math.floor((x[i] - grid.minX) / cell);
  const row = Math.floor((y[i] - grid.minY) / cell);
  const reach = Math.max(column, columns - 1 - column, row, rows - 1 - row);
  let best = Number.POSITIVE_INFINITY;
  for (let ring = 0; ring <= reach; ring++) {
    // Cells of this ring lie at least ring - 1 edges away.
    const bound = (ring - 1) * cell;
    if (ring > 1 && bound * bound >= best) break;
    for (let r = Math.max(0, row - ring); r <= Math.min(rows - 1, row + ring); r++) {
      const isWhole = r === row - ring || r === row + ring;
      const step = isWhole || ring === 0 ? 1 : 2 * ring;
      for (let c = column - ring; c <= column + ring; c += step) {
        if (c < 0 || c >= columns) continue;
        best = Math.min(best, nearestInCell(grid, i, r * columns + c));
      }
    }
  }
  return best;
}

/** Within a cell points ascend in x, so the scan ends where x alone is too far: one crowded cell costs little. */
function nearestInCell({ x, y, start }: PointGrid, i: number, cell: number): number {
  let best = Number.POSITIVE_INFINITY;
  const from = start[cell];
  const to = start[cell + 1];
  const isOwn = from <= i && i < to;
  for (let k = isOwn ? i + 1 : from; k < to; k++) {
    const squared = (x[k] - x[i]) ** 2 + (y[k] - y[i]) ** 2;
    if (squared < best) best = squared;
    else if (x[k] > x[i] && (x[k] - x[i]) ** 2 > best) break;
  }
  for (let k = i - 1; isOwn && k >= from; k--) {
    const squared = (x[k] - x[i]) ** 2 + (y[k] - y[i]) ** 2;
    if (squared < best) best = squared;
    else if (x[k] < x[i] && (x[k] - x[i]) ** 2 > best) break;
  }
  return best;
}
