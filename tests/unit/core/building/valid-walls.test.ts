import { expect, it } from 'vitest';
import { outerWalls } from '../../../../src/core/building/walls/outer-walls.ts';
import { isValid, validParts } from '../../../../src/core/building/walls/valid-parts.ts';
import { areaOf, combine } from '../../../../src/core/geometry/areas.ts';
import type { Polygon } from '../../../../src/core/types.ts';
import { polygonProblems } from '../../../invariants.ts';

const area = (...outer: number[]): Polygon => ({ outer: Float64Array.from(outer), holes: [] });

it('an area that hangs together in a point comes apart', () => {
  const bow = area(0, 0, 1, 0, 1, 1, 2, 1, 2, 2, 1, 2, 1, 1, 0, 1);
  expect(isValid(bow)).toBe(false);
  const parts = validParts([bow]);
  expect(parts).toHaveLength(2);
  expect(parts.every(isValid)).toBe(true);
  expect(areaOf(parts)).toBeCloseTo(2, 2);
});

it('a ring that touches itself from within gets a hole', () => {
  const pinched = area(0, 0, 4, 0, 4, 2, 3, 1.5, 3, 2.5, 4, 2, 4, 4, 0, 4);
  const parts = validParts([pinched]);
  expect(parts.every(isValid)).toBe(true);
  expect(areaOf(parts)).toBeCloseTo(15.5, 1);
});

it('spikes go, valid areas stay', () => {
  const spiked = area(0, 0, 2, 0, 2, 1, 2.005, 1, 2, 1, 0, 1);
  expect(validParts([spiked]).every(isValid)).toBe(true);
  expect(areaOf(validParts([spiked]))).toBeCloseTo(2, 2);
  const square = area(0, 0, 1, 0, 1, 1, 0, 1);
  expect(validParts([square])).toEqual([square]);
});

it('outer walls meet in mitres', () => {
  const walls = outerWalls([area(0, 0, 4, 0, 4, 3, 0, 3)], [0.3, 0.4, 0.3, 0.4]);
  expect(walls.map(({ side }) => side)).toEqual([0, 1, 2, 3]);
  for (const { outline } of walls) expect(polygonProblems(outline)).toEqual([]);
  expect(areaOf(walls.map(({ outline }) => outline))).toBeCloseTo(4.8 * 3.6 - 12, 6);
});

it.each([0.2, 0.5, 0.7])('outer walls in an alcove %f m wide do not overlap, nor stand in rooms', (width) => {
  const outline = area(0, 0, 3, 0, 3, 2, 3 + width, 2, 3 + width, 0, 7, 0, 7, 4, 0, 4);
  const walls = outerWalls([outline], Array(8).fill(0.4)).map((wall) => wall.outline);
  expect(walls.every(isValid)).toBe(true);
  expect(areaOf(combine('union', walls))).toBeCloseTo(areaOf(walls), 4);
  expect(areaOf(combine('intersection', walls, [outline]))).toBeLessThan(1e-4);
  // The alcove's two sides share it.
  const alcove = area(3, 0, 3 + width, 0, 3 + width, 2, 3, 2);
  expect(areaOf(combine('intersection', walls, [alcove]))).toBeGreaterThan(0.8 * 2 * width);
});

it('a step of a few millimetres beside a corner leaves no hole in the walls', () => {
  const [stepped, plain] = [
    area(8, 0, 8, 8, 0, 8, 0, 4, 4.005, 4, 4.005, 3.5, 4, 3.5, 4, 0),
    area(8, 0, 8, 8, 0, 8, 0, 4, 4, 4, 4, 0),
  ].map((outline) => {
    const sides = outline.outer.length / 2;
    const walls = outerWalls([outline], Array(sides).fill(0.36)).map((wall) => wall.outline);
    expect(areaOf(combine('union', walls))).toBeCloseTo(areaOf(walls), 4);
    return combine('union', [outline, ...walls]);
  });
  expect(areaOf(stepped)).toBeCloseTo(areaOf(plain), 2);
});
