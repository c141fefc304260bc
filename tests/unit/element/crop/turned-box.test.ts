import { expect, it } from 'vitest';
import { parseCrop } from '../../../../src/core/crop-box.ts';
import type { Frame } from '../../../../src/core/types.ts';
import {
  cornersOf,
  cropOf,
  headingOf,
  inTurnedAxes,
  turnedBox,
} from '../../../../src/element/crop/turned-box.ts';

const FRAME: Frame = {
  origin: [500_000, 5_300_000, 520],
  planOrigin: [500_000, 5_300_000, 520],
  rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  metresPerUnit: 0.3048,
  unit: 'ft',
  up: 'z',
  tilt: 0,
};

it.each([
  '500010,5300005,500030,5300020',
  '500010,5300005,500030,5300020@17.25',
  '500010,5300005,500030,5300020@-90',
])('%s comes back as it was', (text) => {
  const { heights, ...crop } = parseCrop(text)!;
  const box = cropOf(FRAME, turnedBox(FRAME, { ...crop, heights }));
  expect(box.heading).toBe(crop.heading);
  for (const name of ['x0', 'y0', 'x1', 'y1'] as const) expect(box[name]).toBeCloseTo(crop[name], 6);
});

it('stands square in its own axes and turned on the plan', () => {
  const box = { heading: 30, low: [1, 2], high: [5, 4] } as const;
  const corners = cornersOf(box);
  expect(corners[1][0] - corners[0][0]).toBeCloseTo(4 * Math.cos(Math.PI / 6), 12);
  expect(corners[1][1] - corners[0][1]).toBeCloseTo(4 * Math.sin(Math.PI / 6), 12);
  expect(inTurnedAxes(corners[2], 30)[0]).toBeCloseTo(5, 12);
  expect(inTurnedAxes(corners[2], 30)[1]).toBeCloseTo(4, 12);
});

it('lies along a sheet that the plan is turned on', () => {
  expect(headingOf(0)).toBe(0);
  // The sheet's right is the plan's direction at −turn.
  expect(headingOf((-12.345 * Math.PI) / 180)).toBeCloseTo(12.35, 2);
});
