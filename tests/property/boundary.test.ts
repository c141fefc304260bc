/** What holds for every boundary of every point set: valid rings, and no dependence on order, place or direction. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../src/core/boundary.ts';
import { FloorPlanError } from '../../src/core/errors.ts';
import { pointInRing, signedArea } from '../../src/core/geometry/rings.ts';
import type { Options } from '../../src/core/params.ts';
import type { Polygon } from '../../src/core/types.ts';
import { expectValidPolygons } from '../invariants.ts';
import {
  asSlice,
  closed,
  listeningContext,
  optionsWith,
  type Path,
  randomNumbers,
  scanWalls,
} from '../unit/core/boundary/wall-slices.ts';

const METHODS = ['gift-opening', 'convex', 'alpha-shape', 'concaveman'] as const;
const real = fc.double({ min: -20, max: 20, noNaN: true }).map((v) => (Math.abs(v) < 1e-30 ? 0 : v));
const whole = fc.integer({ min: 0, max: 12 });
const scattered = fc.array(fc.tuple(real, real), { maxLength: 150 });
const lattice = fc.array(fc.tuple(whole, whole), { maxLength: 150 });
const onLine = fc.array(
  fc.tuple(whole, whole).map(([t, s]): [number, number] => [t, s === 0 ? 3 : t / 2]),
  { maxLength: 60 },
);
const circle = fc.integer({ min: 3, max: 90 }).map((n) =>
  Array.from({ length: n }, (_, k): [number, number] => {
    const angle = (2 * Math.PI * k) / n;
    return [5 * Math.cos(angle), 5 * Math.sin(angle)];
  }),
);
const clusters = fc
  .tuple(scattered, fc.constantFrom(1e-6, 1e-3, 1))
  .map(([pairs, size]) =>
    pairs.map(([x, y], k): [number, number] => [x * size + (k % 3) * 40, y * size + (k % 2) * 30]),
  );
const extreme = fc
  .tuple(fc.oneof(scattered, lattice), fc.constantFrom(1e-9, 1e-3, 1e6, 1e12))
  .map(([pairs, size]) => pairs.map(([x, y]): [number, number] => [x * size, y * size]));
const far = scattered.map((pairs) => pairs.map(([x, y]): [number, number] => [x + 691_000, y + 5_336_000]));
const anyPoints = fc.oneof(scattered, lattice, onLine, circle, clusters, extreme, far);
const anyLength = fc.constantFrom<Options['openingLength']>('auto', 0.01, 0.3, 1, 5, 100);

/** The polygons, or null for a point set that has none and says so. */
function outline(
  pairs: readonly (readonly [number, number])[],
  given: Partial<Options>,
): readonly Polygon[] | null {
  const xy = Float64Array.from(pairs.flat());
  try {
    return findBoundary(asSlice(xy), optionsWith(given), listeningContext()).polygons;
  } catch (error) {
    expect(error).toBeInstanceOf(FloorPlanError);
    expect(['input/degenerate', 'result/no-boundary']).toContain((error as FloorPlanError).code);
    return null;
  }
}

describe('every boundary method', () => {
  it.each(METHODS)('gives valid polygons for any points: %s', (boundary) => {
    fc.assert(
      fc.property(anyPoints, anyLength, fc.constantFrom(0, 3.5, 20), (pairs, openingLength, bridgeGap) => {
        const polygons = outline(pairs, { boundary, openingLength, bridgeGap });
        if (polygons !== null) expectValidPolygons(polygons);
      }),
      { numRuns: 400 },
    );
  });

  it.each(METHODS)('does not depend on the order of points or on repeats: %s', (boundary) => {
    fc.assert(
      fc.property(fc.oneof(scattered, lattice), fc.integer(), (pairs, seed) => {
        const random = randomNumbers(seed);
        const shuffled = [...pairs, ...pairs.slice(0, 20)]
          .map((pair) => ({ pair, key: random() }))
          .sort((a, b) => a.key - b.key)
          .map(({ pair }) => pair);
        expect(outline(shuffled, { boundary })).toEqual(outline(pairs, { boundary }));
      }),
    );
  });

  it('the convex one holds all points', () => {
    fc.assert(
      fc.property(anyPoints, (pairs) => {
        const polygons = outline(pairs, { boundary: 'convex' });
        if (polygons === null) return;
        for (const [x, y] of pairs) expect(pointInRing(x, y, polygons[0].outer)).toBeGreaterThanOrEqual(0);
      }),
    );
  });

  it('gift opening takes its vertices from the points, but for corners put back at gaps', () => {
    fc.assert(
      fc.property(anyPoints, anyLength, (pairs, openingLength) => {
        const polygons = outline(pairs, { openingLength, bridgeGap: 0 });
        if (polygons === null) return;
        const known = new Set(pairs.map(String));
        const { outer } = polygons[0];
        for (let i = 0; i < outer.length; i += 2) expect(known).toContain(`${outer[i]},${outer[i + 1]}`);
      }),
    );
  });
});

describe('gift opening of scanned walls', () => {
  const room: Path = [
    [0, 0],
    [7, 0],
    [7, 3],
    [4, 3],
    [4, 5],
    [0, 5],
  ];
  const areaOf = (xy: Float64Array) =>
    signedArea(findBoundary(asSlice(xy), optionsWith(), listeningContext()).polygons[0].outer);

  it('keeps its area when the walls are turned and moved', () => {
    fc.assert(
      fc.property(
        fc.integer({ min: 1, max: 1_000 }),
        fc.double({ min: 0, max: 2 * Math.PI, noNaN: true }),
        fc.constantFrom(0, 1_000, 500_000),
        (seed, angle, distance) => {
          const gaps = [{ wall: 0, from: 2, to: 3.1 }];
          const xy = scanWalls({ walls: [closed(room)], perMetre: 50, noise: 0.008, seed, gaps });
          const turned = new Float64Array(xy.length);
          for (let i = 0; i < xy.length; i += 2) {
            turned[i] = Math.cos(angle) * xy[i] - Math.sin(angle) * xy[i + 1] + distance;
            turned[i + 1] = Math.sin(angle) * xy[i] + Math.cos(angle) * xy[i + 1] - distance;
          }
          expect(areaOf(turned) / areaOf(xy)).toBeCloseTo(1, 3);
        },
      ),
      { numRuns: 30 },
    );
  });
});
