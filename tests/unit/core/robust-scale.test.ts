import { expect, it } from 'vitest';
import { trimmedBounds, valueOfRank } from '../../../src/core/robust-scale.ts';

it('finds the value of any rank that sorting would', () => {
  const spread = Array.from({ length: 999 }, (_, i) => ((i * 0.618034) % 1) * 2000 - 1000);
  const values = Float32Array.from([...spread, 0, -0, 1e-40, -1e-40, 3e38, -3e38, 7, 7, 7]);
  const sorted = values.slice().sort();
  sorted.forEach((value, rank) => {
    expect(valueOfRank(values, rank)).toBe(value);
  });
  expect(valueOfRank(values, values.length)).toBeNaN();
});

it('trims strays on either side', () => {
  const positions = Float32Array.from({ length: 300 }, (_, i) => Math.floor(i / 3));
  positions.set([-1e6, 1e6, 1e6], 0);
  const { min, max } = trimmedBounds(positions);
  expect([...min]).toEqual([2, 3, 3]);
  expect([...max]).toEqual([97, 98, 98]);
});
