import { expect, test } from 'vitest';
import { areaOf, combine } from '../../../src/core/geometry/areas.ts';
import type { Polygon } from '../../../src/core/types.ts';
import { separatePinches } from '../../../src/solid/pinches.ts';
import { polygonProblems } from '../../invariants.ts';
import { rectangle, reversed, rotated } from './plans.ts';

const area = (polygon: Polygon): number => areaOf([polygon]);
const box = (x: number, y: number, width: number, depth: number): Polygon => ({
  outer: rectangle(x, y, width, depth),
  holes: [],
});

test('union, difference and intersection have the areas of sets', () => {
  const [a, b] = [box(0, 0, 4, 3), box(2, 1, 4, 1)];
  expect(areaOf(combine('union', [a], [b]))).toBeCloseTo(12 + 2, 9);
  expect(areaOf(combine('difference', [a], [b]))).toBeCloseTo(12 - 2, 9);
  expect(areaOf(combine('intersection', [a], [b]))).toBeCloseTo(2, 9);
});

test('holes come back clockwise, islands as polygons of their own', () => {
  const ringOfMaterial = combine('difference', [box(0, 0, 10, 10)], [box(2, 2, 6, 6)]);
  const withIsland = combine('union', ringOfMaterial, [box(4, 4, 2, 2)]);
  expect(withIsland.map(({ holes }) => holes.length).sort()).toEqual([0, 1]);
  expect(withIsland.flatMap((polygon) => polygonProblems(polygon))).toEqual([]);
  expect(areaOf(withIsland)).toBeCloseTo(100 - 36 + 4, 9);
});

test('rings turned the wrong way are taken as meant', () => {
  const clockwise = { outer: reversed(rectangle(0, 0, 2, 2)), holes: [rectangle(0.5, 0.5, 1, 1)] };
  expect(areaOf(combine('union', [clockwise]))).toBeCloseTo(3, 9);
});

test('a wall and the room within it join without a seam', () => {
  const angle = 0.3;
  const inner = rotated(rectangle(0, 0, 4, 3), angle);
  const wall = { outer: rotated(rectangle(-0.2, -0.2, 4.4, 3.4), angle), holes: [reversed(inner)] };
  const joined = combine('union', [wall], [{ outer: inner, holes: [] }]);
  expect(joined).toHaveLength(1);
  expect(joined[0].holes).toEqual([]);
  expect(joined[0].outer.length / 2).toBe(4);
});

test('kilometres from the origin nothing is lost', () => {
  const far = combine('difference', [box(5_400_000, 300_000, 4, 3)], [box(5_400_001, 300_001, 1, 1)]);
  expect(areaOf(far)).toBeCloseTo(11, 9);
});

test('a point where a polygon touches itself is knocked out, and nothing else', () => {
  const touching = combine('difference', [box(0, 0, 4, 4)], [box(1, 1, 1, 1), box(2, 2, 1, 1)]);
  const separate = separatePinches(touching);
  expect(areaOf(separate)).toBeCloseTo(14, 6);
  for (const { outer, holes } of separate) {
    const vertices = [outer, ...holes].flatMap((ring) =>
      Array.from({ length: ring.length / 2 }, (_, i) => `${ring[2 * i]} ${ring[2 * i + 1]}`),
    );
    expect(new Set(vertices).size).toBe(vertices.length);
  }
});

test('nothing in, nothing out', () => {
  expect(combine('union', [])).toEqual([]);
  expect(combine('difference', [], [box(0, 0, 1, 1)])).toEqual([]);
  expect(area(box(0, 0, 1, 1))).toBe(1);
});
