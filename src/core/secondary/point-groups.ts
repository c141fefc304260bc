import { CellTable } from '../cell-table.ts';
import { joinTouchingCells } from '../touching-cells.ts';

/**
 * Parts points into groups: those in touching cells hang together. O(points).
 *
 * @param xy x, y a point, m
 * @param numbers of the points that count
 * @param cell edge, m
 * @returns numbers of the points of each group
 */
export function groupPoints(xy: Float64Array, numbers: Uint32Array, cell: number): Uint32Array[] {
  const table = new CellTable();
  const cellOf = numbers.map((i) =>
    table.add(Math.floor(xy[2 * i] / cell), Math.floor(xy[2 * i + 1] / cell), 0),
  );
  const component = joinTouchingCells(table);
  const sizes = new Uint32Array(component.reduce((most, group) => Math.max(most, group + 1), 0));
  for (const at of cellOf) sizes[component[at]]++;
  const groups = Array.from(sizes, (size) => new Uint32Array(size));
  sizes.fill(0);
  numbers.forEach((i, k) => {
    const group = component[cellOf[k]];
    groups[group][sizes[group]++] = i;
  });
  return groups;
}

/** The points numbered, x, y each. */
export function pointsOf(xy: Float64Array, numbers: Uint32Array): Float64Array {
  const points = new Float64Array(2 * numbers.length);
  for (let k = 0; k < numbers.length; k++) {
    points[2 * k] = xy[2 * numbers[k]];
    points[2 * k + 1] = xy[2 * numbers[k] + 1];
  }
  return points;
}
