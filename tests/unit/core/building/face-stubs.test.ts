import { describe, expect, it } from 'vitest';
import { columnAt } from '../../../../src/core/building/columns/height-columns.ts';
import type { Face } from '../../../../src/core/building/faces/face.ts';
import { withStubs } from '../../../../src/core/building/faces/face-stubs.ts';
import { allFree, columnsAt } from './upright-columns.ts';

type Place = readonly [x: number, y: number];

const row = (from: Place, to: Place): Place[] => {
  const count = Math.round(Math.hypot(to[0] - from[0], to[1] - from[1]) / 0.04);
  return Array.from({ length: count + 1 }, (_, k) => [
    from[0] + ((to[0] - from[0]) * k) / count,
    from[1] + ((to[1] - from[1]) * k) / count,
  ]);
};

describe('a stub of wall past a passage', () => {
  const wall = row([0, 0.01], [2, 0.01]);
  const stub = row([3.5, 0.01], [3.72, 0.01]);

  /** How far a face along y = 0.01 reaches with the stub and what stands around it, m. */
  function reachWith(around: readonly Place[]): number {
    const columns = columnsAt([...wall, ...stub, ...around]);
    const members = [...new Set(wall.map(([x, y]) => columnAt(columns, x, y)))];
    // Places along a line run against x where its normal is y.
    const line = { nx: 0, ny: 1, offset: 0.01, from: -2, to: 0 };
    const face: Face = { ...line, noise: 0.02, support: 1000, members };
    return -withStubs(allFree(columns), face).from;
  }

  it('is of its wall where it ends at another', () => {
    expect(reachWith(row([3.75, -0.8], [3.75, 0.8]))).toBeCloseTo(3.75, 1);
  });

  it('is none where a column stands in line, or nothing is behind', () => {
    expect(reachWith([...row([3.72, 0.01], [3.72, 0.3]), ...row([3.5, 0.3], [3.72, 0.3])])).toBe(2);
    expect(reachWith([])).toBe(2);
  });
});
