import { expect, it } from 'vitest';
import { CEILING_LOOK, unseenStretches } from '../../../../src/core/building/walls/unseen-stretches.ts';

const EDGE = { owner: 0, ax: 1, ay: 2, bx: 6, by: 2, length: 5, ux: 1, uy: 0 };

/** Points of a strip. */
function stripOf(along: number[], deep: number[], high: number[]) {
  const [a, d, h] = [along, deep, high].map((values) => Float64Array.from(values));
  return { count: along.length, along: a, deep: d, high: h };
}

const NOTHING = stripOf([], [], []);

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
  return {
    face: stripOf(
      along,
      along.map(() => 0),
      high,
    ),
    ceiling: NOTHING,
  };
}

/** Points of a ceiling every 4 cm up to a wall, and of rows of the wall just below it. */
function ceilingBefore(rows: number) {
  const [along, deep, high]: number[][] = [[], [], []];
  const add = (x: number, y: number, z: number) => {
    along.push(x);
    deep.push(y);
    high.push(z);
  };
  for (let x = 0.02; x < EDGE.length; x += 0.04) {
    for (let before = 0.02; before < CEILING_LOOK; before += 0.04) add(x, CEILING_LOOK - before, 2.5);
    for (let row = 0; row < rows; row++) add(x, CEILING_LOOK, 2.48 - 0.04 * row);
  }
  return stripOf(along, deep, high);
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

it('nor what was seen just below the ceiling, above a cupboard; the ceiling alone shows no wall', () => {
  const { face } = wallWithout(2, 4);
  expect(unseenStretches(EDGE, { face, ceiling: ceilingBefore(2) }, 0.03, [])).toEqual([]);
  expect(unseenStretches(EDGE, { face, ceiling: ceilingBefore(0) }, 0.03, [])).toHaveLength(1);
});
