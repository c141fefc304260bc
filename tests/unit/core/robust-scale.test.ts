import { expect, it } from 'vitest';
import { valueOfRank, weightedMedian } from '../../../src/core/robust-scale.ts';

it('finds the value of any rank that sorting would', () => {
  const spread = Array.from({ length: 999 }, (_, i) => ((i * 0.618034) % 1) * 2000 - 1000);
  const values = Float32Array.from([...spread, 0, -0, 1e-40, -1e-40, 3e38, -3e38, 7, 7, 7]);
  const sorted = values.slice().sort();
  sorted.forEach((value, rank) => {
    expect(valueOfRank(values, rank)).toBe(value);
  });
  expect(valueOfRank(values, values.length)).toBeNaN();
});

it('finds the value at or below which half of the weight lies', () => {
  expect(weightedMedian([3, 1, 2], [1, 1, 1])).toBe(2);
  expect(weightedMedian([3, 1, 2], [5, 1, 1])).toBe(3);
  expect(weightedMedian([3, 1, 2], [1, 2, 1])).toBe(1);
  expect(weightedMedian([], [])).toBeNaN();
});
