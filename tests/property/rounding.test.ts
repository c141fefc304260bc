/** What files hold of polygons that rounding finds hard: slivers, hairs, rings that all but touch. */
import fc from 'fast-check';
import { expect, test } from 'vitest';
import { orientRing, perimeter, polygonArea, ringsOf } from '../../src/core/geometry/rings.ts';
import type { Polygon, Ring } from '../../src/core/types.ts';
import { rounded } from '../../src/write/decimals.ts';
import { roundedPolygons } from '../../src/write/rounded-polygons.ts';
import { polygonProblems } from '../invariants.ts';
import { hostileRing } from './hostile-rings.ts';

const SEED = 2019;
const DIGITS = 4;
const STEP = 10 ** -DIGITS;

const place = (x: number, y: number) => [rounded(x, DIGITS), rounded(y, DIGITS)] as const;

/** Rings at home's size, and so small that a step is as wide as their necks. */
const outer = fc
  .tuple(hostileRing, fc.constantFrom(1, 0.03, 1e-3))
  .map(([ring, size]) =>
    orientRing(
      ring.map((value, i) => ring[i % 2] + size * (value - ring[i % 2])),
      'counter-clockwise',
    ),
  )
  .filter((ring) => polygonProblems({ outer: ring, holes: [] }).length === 0);

/** A rectangle with a slot, and rows of holes that leave walls of about a step between them. */
const pierced = fc
  .tuple(
    fc.integer({ min: 1, max: 8 }),
    fc.double({ min: 0.05 * STEP, max: 5 * STEP, noNaN: true }),
    fc.double({ min: 0, max: STEP, noNaN: true }),
    fc.double({ min: -STEP, max: STEP, noNaN: true }),
  )
  .map(([count, gap, offset, slant]): Polygon => {
    const holes = Array.from({ length: count }, (_, k): Ring => {
      const [x, far] = [gap + k * (1 + gap) + offset, k * (1 + gap) + 1 + gap + offset - gap / 3];
      return Float64Array.of(x, gap, x - slant / 10, 1, far - slant / 10, 1 + slant / 20, far, gap);
    });
    const end = count * (1 + gap) + gap + offset;
    return { outer: Float64Array.of(0, 0, end, 0, end, 1 + gap, 0, 1 + gap), holes };
  })
  .filter((polygon) => polygonProblems(polygon).length === 0);

const polygon = fc.oneof(
  outer.map((ring): Polygon => ({ outer: ring, holes: [] })),
  pierced,
);

test('every rounded polygon is valid, turned and without a point twice, and no more is lost than rounding loses', () => {
  const seen = { whole: 0, cut: 0, gone: 0 };
  fc.assert(
    fc.property(polygon, (given) => {
      const written = roundedPolygons(given, place).map((one) => one.rounded);
      for (const one of written) {
        expect(polygonProblems(one)).toEqual([]);
        const rings = ringsOf([one]);
        const vertices = rings.flatMap((ring) =>
          Array.from({ length: ring.length / 2 }, (_, k) => `${ring[2 * k]} ${ring[2 * k + 1]}`),
        );
        expect(new Set(vertices).size).toBe(vertices.length);
        for (const value of rings.flatMap((ring) => [...ring])) expect(value).toBe(rounded(value, DIGITS));
      }
      const length = ringsOf([given]).reduce((sum, ring) => sum + perimeter(ring), 0);
      const area = written.reduce((sum, one) => sum + polygonArea(one), 0);
      expect(Math.abs(polygonArea(given) - area)).toBeLessThanOrEqual(2 * STEP * (length + STEP));
      seen[written.length === 0 ? 'gone' : written.length === 1 ? 'whole' : 'cut']++;
    }),
    { seed: SEED, numRuns: 1500 },
  );
  // The rings are hard enough to need every way out.
  for (const count of Object.values(seen)) expect(count).toBeGreaterThan(10);
});

test('a gap in a wall that rounding closes is filled', () => {
  const notched = Float64Array.of(0, 0, 0.2, 0, 0.2, 2, 0, 2, 0, 1.000004, 0.12, 1.000001, 0, 1.0);
  const written = roundedPolygons({ outer: notched, holes: [] }, place);
  expect(written.map(({ rounded: { outer } }) => outer.length)).toEqual([8]);
  expect(polygonArea(written[0].rounded)).toBeCloseTo(0.4, 9);
});

test('a wall into which a slit of a micrometre leads, with a hole at its end, stays', () => {
  const slit = [-1.517958, -2.852611, -1.446376, -2.838685, -1.446551, -2.836869, -1.437038, -2.836869];
  const end = [-1.418993, -2.833359, -1.51796, -2.852612, -1.477343, -3.061408, -1.455544, -3.085325];
  const side = [-1.374869, -2.966283, -1.398585, -2.832556, -1.39836, 0.328083, -1.517733, 0.32809];
  const given = { outer: Float64Array.of(...side, ...slit, ...end), holes: [] };
  const written = roundedPolygons(given, place).map((one) => one.rounded);
  expect(written.flatMap((one) => polygonProblems(one))).toEqual([]);
  expect(written.reduce((sum, one) => sum + polygonArea(one), 0)).toBeCloseTo(polygonArea(given), 3);
});
