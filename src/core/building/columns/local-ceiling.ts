import { CellTable } from '../../cell-table.ts';
import type { HeightColumns } from './height-columns.ts';

/** Cells that a ceiling's height is told for, m: a room has several. */
const CELL = 0.5;

/** Heights of the ceiling from place to place. */
export interface LocalCeiling {
  /** Height over a place, m, in the cloud's frame; the storey's where none was seen. */
  at(x: number, y: number): number;
}

/** The mean height of what hangs over the columns around. O(columns). */
export function localCeiling({ count, table, size, overhead, heights }: HeightColumns): LocalCeiling {
  const cells = new CellTable();
  const sums: number[] = [];
  const counts: number[] = [];
  for (let c = 0; c < count; c++) {
    if (Number.isNaN(overhead[c])) continue;
    const [ix, iy] = table.coordinatesOf(c);
    const cell = cells.add(Math.floor(((ix + 0.5) * size) / CELL), Math.floor(((iy + 0.5) * size) / CELL), 0);
    sums[cell] = (sums[cell] ?? 0) + overhead[c];
    counts[cell] = (counts[cell] ?? 0) + 1;
  }
  return {
    at(x, y) {
      const cell = cells.find(Math.floor(x / CELL), Math.floor(y / CELL), 0);
      return cell < 0 ? heights.ceiling : sums[cell] / counts[cell];
    },
  };
}
