import { expect, test } from 'vitest';
import { aroundStructures } from '../../../../src/core/building/structures/around-structures.ts';
import { rectangle, reversed, secondary } from '../../solid/plans.ts';

const column = secondary(rectangle(2, 2, 0.4, 0.4), 'subtract');
const outer = rectangle(0, 0, 6, 5);

test('a column is no hole of its room', () => {
  const room = { outer, holes: [reversed(rectangle(2.01, 2, 0.4, 0.39))] };
  expect(aroundStructures(room, [column])).toEqual({ outer, holes: [] });
});

test('other holes stay', () => {
  const room = {
    outer,
    holes: [reversed(rectangle(1.5, 1.5, 1.5, 1.5)), reversed(rectangle(4, 4, 0.4, 0.4))],
  };
  expect(aroundStructures(room, [column])).toBe(room);
});

test('a stub of a column’s face is no wall of the room: it lies in the column', () => {
  const stub = reversed(rectangle(2.005, 1.99, 0.4, 0.12));
  expect(aroundStructures({ outer, holes: [stub] }, [column])).toEqual({ outer, holes: [] });
});
