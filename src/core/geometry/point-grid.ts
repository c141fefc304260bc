import { boundsOf } from './rings.ts';

/** Most cells a point over the bounding box: few enough that an empty box costs little. */
const CELLS_PER_POINT = 2;

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
 * @param cell wished cell edge; coarsened until there are at most about `cellsPerPoint` cells a point. O(n).
 */
export function buildPointGrid(xy: Float64Array, cell = 0, cellsPerPoint = CELLS_PER_POINT): PointGrid {
  const n = xy.length >> 1;
  const { minX, minY, maxX, maxY } = boundsOf(xy);
  const edge = cellEdge(maxX - minX, maxY - minY, cellsPerPoint * n, cell);
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

/** The wished edge, or the smallest that keeps within about so many cells; 1 for a box without extent. */
function cellEdge(width: number, height: number, cells: number, wished: number): number {
  const byArea = Math.sqrt((width * height) / cells);
  const byLength = Math.max(width, height) / cells;
  return Math.max(wished, byArea, byLength) || 1;
}

/**
 * Squared distance from point `i` (cell order) to its nearest other point: blocks of cells around it are searched, each
 * twice as wide, until none beyond can be nearer.
 *
 * The grid must be built from points sorted by x: then those of a row ascend in x.
 *
 * @returns infinity for a single point
 */
export function squaredDistanceToNearest(grid: PointGrid, i: number): number {
  const { columns, rows, cell } = grid;
  const column = Math.floor((grid.x[i] - grid.minX) / cell);
  const row = Math.floor((grid.y[i] - grid.minY) / cell);
  for (let reach = 1; ; reach *= 2) {
    const best = nearestInBlock(grid, i, { column, row, reach });
    const isWhole = reach >= columns && reach >= rows;
    if (isWhole || best <= reach * cell * (reach * cell)) return best;
  }
}

interface Block {
  readonly column: number;
  readonly row: number;
  /** Cells to either side. */
  readonly reach: number;
}

/** Where x alone is too far the scan of a row ends: one crowded cell costs little. */
function nearestInBlock({ x, y, start, columns, rows }: PointGrid, i: number, block: Block): number {
  const first = Math.max(0, block.column - block.reach);
  const last = Math.min(columns - 1, block.column + block.reach);
  const top = Math.min(rows - 1, block.row + block.reach);
  let best = Number.POSITIVE_INFINITY;
  for (let row = Math.max(0, block.row - block.reach); row <= top; row++) {
    const from = start[row * columns + first];
    const to = start[row * columns + last + 1];
    const isOwn = row === block.row;
    for (let k = isOwn ? i + 1 : from; k < to; k++) {
      const dx = x[k] - x[i];
      const dy = y[k] - y[i];
      const squared = dx * dx + dy * dy;
      if (squared < best) best = squared;
      else if (dx > 0 && dx * dx > best) break;
    }
    for (let k = i - 1; isOwn && k >= from; k--) {
      const dx = x[k] - x[i];
      const dy = y[k] - y[i];
      const squared = dx * dx + dy * dy;
      if (squared < best) best = squared;
      else if (dx < 0 && dx * dx > best) break;
    }
  }
  return best;
}
