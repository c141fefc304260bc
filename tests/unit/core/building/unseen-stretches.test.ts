import { expect, it } from 'vitest';
import { unseenStretches } from '../../../../src/core/building/walls/unseen-stretches.ts';

const EDGE = { owner: 0, ax: 1, ay: 2, bx: 6, by: 2, length: 5, ux: 1, uy: 0 };

/** Points of a wall every 2 cm along and 10 cm up, but for a stretch. */
function wallWithout(from: number, to: number) {
  const [along, high]: number[][] = [[], []];
  for (let x = 0.01; x < EDGE.length; x += 0.02) {
    if (x > from && x < to) continue;
    for (let z = 0.1; z < 2.4; z += 0.1) {
      along.push(x);
      high.push(z);
    }
  }
  const count = along.length;
  return {
    ...{ count, along: Float64Array.from(along), high: Float64Array.from(high) },
    deep: new Float64Array(count),
  };
}

it.each([0, 0.02, 0.05, 0.07])('a stretch without points is told wherever it begins: %d m on', (shift) => {
  const [stretch, ...others] = unseenStretches(EDGE, wallWithout(2 + shift, 2.4 + shift), 0.03, []);
  expect(others).toEqual([]);
  expect(stretch.from[0]).toBeGreaterThan(2.95 + shift);
  expect(stretch.from[0]).toBeLessThan(3.05 + shift);
  expect(stretch.to[0]).toBeGreaterThan(3.35 + shift);
  expect(stretch.to[0]).toBeLessThan(3.45 + shift);
});

it('a short one is not, nor what an opening explains', () => {
  expect(unseenStretches(EDGE, wallWithout(2, 2.25), 0.03, [])).toEqual([]);
  expect(unseenStretches(EDGE, wallWithout(2, 3), 0.03, [{ from: 1.98, to: 3.02 }])).toEqual([]);
  const [beside] = unseenStretches(EDGE, wallWithout(1, 3), 0.03, [{ from: 2, to: 3 }]);
  expect(beside.to[0]).toBeCloseTo(3, 6);
});

it('a wall of which nothing was seen is told from end to end', () => {
  const [whole] = unseenStretches(EDGE, wallWithout(0, 5), 0.03, []);
  expect([whole.from, whole.to]).toEqual([
    [1, 2],
    [6, 2],
  ]);
});
