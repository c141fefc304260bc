import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  lineIntersection,
  segmentsTouch,
  squaredDistanceToSegment,
} from '../../../../src/core/geometry/segments.ts';

const small = fc.integer({ min: 0, max: 4 });
type Eight = [number, number, number, number, number, number, number, number];

/** Segments on a 5 × 5 lattice share a point exactly when some rational parameter pair says so. */
function touchesExactly([ax, ay, bx, by, cx, cy, dx, dy]: Eight): boolean {
  const on = (px: number, py: number, qx: number, qy: number, rx: number, ry: number) =>
    (qx - px) * (ry - py) === (qy - py) * (rx - px) &&
    Math.min(px, qx) <= rx &&
    rx <= Math.max(px, qx) &&
    Math.min(py, qy) <= ry &&
    ry <= Math.max(py, qy);
  if (on(ax, ay, bx, by, cx, cy) || on(ax, ay, bx, by, dx, dy)) return true;
  if (on(cx, cy, dx, dy, ax, ay) || on(cx, cy, dx, dy, bx, by)) return true;
  const cross = (bx - ax) * (dy - cy) - (by - ay) * (dx - cx);
  if (cross === 0) return false;
  const s = ((cx - ax) * (dy - cy) - (cy - ay) * (dx - cx)) / cross;
  const t = ((cx - ax) * (by - ay) - (cy - ay) * (bx - ax)) / cross;
  return s > 0 && s < 1 && t > 0 && t < 1;
}

describe('segments', () => {
  it('touch as an exact test says', () => {
    fc.assert(
      fc.property(fc.tuple(...Array(8).fill(small)), (values) => {
        const segment = values as Eight;
        expect(segmentsTouch(...segment)).toBe(touchesExactly(segment));
      }),
      { numRuns: 2_000 },
    );
  });

  it('meet where their lines do', () => {
    expect(lineIntersection(0, 0, 1, 1, 4, 0, 3, 1)).toEqual([2, 2]);
    expect(lineIntersection(0, 0, 1, 0, 0, 1, 5, 1)).toBeNull();
  });

  it('lie as far as their nearest point', () => {
    expect(squaredDistanceToSegment(1, 2, 0, 0, 4, 0)).toBe(4);
    expect(squaredDistanceToSegment(7, 4, 0, 0, 4, 0)).toBe(25);
    expect(squaredDistanceToSegment(3, 4, 0, 0, 0, 0)).toBe(25);
  });
});
