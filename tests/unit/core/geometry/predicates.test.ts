import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { orientation } from '../../../../src/core/geometry/predicates.ts';

/** Whole numbers scaled by powers of two are exact in float64, so BigInt decides. */
const coordinate = fc.oneof(fc.integer({ min: -8, max: 8 }), fc.integer({ min: -(2 ** 40), max: 2 ** 40 }));

describe('orientation', () => {
  it('is positive for a counter-clockwise turn, y up', () => {
    expect(orientation(0, 0, 1, 0, 0, 1)).toBeGreaterThan(0);
    expect(orientation(0, 0, 0, 1, 1, 0)).toBeLessThan(0);
    expect(orientation(0, 0, 1, 1, 2, 2) === 0).toBe(true);
  });

  it('has the sign BigInt arithmetic gives', () => {
    fc.assert(
      fc.property(fc.tuple(...Array(6).fill(coordinate)), (values) => {
        const [ax, ay, bx, by, cx, cy] = (values as number[]).map(BigInt);
        const exact = (bx - ax) * (cy - ay) - (by - ay) * (cx - ax);
        const found = orientation(...(values as [number, number, number, number, number, number]));
        expect(Math.sign(found) + 0).toBe(Number(exact > 0n) - Number(exact < 0n));
      }),
    );
  });

  it('decides points a rounding error off a line', () => {
    const up = 0.5 + Number.EPSILON;
    expect(orientation(12, 12, 24, 24, 0.5, up)).toBeGreaterThan(0);
    expect(orientation(12, 12, 24, 24, up, 0.5)).toBeLessThan(0);
    expect(orientation(12, 12, 24, 24, 0.5, 0.5) === 0).toBe(true);
  });
});
