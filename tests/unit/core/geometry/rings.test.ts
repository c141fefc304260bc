import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import {
  boundsOf,
  centroid,
  orientRing,
  perimeter,
  pointInPolygon,
  pointInRing,
  polygonArea,
  reverseRing,
  signedArea,
} from '../../../../src/core/geometry/rings.ts';

const square = Float64Array.of(0, 0, 2, 0, 2, 2, 0, 2);
const ell = Float64Array.of(0, 0, 4, 0, 4, 1, 1, 1, 1, 3, 0, 3);
const hole = Float64Array.of(0.5, 0.5, 0.5, 1.5, 1.5, 1.5, 1.5, 0.5);

describe('ring measures', () => {
  it('measures area, length, centre and box', () => {
    expect(signedArea(square)).toBe(4);
    expect(signedArea(ell)).toBe(6);
    expect(perimeter(ell)).toBe(14);
    expect(centroid(square)).toEqual([1, 1]);
    expect(centroid(ell)).toEqual([1.5, 1]);
    expect(boundsOf(ell)).toEqual({ minX: 0, minY: 0, maxX: 4, maxY: 3 });
    expect(polygonArea({ outer: square, holes: [hole] })).toBe(3);
  });

  it('keeps the area of a ring far from the origin', () => {
    const far = ell.map((value, i) => value + (i % 2 === 0 ? 691_000 : 5_336_000));
    expect(signedArea(far)).toBeCloseTo(6, 9);
  });

  it('reverses about the first vertex and orients', () => {
    const reversed = reverseRing(ell);
    expect([...reversed.slice(0, 4)]).toEqual([0, 0, 0, 3]);
    expect(signedArea(reversed)).toBe(-6);
    expect(orientRing(reversed, 'counter-clockwise')).toEqual(ell);
    expect(orientRing(ell, 'counter-clockwise')).toBe(ell);
    expect(signedArea(orientRing(ell, 'clockwise'))).toBe(-6);
  });
});

describe('pointInRing', () => {
  it('tells inside, border and outside', () => {
    expect(pointInRing(0.5, 2, ell)).toBe(1);
    expect(pointInRing(2, 2, ell)).toBe(-1);
    expect(pointInRing(1, 2, ell)).toBe(0);
    expect(pointInRing(1, 1, ell)).toBe(0);
    expect(pointInRing(-1, 0, ell)).toBe(-1);
    expect(pointInRing(5, 1, ell)).toBe(-1);
  });

  it('agrees with cell membership on rectilinear rings, corners and edges included', () => {
    fc.assert(
      fc.property(fc.integer({ min: -1, max: 10 }), fc.integer({ min: -1, max: 8 }), (i, j) => {
        const [x, y] = [i / 2, j / 2];
        const isInside = (x > 0 && x < 4 && y > 0 && y < 1) || (x > 0 && x < 1 && y > 0 && y < 3);
        const isIn = (x >= 0 && x <= 4 && y >= 0 && y <= 1) || (x >= 0 && x <= 1 && y >= 0 && y <= 3);
        expect(pointInRing(x, y, ell)).toBe(isInside ? 1 : isIn ? 0 : -1);
        expect(pointInRing(x, y, reverseRing(ell))).toBe(isInside ? 1 : isIn ? 0 : -1);
      }),
    );
  });

  it('leaves out holes', () => {
    const polygon = { outer: square, holes: [hole] };
    expect(pointInPolygon(1, 1, polygon)).toBe(-1);
    expect(pointInPolygon(0.5, 1, polygon)).toBe(0);
    expect(pointInPolygon(0.25, 1, polygon)).toBe(1);
    expect(pointInPolygon(3, 1, polygon)).toBe(-1);
  });
});
