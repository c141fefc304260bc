import { CellTable, FIRST_CELL } from './cell-table.ts';
import { distinctPoints } from './geometry/point-order.ts';

/** Steps a cell's edge is told in: sums of whole steps are exact, so no order of points shows in a mean. */
const STEPS = 2 ** 16;
/**
 * A cell that holds less than this share of what a neighbour holds is that neighbour's noise: the tail of a wall. So the
 * outline follows the wall, not the farthest of its points, however many there are. On ten scanned scenes 0, 0.05, 0.1,
 * 0.25 and 0.4 gave an IoU of .939, .942, .942, .941 and .942, and areas too large by 0.8, 0.6, 0.6, 0.3 and 0 %.
 */
const LEAST_SHARE = 0.1;
/** A box of at most this many cells a point, and as many in all (80 MB), has an array entry for each of its cells. */
const DENSE_CELLS_PER_POINT = 4;
const MOST_DENSE_CELLS = 2 ** 22;

/** Points over which a lattice is laid, all coordinates in metres. */
export interface LatticePoints {
  /** x, y, z a point. */
  readonly positions: Float32Array;
  /** Points that count. */
  readonly indices: Uint32Array;
}

/** A square lattice over the plan; its first cell starts at (minX, minY). */
export interface Lattice {
  readonly minX: number;
  readonly minY: number;
  readonly edge: number;
  /** 1 / edge: cells are told by this one product, so that none lies past the last. */
  readonly perMetre: number;
  readonly columns: number;
  readonly rows: number;
}

/** What lies in the cells of a lattice, by slot. */
export interface CellSums {
  readonly lattice: Lattice;
  /** Occupied cells. */
  readonly occupied: number;
  /** Points of each cell. */
  readonly counts: Uint32Array;
  /** Sums of the points' distances from the cell's corner, in whole steps. */
  readonly sumX: Float64Array;
  readonly sumY: Float64Array;
  /** Which cell a slot is; null where slots are all cells of the box, row by row. */
  readonly table: CellTable | null;
}

/**
 * Counts and sums the points of each cell; all points must lie in the lattice. O(n).
 *
 * Where the box is small against the points an array holds every cell of it, else a hash table the occupied ones: for
 * 10 M points of a wall slice 0.06 s and 0.3 s.
 */
export function sumCells(points: LatticePoints, lattice: Lattice): CellSums {
  const cells = lattice.columns * lattice.rows;
  const isDense = cells <= Math.min(MOST_DENSE_CELLS, DENSE_CELLS_PER_POINT * points.indices.length);
  return isDense ? sumInBox(points, lattice, cells) : sumInTable(points, lattice);
}

function sumInBox({ positions, indices }: LatticePoints, lattice: Lattice, cells: number): CellSums {
  const { minX, minY, perMetre, columns } = lattice;
  const counts = new Uint32Array(cells);
  const sumX = new Float64Array(cells);
  const sumY = new Float64Array(cells);
  let occupied = 0;
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * indices[k];
    const u = (positions[i] - minX) * perMetre;
    const v = (positions[i + 1] - minY) * perMetre;
    const column = u | 0;
    const row = v | 0;
    const slot = row * columns + column;
    if (counts[slot]++ === 0) occupied++;
    sumX[slot] += ((u - column) * STEPS) | 0;
    sumY[slot] += ((v - row) * STEPS) | 0;
  }
  return { lattice, occupied, counts, sumX, sumY, table: null };
}

/** Slots are the numbers of the table's cells. */
function sumInTable({ positions, indices }: LatticePoints, lattice: Lattice): CellSums {
  const { minX, minY, perMetre } = lattice;
  const table = new CellTable();
  const counts: number[] = [];
  const sumX: number[] = [];
  const sumY: number[] = [];
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * indices[k];
    const u = (positions[i] - minX) * perMetre;
    const v = (positions[i + 1] - minY) * perMetre;
    const column = u | 0;
    const row = v | 0;
    const slot = table.add(column + FIRST_CELL, row + FIRST_CELL, 0);
    if (slot === counts.length) {
      counts.push(0);
      sumX.push(0);
      sumY.push(0);
    }
    counts[slot]++;
    sumX[slot] += ((u - column) * STEPS) | 0;
    sumY[slot] += ((v - row) * STEPS) | 0;
  }
  return {
    lattice,
    occupied: counts.length,
    counts: Uint32Array.from(counts),
    sumX: Float64Array.from(sumX),
    sumY: Float64Array.from(sumY),
    table,
  };
}

/**
 * The mean of the points of each cell, to half a step; cells that are but the noise of a neighbour have none.
 *
 * The order of the points does not matter. Means, not the points nearest the middle of their cells: on the outer side
 * of a wall the middle lies farther out. With 10 M points of walls with 1 cm noise the outline's area is 0.45 % too large,
 * with middles 0.86 %, with all cells 1.08 %, with both 1.24 %.
 *
 * @returns x, y a point, m, in lexicographic order. Linear in the slots.
 */
export function cellMeans(sums: CellSums): Float64Array {
  const { lattice, occupied, counts, sumX, sumY } = sums;
  const { minX, minY, edge } = lattice;
  const xy = new Float64Array(2 * occupied);
  let n = 0;
  for (let slot = 0; slot < counts.length; slot++) {
    if (counts[slot] === 0) continue;
    const [column, row] = cellOf(sums, slot);
    if (isNoise(sums, slot, column, row)) continue;
    xy[n++] = minX + (column + (sumX[slot] / counts[slot] + 0.5) / STEPS) * edge;
    xy[n++] = minY + (row + (sumY[slot] / counts[slot] + 0.5) / STEPS) * edge;
  }
  return distinctPoints(xy.subarray(0, n));
}

/** Whether some cell around holds so many points that this cell's are their noise. */
function isNoise(sums: CellSums, slot: number, column: number, row: number): boolean {
  const most = sums.counts[slot] / LEAST_SHARE;
  for (let r = row - 1; r <= row + 1; r++) {
    for (let c = column - 1; c <= column + 1; c++) if (countIn(sums, c, r) > most) return true;
  }
  return false;
}

function cellOf({ lattice, table }: CellSums, slot: number): readonly [column: number, row: number] {
  if (table === null) return [slot % lattice.columns, Math.floor(slot / lattice.columns)];
  const [ix, iy] = table.coordinatesOf(slot);
  return [ix - FIRST_CELL, iy - FIRST_CELL];
}

function countIn({ lattice, counts, table }: CellSums, column: number, row: number): number {
  if (column < 0 || row < 0 || column >= lattice.columns || row >= lattice.rows) return 0;
  const slot =
    table === null ? row * lattice.columns + column : table.find(column + FIRST_CELL, row + FIRST_CELL, 0);
  return slot < 0 ? 0 : counts[slot];
}
