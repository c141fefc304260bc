import { CellTable } from '../cell-table.ts';

/** Points of a cloud in the order of the cells of a uniform grid; empty cells cost nothing. */
export interface CellIndex {
  /** Cell edge. */
  readonly edge: number;
  readonly table: CellTable;
  /** x, y, z a point, in cell order. */
  readonly sorted: Float32Array;
  /** Index each sorted point had in the cloud. */
  readonly source: Uint32Array;
  /** First point of each cell in `sorted`; one entry more than cells. */
  readonly start: Uint32Array;
}

/** Sorts points into cells of `edge` by counting; within a cell their order stays. O(n). */
export function indexCells(positions: Float32Array, edge: number): CellIndex {
  const points = positions.length / 3;
  const table = new CellTable();
  const cellOf = new Uint32Array(points);
  for (let i = 0; i < points; i++) {
    cellOf[i] = table.add(
      Math.floor(positions[3 * i] / edge),
      Math.floor(positions[3 * i + 1] / edge),
      Math.floor(positions[3 * i + 2] / edge),
    );
  }
  const start = new Uint32Array(table.count + 1);
  for (let i = 0; i < points; i++) start[cellOf[i] + 1]++;
  for (let cell = 0; cell < table.count; cell++) start[cell + 1] += start[cell];
  const next = start.slice(0, table.count);
  const sorted = new Float32Array(positions.length);
  const source = new Uint32Array(points);
  for (let i = 0; i < points; i++) {
    const at = next[cellOf[i]]++;
    source[at] = i;
    sorted[3 * at] = positions[3 * i];
    sorted[3 * at + 1] = positions[3 * i + 1];
    sorted[3 * at + 2] = positions[3 * i + 2];
  }
  return { edge, table, sorted, source, start };
}
