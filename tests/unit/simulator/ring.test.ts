import { describe, expect, it } from 'vitest';
import {
  bulge,
  convexOverlap,
  distance,
  inset,
  perimeter,
  rectangle,
  signedArea,
  withoutCollinear,
} from '../../../fixtures/simulator/ring.ts';

describe('ring', () => {
  it('insets every edge by the same distance', () => {
    expect(inset(rectangle(0, 0, 4, 3), 0.5)).toEqual([
      [0.5, 0.5],
      [3.5, 0.5],
      [3.5, 2.5],
      [0.5, 2.5],
    ]);
    expect(signedArea(inset(rectangle(0, 0, 4, 3), -1))).toBeCloseTo(30, 12);
  });

  it('insets an L at its inner corner too', () => {
    const ell = [
      [0, 0],
      [4, 0],
      [4, 2],
      [2, 2],
      [2, 4],
      [0, 4],
    ] as const;
    const inner = inset(ell, 0.1);
    expect(inner[3][0]).toBeCloseTo(1.9, 12);
    expect(inner[3][1]).toBeCloseTo(1.9, 12);
    expect(signedArea(inner)).toBeCloseTo(12 - 0.1 * perimeter(ell) + 4 * 0.01, 12);
  });

  it('bulges outwards by the rise, along a circle', () => {
    const points = bulge([0, 0], [6, 0], 3);
    expect(points[0]).toEqual([0, 0]);
    expect(points[points.length - 1]).toEqual([6, 0]);
    for (const point of points) expect(distance(point, [3, 0])).toBeCloseTo(3, 9);
    expect(Math.min(...points.map(([, y]) => y))).toBeCloseTo(-3, 3);
  });

  it('turns by less than 5° a vertex along an arc', () => {
    for (const rise of [0.05, 0.5, 3]) {
      const points = bulge([0, 0], [6, 0], rise);
      const headings = points.slice(1).map(([x, y], i) => Math.atan2(y - points[i][1], x - points[i][0]));
      const turns = headings.slice(1).map((heading, i) => ((heading - headings[i]) * 180) / Math.PI);
      expect(Math.min(...turns)).toBeGreaterThan(0);
      expect(Math.max(...turns)).toBeLessThan(5);
    }
  });

  it('drops collinear vertices only', () => {
    expect(
      withoutCollinear([
        [0, 0],
        [1, 0],
        [2, 0],
        [2, 2],
        [0, 2],
      ]),
    ).toHaveLength(4);
  });

  it('tells overlap from touch', () => {
    expect(convexOverlap(rectangle(0, 0, 1, 1), rectangle(1, 0, 1, 1))).toBe(false);
    expect(convexOverlap(rectangle(0, 0, 1, 1), rectangle(0.9, 0.9, 1, 1))).toBe(true);
  });
});
