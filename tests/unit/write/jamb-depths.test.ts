import { expect, test } from 'vitest';
import type { Opening } from '../../../src/core/types.ts';
import { openingBoxes } from '../../../src/solid/opening-boxes.ts';
import { jambDepths } from '../../../src/write/jamb-depths.ts';
import { planOf, rectangle, ring } from '../solid/plans.ts';

const window = (x0: number, x1: number): Opening => ({
  ...{ type: 'window', from: [x0, 0], to: [x1, 0], sill: 0.9, head: 2, confidence: 1 },
});

function depthsOf(outlines: readonly Float64Array[], opening: Opening) {
  const walls = outlines.map((outer) => ({
    outline: { outer, holes: [] },
    ...{ thickness: 0.4, confidence: 1 },
  }));
  const { storeys } = planOf({ storeys: [{ walls, openings: [opening] }] });
  return jambDepths(openingBoxes(storeys[0])[0]).map(({ low, high }) => [low, high]);
}

test('a window that reaches 3 cm into a corner is as deep as its wall at both jambs', () => {
  const corner = ring(-0.4, -0.9, 0, -0.9, 0, -0.2, 3, -0.2, 3, 0.2, -0.4, 0.2);
  const [left, right] = depthsOf([corner], window(-0.03, 1.1));
  expect(left).toEqual(right);
  expect(left[0]).toBeCloseTo(-0.2, 6);
  expect(left[1]).toBeCloseTo(0.2, 6);
});

test('faces a little out of parallel are followed', () => {
  const [left, right] = depthsOf([ring(0, -0.2, 4, -0.21, 4, 0.2, 0, 0.2)], window(1, 3));
  expect(left[0]).toBeCloseTo(-0.2025, 3);
  expect(right[0]).toBeCloseTo(-0.2075, 3);
  expect(depthsOf([rectangle(0, -0.2, 4, 0.4)], window(1, 3))).toEqual([
    [-0.2, 0.2],
    [-0.2, 0.2],
  ]);
});
