import { expect, it } from 'vitest';
import { trimmedBounds } from '../../../src/core/cloud-bounds.ts';

it('trims strays on either side', () => {
  const positions = Float32Array.from({ length: 300 }, (_, i) => Math.floor(i / 3));
  positions.set([-1e6, 1e6, 1e6], 0);
  const { min, max } = trimmedBounds(positions);
  expect([...min]).toEqual([2, 3, 3]);
  expect([...max]).toEqual([97, 98, 98]);
});
