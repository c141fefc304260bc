import type { CellTable } from './cell-table.ts';
import { rootOf, separateSets, unite } from './union-find.ts';

/** The 13 neighbours of a cell that come after it in z, y, x order: each pair is looked at once. */
const FORWARD: readonly (readonly [number, number, number])[] = [
  [1, 0, 0],
  ...[-1, 0, 1].map((dx) => [dx, 1, 0] as const),
  ...[-1, 0, 1].flatMap((dy) => [-1, 0, 1].map((dx) => [dx, dy, 1] as const)),
];

/**
 * Components of occupied cells that touch at faces, edges or corners, by union-find.
 *
 * @returns component of each cell, numbered from 0 in the order of their first cells. Linear in the cells.
 */
export function joinTouchingCells(table: CellTable): Uint32Array {
  const parent = separateSets(table.count);
  for (let cell = 0; cell < parent.length; cell++) {
    const [cx, cy, cz] = table.coordinatesOf(cell);
    for (const [dx, dy, dz] of FORWARD) {
      const next = table.find(cx + dx, cy + dy, cz + dz);
      if (next >= 0) unite(parent, cell, next);
    }
  }
  const component = new Uint32Array(parent.length);
  let count = 0;
  for (let cell = 0; cell < parent.length; cell++) {
    const root = rootOf(parent, cell);
    component[cell] = root === cell ? count++ : component[root];
  }
  return component;
}
