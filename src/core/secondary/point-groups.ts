import { CellTable } from '../cell-table.ts';
import { joinTouchingCells } from '../touching-cells.ts';

/** Points in the order of their groups. */
export interface PointGroups {
  /** Group of each point. */
  readonly groupOf: Uint32Array;
  /** First place of each group in `members`; one entry more than groups. */
  readonly start: Uint32Array;
  /** Numbers of the points, group after group. */
  readonly members: Uint32Array;
}

/** Parts points into groups: those in touching cells hang together. O(points). */
export function groupPoints(xy: Float64Array, cell: number): PointGroups {
  const table = new CellTable();
  const cellOf = new Uint32Array(xy.length / 2);
  for (let i = 0; i < cellOf.length; i++) {
    cellOf[i] = table.add(Math.floor(xy[2 * i] / cell), Math.floor(xy[2 * i + 1] / cell), 0);
  }
  const component = joinTouchingCells(table);
  const groupOf = cellOf.map((at) => component[at]);
  const groups = groupOf.reduce((most, group) => Math.max(most, group + 1), 0);
  const start = new Uint32Array(groups + 1);
  for (const group of groupOf) start[group + 1]++;
  for (let group = 0; group < groups; group++) start[group + 1] += start[group];
  const next = start.slice();
  const members = new Uint32Array(groupOf.length);
  for (let i = 0; i < groupOf.length; i++) members[next[groupOf[i]]++] = i;
  return { groupOf, start, members };
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
