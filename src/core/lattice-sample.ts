import { CELLS_ACROSS, CellTable, FIRST_CELL } from './cell-table.ts';
import { distinctPoints } from './geometry/point-order.ts';

/**
 * Places within a cell are told in 2¹² steps, 8 µm of a cell of 3 cm: sums of whole steps are exact, so no order of points
 * shows in a mean.
 */
const STEP_BITS = 12;
const STEPS = 1 << STEP_BITS;
/**
 * A cell that holds less than this share of what a neighbour holds is that neighbour's noise: the tail of a wall. So the
 * outline follows the wall, not the farthest of its points, however many there are. On ten scanned scenes 0, 0.05, 0.1
 * and 0.25 gave an IoU of .940, .941, .943 and .940, and areas too large by 0.8, 0.6, 0.4 and 0.5 %.
 */
const LEAST_SHARE = 0.1;
/** A box of at most this many cells a point, and as many in all (100 MB), has an array entry for each of its cells. */
const DENSE_CELLS_PER_POINT = 4;
const MOST_DENSE_CELLS = 2 ** 22;

/** Points over which a lattice is laid, all coordinates in metres. */
export interface LatticePoints {
  /** x, y, z a point. */
  readonly positions: Float32Array;
  /** Points that count, each once. */
  readonly indices: Uint32Array;
}

/** A square lattice over the plan; its first cell starts at (minX, minY). */
export interface Lattice {
  readonly minX: number;
  readonly minY: number;
  readonly edge: number;
  readonly columns: number;
  readonly rows: number;
}

/** What lies in the cells of a lattice, by slot. */
export interface CellSums {
  readonly lattice: Lattice;
  /** Occupied cells. */
  readonly occupied: number;
  /** A slot: number of points, sums of their distances from the cell's left and lower side in whole steps. */
  readonly sums: Float64Array;
  /** Which cell a slot is; null where slots are all cells of the box, row by row. */
  readonly table: CellTable | null;
}

/**
 * A lattice over the box of the points.
 *
 * @param shift of its first cell to the left and down, in cells
 * @param wantedEdge m; kilometres across, cells grow so that all can be told apart
 */
export function layLattice(
  { positions, indices }: LatticePoints,
  wantedEdge: number,
  shift: readonly [x: number, y: number],
): Lattice {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  const isAll = 3 * indices.length === positions.length;
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * (isAll ? k : indices[k]);
    const x = positions[i];
    const y = positions[i + 1];
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
  }
  const edge = Math.max(wantedEdge, Math.max(maxX - minX, maxY - minY) / (CELLS_ACROSS - 2));
  minX -= shift[0] * edge;
  minY -= shift[1] * edge;
  const columns = cellAt(maxX - minX, STEPS / edge) + 1;
  const rows = cellAt(maxY - minY, STEPS / edge) + 1;
  return { minX, minY, edge, columns, rows };
}

/** Column or row at a distance from the lattice's first side; the one way to tell it, so that no point lies past the last. */
function cellAt(distance: number, stepsPerMetre: number): number {
  return ((distance * stepsPerMetre) | 0) >> STEP_BITS;
}

/**
 * Counts and sums the points of each cell; all points must lie in the lattice. O(n).
 *
 * Where the box is small against the points an array holds every cell of it, else a hash table the occupied ones: the
 * whole stage takes 10 M points of a wall slice 0.1 s or 0.2 s.
 */
export function sumCells(points: LatticePoints, lattice: Lattice): CellSums {
  const cells = lattice.columns * lattice.rows;
  const isDense = cells <= Math.min(MOST_DENSE_CELLS, DENSE_CELLS_PER_POINT * points.indices.length);
  return isDense ? sumInBox(points, lattice, cells) : sumInTable(points, lattice);
}

function sumInBox({ positions, indices }: LatticePoints, lattice: Lattice, cells: number): CellSums {
  const { minX, minY, columns } = lattice;
  const stepsPerMetre = STEPS / lattice.edge;
  const isAll = 3 * indices.length === positions.length;
  const sums = new Float64Array(3 * cells);
  let occupied = 0;
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * (isAll ? k : indices[k]);
    const u = ((positions[i] - minX) * stepsPerMetre) | 0;
    const v = ((positions[i + 1] - minY) * stepsPerMetre) | 0;
    const at = 3 * ((v >> STEP_BITS) * columns + (u >> STEP_BITS));
    if (sums[at]++ === 0) occupied++;
    sums[at + 1] += u & (STEPS - 1);
    sums[at + 2] += v & (STEPS - 1);
  }
  return { lattice, occupied, sums, table: null };
}

/** Slots are the numbers of the table's cells. */
function sumInTable({ positions, indices }: LatticePoints, lattice: Lattice): CellSums {
  const { minX, minY } = lattice;
  const stepsPerMetre = STEPS / lattice.edge;
  const table = new CellTable();
  const sums: number[] = [];
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * indices[k];
    const u = ((positions[i] - minX) * stepsPerMetre) | 0;
    const v = ((positions[i + 1] - minY) * stepsPerMetre) | 0;
    const at = 3 * table.add((u >> STEP_BITS) + FIRST_CELL, (v >> STEP_BITS) + FIRST_CELL, 0);
    if (at === sums.length) sums.push(0, 0, 0);
    sums[at]++;
    sums[at + 1] += u & (STEPS - 1);
    sums[at + 2] += v & (STEPS - 1);
  }
  return { lattice, occupied: table.count, sums: Float64Array.from(sums), table };
}

/**
 * The mean of the points of each cell, to half a step; cells that are but the noise of a neighbour have none.
 *
 * The order of the points does not matter. Means, not the points nearest the middle of their cells: on the outer side
 * of a wall the middle lies farther out. With 10 M points of walls with 1 cm noise the outline's area is 0.46 % too large;
 * with the noise 1.09 %, with middles 0.86 %, with both 1.24 %.
 *
 * @returns x, y a point, m, in lexicographic order. Linear in the slots.
 */
export function cellMeans(cells: CellSums): Float64Array {
  const { lattice, occupied, sums } = cells;
  const xy = new Float64Array(2 * occupied);
  let n = 0;
  for (let at = 0; at < sums.length; at += 3) {
    const count = sums[at];
    if (count === 0) continue;
    const [column, row] = cellOf(cells, at / 3);
    if (isNoise(cells, count, column, row)) continue;
    xy[n++] = lattice.minX + (column + (sums[at + 1] / count + 0.5) / STEPS) * lattice.edge;
    xy[n++] = lattice.minY + (row + (sums[at + 2] / count + 0.5) / STEPS) * lattice.edge;
  }
  return distinctPoints(xy.subarray(0, n));
}

/** Whether some cell around holds so many points that this cell's are their noise. */
function isNoise(cells: CellSums, count: number, column: number, row: number): boolean {
  for (let r = row - 1; r <= row + 1; r++) {
    for (let c = column - 1; c <= column + 1; c++) {
      if (count < LEAST_SHARE * countIn(cells, c, r)) return true;
    }
  }
  return false;
}

function cellOf({ lattice, table }: CellSums, slot: number): readonly [column: number, row: number] {
  if (table === null) return [slot % lattice.columns, Math.floor(slot / lattice.columns)];
  const [ix, iy] = table.coordinatesOf(slot);
  return [ix - FIRST_CELL, iy - FIRST_CELL];
}

function countIn({ lattice, sums, table }: CellSums, column: number, row: number): number {
  if (column < 0 || row < 0 || column >= lattice.columns || row >= lattice.rows) return 0;
  if (table === null) return sums[3 * (row * lattice.columns + column)];
  const slot = table.find(column + FIRST_CELL, row + FIRST_CELL, 0);
  return slot < 0 ? 0 : sums[3 * slot];
}
