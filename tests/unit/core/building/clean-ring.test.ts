import { expect, it } from 'vitest';
import { cleanRing } from '../../../../src/core/building/space/clean-ring.ts';

const clean = (...xy: number[]) =>
  [...cleanRing(Float64Array.from(xy))].map((value) => +value.toFixed(3) + 0);

it('a very short edge gives way to the corner of its neighbours', () => {
  expect(clean(0, 0, 4, 0, 4, 2.97, 3.97, 3, 0, 3)).toEqual([0, 0, 4, 0, 4, 3, 0, 3]);
});

it('a spike of space between two fits of one face goes, pointed or blunt', () => {
  expect(clean(0, 0, 3.98, 0, 4, -0.3, 4, 3, 0, 3)).toEqual([0, 0, 4, 0, 4, 3, 0, 3]);
  expect(clean(0, 0, 3.97, 0, 3.97, -0.3, 4, -0.3, 4, 3, 0, 3)).toEqual([0, 0, 4, 0, 4, 3, 0, 3]);
});

it('a thin wall that stands in the room stays, and so does a niche', () => {
  const wall = [0, 0, 2, 0, 2.02, 1.5, 2.04, 0, 4, 0, 4, 3, 0, 3];
  expect(clean(...wall)).toEqual(wall);
  const niche = [0, 0, 2, 0, 2, -0.3, 2.3, -0.3, 2.3, 0, 4, 0, 4, 3, 0, 3];
  expect(clean(...niche)).toEqual(niche);
});
