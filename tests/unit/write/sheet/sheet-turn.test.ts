import { expect, test } from 'vitest';
import { sheetTurn } from '../../../../src/write/sheet/sheet-turn.ts';
import { planOf } from '../../solid/plans.ts';

const DEGREE = Math.PI / 180;

/** A storey with one ring as its outline, turned. */
function storeysOf(ring: readonly number[], turn = 0) {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const outer = Float64Array.from(ring, (value, i) =>
    i % 2 === 0 ? cos * value - sin * ring[i + 1] : sin * ring[i - 1] + cos * value,
  );
  return planOf({ storeys: [{ primary: [{ outer, holes: [] }] }] }).storeys;
}

test('the plan is squared by the walls that agree; askew ones do not draw it aside', () => {
  // A cut corner and a slanted end beside three walls that are square.
  const askew = [0, 0, 10, 0, 12, 5, 8, 8, 0, 8];
  expect(sheetTurn(storeysOf(askew, 33 * DEGREE))).toBeCloseTo(-33 * DEGREE, 6);
  expect(sheetTurn(storeysOf(askew))).toBe(0);
});

test('close to 45° walls that are a little out of square are one direction', () => {
  const skewed = [0, 0, 10, 0.1, 10.1, 6, 0.1, 6.1];
  const turn = sheetTurn(storeysOf(skewed, 45 * DEGREE));
  expect(Math.abs(Math.abs(turn) - 45 * DEGREE)).toBeLessThan(1.5 * DEGREE);
});

test('a round hall is left as it is', () => {
  const round = Array.from({ length: 144 }, (_, i) => {
    const angle = ((i >> 1) / 72) * 2 * Math.PI;
    return i % 2 === 0 ? 5 * Math.cos(angle) : 5 * Math.sin(angle);
  });
  expect(sheetTurn(storeysOf(round))).toBe(0);
});
