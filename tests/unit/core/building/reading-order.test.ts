import { expect, it } from 'vitest';
import { inReadingOrder } from '../../../../src/core/building/reading-order.ts';
import { rotationBy } from '../../../../src/core/geometry/square-turn.ts';
import { mapped } from '../../../../src/core/sheet.ts';
import type { Polygon } from '../../../../src/core/types.ts';

const room = (minX: number, minY: number, maxX: number, maxY: number): Polygon => ({
  outer: Float64Array.of(minX, minY, maxX, minY, maxX, maxY, minX, maxY),
  holes: [],
});

/** Two rows of rooms of unlike depths along a corridor. */
const PLAN = [
  room(0, 8, 6, 13),
  room(6.1, 8, 12, 12),
  room(12.1, 8, 24, 13),
  room(0, 6, 24, 7.9),
  room(0, 0, 10, 5.9),
  room(10.1, 1, 24, 5.9),
];

it.each([0, 5, -12, 40])('rooms of a plan turned by %i° are read row by row, as on its sheet', (degrees) => {
  const turn = rotationBy((degrees * Math.PI) / 180);
  const turned = PLAN.map(({ outer }) => ({ outer: mapped(outer, turn), holes: [] }));
  const shuffled = [4, 2, 0, 5, 3, 1].map((i) => turned[i]);
  expect(inReadingOrder(shuffled)).toEqual(turned);
});

it('a deep room is of the row in which it begins', () => {
  const plan = [room(0, 4, 5, 10), room(5.1, 8, 9, 9.99), room(5.1, 4, 9, 7.9)];
  expect(inReadingOrder([2, 1, 0].map((i) => plan[i]))).toEqual(plan);
});
