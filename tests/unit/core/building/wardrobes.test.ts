import { expect, it } from 'vitest';
import { seededRandom } from '../../../../fixtures/simulator/random.ts';
import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import { localCeiling } from '../../../../src/core/building/columns/local-ceiling.ts';
import { findRooms } from '../../../../src/core/building/space/find-rooms.ts';
import { makeCloud } from '../made-scan.ts';

const [WIDTH, DEPTH, HEIGHT, GRID] = [5, 4, 2.6, 0.025];

/** m² of a room of 5 m × 4 m in which a box stands before a wall up to the ceiling, its walls with so much noise, m. */
function areaWith([from, to, front]: readonly [number, number, number], noise: number): number {
  const random = seededRandom(5);
  const xyz: number[] = [];
  for (let x = GRID / 2; x < WIDTH; x += GRID)
    for (let y = GRID / 2; y < DEPTH; y += GRID)
      if (!(x > from && x < to && y < front)) xyz.push(x, y, 0, x, y, HEIGHT);
  const corners = [
    [0, 0],
    [from, 0],
    [from, front],
    [to, front],
    [to, 0],
    [WIDTH, 0],
    [WIDTH, DEPTH],
    [0, DEPTH],
    [0, 0],
  ];
  corners.slice(1).forEach(([bx, by], i) => {
    const [ax, ay] = corners[i];
    const length = Math.hypot(bx - ax, by - ay);
    for (let t = GRID / 2; t < length; t += GRID) {
      for (let z = GRID / 2; z < HEIGHT; z += GRID) {
        const off = noise * random.normal();
        xyz.push(
          ax + (t * (bx - ax) - off * (by - ay)) / length,
          ay + (t * (by - ay) + off * (bx - ax)) / length,
          z,
        );
      }
    }
  });
  const cloud = makeCloud(xyz);
  const kept = Uint32Array.from({ length: cloud.positions.length / 3 }, (_, i) => i);
  const columns = heightColumns(cloud, kept, { floor: 0, ceiling: HEIGHT });
  const { rooms } = findRooms(cloud, columns, localCeiling(columns));
  expect(rooms).toHaveLength(1);
  return rooms[0].areaM2;
}

const WHOLE = WIDTH * DEPTH;

it.each([
  ['before a wall', [1.5, 3.1, 0.55]],
  ['in a corner before', [0, 1.6, 0.55]],
  ['in a corner after', [3.4, 5, 0.55]],
] as const)('a box like a wardrobe %s is none of the walls where noise hides its gap', (_, box) => {
  expect(areaWith(box, 0.016)).toBeCloseTo(WHOLE, 0);
});

it.each([
  ['whose end is as sharp as any', [1.5, 3.1, 0.55], 0.003],
  ['as narrow as a pilaster', [1.5, 2.1, 0.55], 0.016],
  ['as deep as a room', [1.5, 3.1, 1.1], 0.016],
] as const)('a box %s is a wall', (_, box, noise) => {
  const solid = (box[1] - box[0]) * box[2];
  expect(Math.abs(areaWith(box, noise) - (WHOLE - solid))).toBeLessThan(0.2);
});
