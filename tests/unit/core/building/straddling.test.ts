import { expect, test } from 'vitest';
import { alongOf, type Face } from '../../../../src/core/building/faces/face.ts';
import { findStraddling } from '../../../../src/core/building/faces/straddling.ts';
import type { Vec2 } from '../../../../src/core/types.ts';

/** A face from one place to another. */
function face([ax, ay]: Vec2, [bx, by]: Vec2, noise: number): Face {
  const length = Math.hypot(bx - ax, by - ay);
  const [nx, ny] = [(by - ay) / length, (ax - bx) / length];
  const [from, to] = [alongOf({ nx, ny }, ax, ay), alongOf({ nx, ny }, bx, by)];
  return { nx, ny, offset: nx * ax + ny * ay, from, to, members: [], noise, support: 100 };
}

const [NORTH, SOUTH] = [0.12, 0];
// What is left of both faces of a thin wall once a line has run from the one to the other.
const faces = [face([3, NORTH], [6, NORTH], 0.01), face([0, SOUTH], [3, SOUTH], 0.01)];

test('a line from one face of a thin wall to its other is no surface', () => {
  const askew = face([0, NORTH + 0.01], [6, SOUTH - 0.03], 0.025);
  expect(findStraddling([...faces, askew])).toEqual([{ face: askew, other: faces[1] }]);
});

test('as sharp as the others, it is a skew wall', () => {
  expect(findStraddling([...faces, face([0, NORTH + 0.03], [6, SOUTH - 0.03], 0.012)])).toEqual([]);
});

test('walls that meet at a wide angle end to end are two', () => {
  expect(findStraddling([...faces, face([6, NORTH], [12, NORTH + 0.6], 0.025)])).toEqual([]);
});

test('a picture on a wall does not make a wavy one none', () => {
  const wavy = { ...face([0, -0.02], [4, 0.02], 0.02), support: 4000 };
  const picture = { ...face([1.5, 0], [2.1, 0], 0.004), support: 80 };
  expect(findStraddling([wavy, picture])).toEqual([]);
  expect(findStraddling([wavy, { ...picture, support: 400 }])).toHaveLength(1);
  expect(findStraddling([wavy, { ...face([1.5, 0], [3, 0], 0.004), support: 200 }])).toHaveLength(1);
});
