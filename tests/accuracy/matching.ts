import type { XY } from '../../fixtures/simulator/ring.ts';

/**
 * The one-to-one assignment of rows to columns with the greatest sum of gains (Hungarian method, O(n² m)).
 *
 * @param gains a row each, all of one length
 * @returns pairs; as many as the shorter side is long
 */
export function assign(gains: readonly (readonly number[])[]): [row: number, column: number][] {
  if (gains.length === 0 || gains[0].length === 0) return [];
  if (gains.length > gains[0].length) {
    const turned = gains[0].map((_, column) => gains.map((row) => row[column]));
    return assign(turned).map(([column, row]) => [row, column]);
  }
  const columns = gains[0].length;
  // Potentials and the row matched to each column; index 0 stands for "none", as in the usual formulation.
  const rowPotential = new Float64Array(gains.length + 1);
  const columnPotential = new Float64Array(columns + 1);
  const rowOf = new Int32Array(columns + 1);
  for (let row = 1; row <= gains.length; row++) {
    augment(gains, row, { rowPotential, columnPotential, rowOf });
  }
  const pairs: [number, number][] = [];
  for (let column = 1; column <= columns; column++) {
    if (rowOf[column] > 0) pairs.push([rowOf[column] - 1, column - 1]);
  }
  return pairs.sort(([a], [b]) => a - b);
}

interface Duals {
  readonly rowPotential: Float64Array;
  readonly columnPotential: Float64Array;
  readonly rowOf: Int32Array;
}

/** Adds one row along a shortest augmenting path. */
function augment(gains: readonly (readonly number[])[], row: number, duals: Duals): void {
  const { rowPotential, columnPotential, rowOf } = duals;
  const slack = new Float64Array(columnPotential.length).fill(Infinity);
  const cameFrom = new Int32Array(columnPotential.length);
  const isDone = new Uint8Array(columnPotential.length);
  rowOf[0] = row;
  let column = 0;
  do {
    isDone[column] = 1;
    const current = rowOf[column];
    let next = 0;
    for (let k = 1; k < slack.length; k++) {
      if (isDone[k]) continue;
      const reduced = -gains[current - 1][k - 1] - rowPotential[current] - columnPotential[k];
      if (reduced < slack[k]) {
        slack[k] = reduced;
        cameFrom[k] = column;
      }
      if (next === 0 || slack[k] < slack[next]) next = k;
    }
    shiftPotentials(slack, isDone, slack[next], duals);
    column = next;
  } while (rowOf[column] !== 0);
  while (column !== 0) {
    rowOf[column] = rowOf[cameFrom[column]];
    column = cameFrom[column];
  }
}

function shiftPotentials(slack: Float64Array, isDone: Uint8Array, by: number, duals: Duals): void {
  for (let k = 0; k < slack.length; k++) {
    if (isDone[k]) {
      duals.rowPotential[duals.rowOf[k]] += by;
      duals.columnPotential[k] -= by;
    } else {
      slack[k] -= by;
    }
  }
}

/** The most points that can be paired one-to-one within a radius (Kuhn's augmenting paths). */
export function countPairs(found: readonly XY[], wanted: readonly XY[], radius: number): number {
  const near = found.map(([x, y]) =>
    wanted.flatMap(([u, v], k) => (Math.hypot(x - u, y - v) <= radius ? [k] : [])),
  );
  const partner = new Int32Array(wanted.length).fill(-1);
  const settle = (point: number, tried: Set<number>): boolean => {
    for (const k of near[point]) {
      if (tried.has(k)) continue;
      tried.add(k);
      if (partner[k] < 0 || settle(partner[k], tried)) {
        partner[k] = point;
        return true;
      }
    }
    return false;
  };
  return found.filter((_, i) => settle(i, new Set())).length;
}
