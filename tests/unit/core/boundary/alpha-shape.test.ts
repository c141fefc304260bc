import Delaunator from 'delaunator';
import { describe, expect, it } from 'vitest';
import { alphaShape } from '../../../../src/core/boundary/alpha-shape.ts';
import { distinctPoints } from '../../../../src/core/geometry/point-order.ts';
import { polygonArea, signedArea } from '../../../../src/core/geometry/rings.ts';
import { expectValidPolygons } from '../../../invariants.ts';
import { randomNumbers } from './wall-slices.ts';

/** Triangles of circumradius up to α, by Heron's formula, and their area. */
function keptArea(points: Float64Array, alpha: number): number {
  const { triangles } = new Delaunator(points);
  let area = 0;
  for (let t = 0; t < triangles.length; t += 3) {
    const at = (k: number) => [points[2 * triangles[t + k]], points[2 * triangles[t + k] + 1]] as const;
    const side = (k: number, m: number) => Math.hypot(at(k)[0] - at(m)[0], at(k)[1] - at(m)[1]);
    const [a, b, c] = [side(0, 1), side(1, 2), side(2, 0)];
    const s = (a + b + c) / 2;
    const own = Math.sqrt(Math.max(0, s * (s - a) * (s - b) * (s - c)));
    if ((a * b * c) / (4 * own) <= alpha) area += own;
  }
  return area;
}

const numbers = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10];

describe('alphaShape', () => {
  it.each(numbers)(
    'has the area of the triangles it is made of, holes and parts included, seed %i',
    (seed) => {
      const random = randomNumbers(seed);
      const points = distinctPoints(Float64Array.from({ length: 1_200 }, () => 10 * random()));
      for (const alpha of [0.15, 0.2, 0.3, 0.45, 0.6]) {
        const polygons = alphaShape(points, alpha);
        const area = polygons.reduce((sum, polygon) => sum + polygonArea(polygon), 0);
        expect(area).toBeCloseTo(keptArea(points, alpha), 8);
        expectValidPolygons(polygons);
      }
    },
  );

  it('has holes and parts in those sets', () => {
    const random = randomNumbers(1);
    const points = distinctPoints(Float64Array.from({ length: 1_200 }, () => 10 * random()));
    const polygons = alphaShape(points, 0.45);
    expect(polygons.reduce((sum, { holes }) => sum + holes.length, 0)).toBeGreaterThan(5);
    expect(alphaShape(points, 0.2).length).toBeGreaterThan(5);
  });

  it('leaves the court of a courtyard house as a hole of its size', () => {
    const xy: number[] = [];
    for (let x = 0; x <= 60; x++) {
      for (let y = 0; y <= 60; y++) if (x <= 15 || x >= 45 || y <= 15 || y >= 45) xy.push(x / 10, y / 10);
    }
    const [{ outer, holes }, ...others] = alphaShape(distinctPoints(Float64Array.from(xy)), 0.08);
    expect(others).toEqual([]);
    expect(signedArea(outer)).toBeCloseTo(36, 9);
    // Half a cell is cut off each of its corners.
    expect(holes.map(signedArea)).toEqual([expect.closeTo(4 * 0.005 - 9, 9)]);
  });
});
