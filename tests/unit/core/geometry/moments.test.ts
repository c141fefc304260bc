import { expect, it } from 'vitest';
import { Moments } from '../../../../src/core/geometry/moments.ts';

it('the main axis runs along the longer side of a turned rectangle, its variance across the shorter', () => {
  const [length, width, turn] = [4, 1, 0.7];
  const moments = new Moments();
  for (const along of [-length / 2, length / 2]) {
    for (const across of [-width / 2, width / 2]) {
      const [x, y] = [
        3 + along * Math.cos(turn) - across * Math.sin(turn),
        2 + along * Math.sin(turn) + across * Math.cos(turn),
      ];
      moments.add(x, y, 2);
    }
  }
  const { x, y, angle, variance } = moments.spread();
  expect([x, y]).toEqual([expect.closeTo(3, 12), expect.closeTo(2, 12)]);
  expect(angle).toBeCloseTo(turn, 12);
  expect(variance).toBeCloseTo(width ** 2 / 4, 12);
  expect(moments.weight).toBe(8);
});

it('the middle is drawn to what weighs more', () => {
  const moments = new Moments();
  moments.add(0, 0, 3);
  moments.add(4, 8, 1);
  const { x, y, variance } = moments.spread();
  expect([x, y]).toEqual([1, 2]);
  expect(variance).toBeCloseTo(0, 12);
});
