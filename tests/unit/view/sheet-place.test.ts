import { expect, it, test } from 'vitest';
import type { Drawing } from '../../../src/view/parse-drawing.ts';
import { flatten, invert, placementFor, resizeCursor, sightOf } from '../../../src/view/sheet-place.ts';
import { planOf } from '../solid/plans.ts';

const { frame } = planOf({ storeys: [{}] });

/** A sheet at 1:100, turned, its plan's origin somewhere. */
function sheet(turn: number, metresPerUnit: number, planOrigin: readonly [number, number, number]) {
  const [c, s] = [10 * Math.cos(turn), 10 * Math.sin(turn)];
  const drawing = { planToSheet: [c, -s, -s, -c, 150, 90] } as unknown as Drawing;
  return { drawing, frame: { ...frame, metresPerUnit, planOrigin } };
}

it('shows the same of another sheet, turned, scaled and placed otherwise', () => {
  const size = [640, 480] as const;
  const before = sheet(0.2, 0.001, [691_000_000, 5_336_000_000, 0]);
  const after = sheet(-0.5, 0.0021, [690_990_000, 5_336_004_000, 0]);
  const sight = sightOf(before, { zoom: 3.3, x: -40, y: 25 }, size);
  const same = sightOf(after, placementFor(sight, after, size), size);
  expect(same.x).toBeCloseTo(sight.x, 3);
  expect(same.y).toBeCloseTo(sight.y, 3);
  expect(same.pixelsPerUnit).toBeCloseTo(sight.pixelsPerUnit, 12);
});

it('finds the place of the plan at a place of the sheet', () => {
  const [x, y] = invert([0, 2, -3, 0, 5, 7], -3 * 4 + 5, 2 * 6 + 7);
  expect([x, y]).toEqual([6, 4]);
});

test.each([
  [[1, 0], 'ew-resize'],
  [[0, -1], 'ns-resize'],
  [[1, 1], 'nesw-resize'],
  [[-1, 1], 'nwse-resize'],
] as const)('an edge that moves along %j is taken by %s, y upwards', (direction, cursor) => {
  expect(resizeCursor(direction, sheet(0.05, 1, [0, 0, 0]).drawing)).toBe(cursor);
});

it('lays points flat along their axis of least extent, into the window', () => {
  const { xy, planToSheet } = flatten(Float32Array.of(0, 5, 0, 4, 5.1, 2, 1, 5, 1), [200, 100], 10);
  expect([...xy]).toEqual([0, 0, 4, 2, 1, 1]);
  expect(planToSheet[0]).toBe(40);
});
