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
/**
 * No noise lies farther than this from its wall, m: three deviations of a hand-held scanner. A sparse wall farther from a
 * dense one stays, however coarse the cells.
 */
const NOISE_REACH = 0.06;
/** About so many points tell the box of all, but for the few that lie farther out … */
const BOX_SAMPLE = 4096;
/** … by mostly less than this share of it. */
const BOX_MARGIN = 1 / 16;
/** A box of few cells (25 MB), or of at most so many a point and as many in all (100 MB), has an array entry for each. */
const FEW_CELLS = 2 ** 20;
const DENSE_CELLS_PER_POINT = 4;
const MOST_DENSE_CELLS = 2 ** 22;

/** Points over which a lattice is laid, all coordinates in metres. */
export interface LatticePoints {
  /** x, y, z a point. */
  readonly positions: Float32Array;
  /** Points that count, each once. */
  readonly indices: Uint32Array;
}

/** A square lattice over the plan; its cell (0, 0) starts at −`shift` cells, wherever the points are. */
export interface Lattice {
  readonly edge: number;
  readonly shift: readonly [x: number, y: number];
}

/** A part of a lattice, in cells. */
interface Box {
  readonly column: number;
  readonly row: number;
  readonly columns: number;
  readonly rows: number;
}

/** What lies in the cells of a lattice, by slot. */
export interface CellSums {
  readonly lattice: Lattice;
  /** Holds all points, and a border of empty cells. */
  readonly box: Box;
  /** Slots of the occupied cells, as they were met. */
  readonly occupied: readonly number[];
  /** A slot: number of points, sums of their distances from the cell's left and lower side in whole steps. */
  readonly sums: Float64Array;
  /** Which cell a slot is; null where slots are all cells of the box, row by row. */
  readonly table: CellTable | null;
}

/**
 * Counts and sums the points of each cell of a lattice. O(n), in one pass where nothing lies far out: the lattice hangs on
 * no bounds of the points, and whether they fit a box guessed from a sample shows on the way.
 *
 * Where the box is small against the points an array holds every cell of it, else a hash table the occupied ones. Of 10 M
 * points of a wall slice 40 ms; bounds first, and then the sums, took 75 ms, numbering the occupied cells 56 ms.
 *
 * @param wantedEdge m; kilometres across, cells grow so that all can be told apart
 * @param shift of the lattice to the left and down, in cells
 */
export function sumCells(
  points: LatticePoints,
  wantedEdge: number,
  shift: readonly [x: number, y: number],
): CellSums {
  const n = points.indices.length;
  let lattice: Lattice = { edge: wantedEdge, shift };
  const likely = boxOf(points, lattice, Math.max(1, Math.floor(n / BOX_SAMPLE)), BOX_MARGIN);
  const sums = isDense(likely, n) ? sumInBox(points, lattice, likely) : null;
  if (sums !== null) return sums;
  let box = boxOf(points, lattice);
  const across = Math.max(box.columns, box.rows);
  if (across > CELLS_ACROSS) {
    lattice = { edge: (wantedEdge * across) / (CELLS_ACROSS - 4), shift };
    box = boxOf(points, lattice);
  }
  return (isDense(box, n) ? sumInBox(points, lattice, box) : null) ?? sumInTable(points, lattice, box);
}

function isDense({ columns, rows }: Box, points: number): boolean {
  if (Math.max(columns, rows) > CELLS_ACROSS) return false;
  return columns * rows <= Math.min(MOST_DENSE_CELLS, Math.max(FEW_CELLS, DENSE_CELLS_PER_POINT * points));
}

/** The box of every `stride`-th point, grown by a share and a border. */
function boxOf({ positions, indices }: LatticePoints, { edge, shift }: Lattice, stride = 1, margin = 0): Box {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  const isAll = 3 * indices.length === positions.length;
  for (let k = 0; k < indices.length; k += stride) {
    const i = 3 * (isAll ? k : indices[k]);
    const x = positions[i];
    const y = positions[i + 1];
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
  }
  const grow = margin * Math.max(maxX - minX, maxY - minY);
  const cellOf = (value: number, axis: number) =>
    Math.floor((value * (STEPS / edge) + shift[axis] * STEPS) / STEPS);
  const column = cellOf(minX - grow, 0) - 1;
  const row = cellOf(minY - grow, 1) - 1;
  const columns = cellOf(maxX + grow, 0) + 2 - column;
  const rows = cellOf(maxY + grow, 1) + 2 - row;
  return { column, row, columns, rows };
}

/** Slots are the cells of the box; null when a point lies on its border or beyond. */
function sumInBox({ positions, indices }: LatticePoints, lattice: Lattice, box: Box): CellSums | null {
  const { columns, rows } = box;
  const stepsPerMetre = STEPS / lattice.edge;
  const offsetU = lattice.shift[0] * STEPS;
  const offsetV = lattice.shift[1] * STEPS;
  const firstU = box.column * STEPS;
  const firstV = box.row * STEPS;
  const highU = (columns - 1) * STEPS;
  const highV = (rows - 1) * STEPS;
  const isAll = 3 * indices.length === positions.length;
  const sums = new Float64Array(3 * columns * rows);
  const occupied: number[] = [];
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * (isAll ? k : indices[k]);
    // What is rounded does not know the box; taking whole cells off is exact.
    const distanceU = positions[i] * stepsPerMetre + offsetU - firstU;
    const distanceV = positions[i + 1] * stepsPerMetre + offsetV - firstV;
    if (!(distanceU >= STEPS && distanceU < highU && distanceV >= STEPS && distanceV < highV)) return null;
    const u = distanceU | 0;
    const v = distanceV | 0;
    const slot = (v >> STEP_BITS) * columns + (u >> STEP_BITS);
    const at = 3 * slot;
    if (sums[at] === 0) occupied.push(slot);
    sums[at]++;
    sums[at + 1] += u & (STEPS - 1);
    sums[at + 2] += v & (STEPS - 1);
  }
  return { lattice, box, occupied, sums, table: null };
}

/** Slots are the numbers of the table's cells. */
function sumInTable({ positions, indices }: LatticePoints, lattice: Lattice, box: Box): CellSums {
  const stepsPerMetre = STEPS / lattice.edge;
  const [offsetU, offsetV] = [lattice.shift[0] * STEPS, lattice.shift[1] * STEPS];
  const table = new CellTable();
  const occupied: number[] = [];
  const sums: number[] = [];
  for (let k = 0; k < indices.length; k++) {
    const i = 3 * indices[k];
    const u = Math.floor(positions[i] * stepsPerMetre + offsetU - box.column * STEPS);
    const v = Math.floor(positions[i + 1] * stepsPerMetre + offsetV - box.row * STEPS);
    const slot = table.add((u >> STEP_BITS) + FIRST_CELL, (v >> STEP_BITS) + FIRST_CELL, 0);
    if (slot === occupied.length) {
      occupied.push(slot);
      sums.push(0, 0, 0);
    }
    sums[3 * slot]++;
    sums[3 * slot + 1] += u & (STEPS - 1);
    sums[3 * slot + 2] += v & (STEPS - 1);
  }
  return { lattice, box, occupied, sums: Float64Array.from(sums), table };
}

/** Cells in the least box that holds all occupied ones. */
export function cellsCovered(cells: CellSums): number {
  let left = Number.POSITIVE_INFINITY;
  let low = Number.POSITIVE_INFINITY;
  let right = Number.NEGATIVE_INFINITY;
  let high = Number.NEGATIVE_INFINITY;
  for (const slot of cells.occupied) {
    const column = columnOf(cells, slot);
    const row = rowOf(cells, slot);
    if (column < left) left = column;
    if (column > right) right = column;
    if (row < low) low = row;
    if (row > high) high = row;
  }
  return (right - left + 1) * (high - low + 1);
}

/**
 * The mean of the points of each cell, to half a step; cells that are but the noise of a neighbour have none.
 *
 * The order of the points does not matter. Means, not the points nearest the middle of their cells: on the outer side
 * of a wall the middle lies farther out. With 10 M points of walls with 1 cm noise the outline's area is 0.46 % too large;
 * with the noise 1.09 %, with middles 0.86 %, with both 1.24 %.
 *
 * @returns x, y a point, m, in lexicographic order. Linear in the occupied cells.
 */
export function cellMeans(cells: CellSums): Float64Array {
  const { lattice, box, occupied, sums } = cells;
  const { edge, shift } = lattice;
  const verdicts = new Uint8Array(sums.length / 3);
  const xy = new Float64Array(2 * occupied.length);
  let n = 0;
  for (let k = 0; k < occupied.length; k++) {
    const slot = occupied[k];
    if (isNoise(cells, verdicts, slot)) continue;
    xy[n++] = (box.column + columnOf(cells, slot) - shift[0] + placeIn(sums, slot, 1)) * edge;
    xy[n++] = (box.row + rowOf(cells, slot) - shift[1] + placeIn(sums, slot, 2)) * edge;
  }
  return distinctPoints(xy.subarray(0, n));
}

/** Mean place of a slot's points within their cell, 0 to 1, along x (1) or y (2). */
function placeIn(sums: Float64Array, slot: number, axis: 1 | 2): number {
  return (sums[3 * slot + axis] / sums[3 * slot] + 0.5) / STEPS;
}

const KEPT = 1;
const NOISE = 2;

/**
 * Whether a neighbour that stays holds so many points, so near, that this cell's are their noise: noise of noise would
 * lead away from the wall.
 *
 * @param verdicts of the slots judged so far
 */
function isNoise(cells: CellSums, verdicts: Uint8Array, slot: number): boolean {
  if (verdicts[slot] > 0) return verdicts[slot] === NOISE;
  verdicts[slot] = KEPT;
  const { sums, box, table } = cells;
  const count = sums[3 * slot];
  const at = table?.coordinatesOf(slot);
  for (let dr = -1; dr <= 1; dr++) {
    for (let dc = -1; dc <= 1; dc++) {
      const other = table && at ? table.find(at[0] + dc, at[1] + dr, 0) : slot + dr * box.columns + dc;
      if (other < 0 || !(count < LEAST_SHARE * sums[3 * other])) continue;
      const dx = dc + placeIn(sums, other, 1) - placeIn(sums, slot, 1);
      const dy = dr + placeIn(sums, other, 2) - placeIn(sums, slot, 2);
      if (Math.sqrt(dx * dx + dy * dy) * cells.lattice.edge > NOISE_REACH) continue;
      if (isNoise(cells, verdicts, other)) continue;
      verdicts[slot] = NOISE;
      return true;
    }
  }
  return false;
}

/** Column of a slot in the box. */
function columnOf({ box, table }: CellSums, slot: number): number {
  return table === null ? slot % box.columns : table.coordinatesOf(slot)[0] - FIRST_CELL;
}

/** Row of a slot in the box. */
function rowOf({ box, table }: CellSums, slot: number): number {
  return table === null ? Math.floor(slot / box.columns) : table.coordinatesOf(slot)[1] - FIRST_CELL;
}
