/** What holds for every regularised boundary: valid rings, vertices of the ring given, no privileged start. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { isCounterClockwise, orientRing, pointInRing, reverseRing } from '../../src/core/geometry/rings.ts';
import { restoreCorners } from '../../src/core/regularise/restore-corners.ts';
import {
  type SimplifyingPass,
  simplifyRing,
  simplifyRings,
} from '../../src/core/regularise/simplify-ring.ts';
import { takeOffNoise } from '../../src/core/regularise/take-off-noise.ts';
import type { Ring } from '../../src/core/types.ts';
import { expectValidPolygon, expectValidRing } from '../invariants.ts';
import { asSlice, randomNumbers } from '../unit/core/boundary/wall-slices.ts';
import { hostileRing } from './hostile-rings.ts';

const PASSES: readonly SimplifyingPass[] = ['radial', 'douglas-peucker', 'visvalingam'];
const SEED = 20_190;

const tolerances = fc.record({
  epsilon: fc.constantFrom(0, 0.01, 0.1, 0.5, 2, 10),
  areaEpsilon: fc.constantFrom(0, 1e-4, 0.01, 0.3, 5, 100),
});
const anyPasses = fc.subarray([...PASSES]);

describe('simplifyRing', () => {
  it('leaves simple rings of three vertices or more, turning as before', () => {
    fc.assert(
      fc.property(hostileRing, tolerances, anyPasses, (given, limits, passes) => {
        const found = simplifyRing(given, { ...limits, passes });
        expectValidRing(found);
        expect(found.length).toBeLessThanOrEqual(given.length);
        expect(isCounterClockwise(found)).toBe(isCounterClockwise(given));
      }),
      { numRuns: 3_000, seed: SEED },
    );
  });

  it('keeps vertices of the ring given, in its order', () => {
    fc.assert(
      fc.property(hostileRing, tolerances, anyPasses, (given, limits, passes) => {
        const places = verticesOf(simplifyRing(given, { ...limits, passes })).map((v) =>
          verticesOf(given).indexOf(v),
        );
        expect(places).not.toContain(-1);
        const wraps = places.filter((place, k) => place < places[(k + places.length - 1) % places.length]);
        expect(wraps.length).toBeLessThanOrEqual(1);
      }),
      { numRuns: 500, seed: SEED },
    );
  });

  it('gives the same vertices whichever the ring starts with and whichever way it turns', () => {
    fc.assert(
      fc.property(hostileRing, tolerances, anyPasses, fc.nat(), (given, limits, passes, shift) => {
        const vertices = (r: Ring) => verticesOf(simplifyRing(r, { ...limits, passes })).sort();
        const expected = vertices(given);
        expect(vertices(startingAt(given, shift))).toEqual(expected);
        expect(vertices(reverseRing(startingAt(given, shift)))).toEqual(expected);
      }),
      { numRuns: 2_000, seed: SEED },
    );
  });

  it('leaves no edge as short as ε after the radial pass but where the ring would cross itself', () => {
    const round = fc.tuple(fc.integer({ min: 20, max: 300 }), fc.integer()).map(([n, seed]) => {
      const random = randomNumbers(seed);
      return Float64Array.from({ length: 2 * n }, (_, i) => {
        const angle = (2 * Math.PI * ((i >> 1) + 0.9 * random())) / n;
        return 3 * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle));
      });
    });
    fc.assert(
      fc.property(round.filter(isSimple), fc.constantFrom(0.05, 0.2, 0.8), (given, epsilon) => {
        const found = simplifyRing(given, { epsilon, areaEpsilon: 0, passes: ['radial'] });
        const lengths = edgeLengths(found);
        // The two vertices the ring is cut at stay, the last but one before each may not.
        expect(Math.min(...lengths)).toBeGreaterThan(epsilon);
      }),
      { numRuns: 300, seed: SEED },
    );
  });

  it('changes nothing at tolerance 0 but vertices on straight edges', () => {
    fc.assert(
      fc.property(hostileRing, (given) => {
        const found = simplifyRing(given, { epsilon: 0, areaEpsilon: 0, passes: PASSES });
        const dropped = verticesOf(given).filter((vertex) => !verticesOf(found).includes(vertex));
        for (const vertex of dropped) {
          const [x, y] = vertex.split(',').map(Number);
          expect(distanceToRing(x, y, found)).toBeLessThan(1e-9);
        }
      }),
      { numRuns: 300, seed: SEED },
    );
  });
});

describe('simplifyRings', () => {
  it('keeps rings apart, and each in or out of the other as it was', () => {
    const many = fc.tuple(hostileRing, fc.integer(), fc.integer({ min: 1, max: 12 }));
    fc.assert(
      fc.property(many, tolerances, fc.constantFrom(...PASSES), ([given, seed, count], limits, pass) => {
        const outer = orientRing(given, 'counter-clockwise');
        const islands = smallRingsBeside(outer, seed, count);
        const { rings } = simplifyRings([outer, ...islands], pass, limits);
        const isIn = (ring: Ring, within: Ring) => pointInRing(ring[0], ring[1], within) > 0;
        const places = rings.slice(1).map((island) => isIn(island, rings[0]));
        expect(places).toEqual(islands.map((island) => isIn(island, outer)));
        const holes = rings.slice(1).filter((island) => isIn(island, rings[0]));
        expectValidPolygon({ outer: rings[0], holes });
      }),
      { numRuns: 1_000, seed: SEED },
    );
  });
});

describe('restoreCorners', () => {
  it('leaves simple rings, turning as before, whatever the points', () => {
    fc.assert(
      fc.property(hostileRing, tolerances, fc.integer(), (given, limits, seed) => {
        const simplified = simplifyRing(given, { ...limits, passes: PASSES });
        const slice = asSlice(pointsAround(given, seed));
        const [found] = restoreCorners([simplified], [given], slice);
        expectValidRing(found);
        expect(found.length).toBeLessThanOrEqual(simplified.length);
        expect(isCounterClockwise(found)).toBe(isCounterClockwise(given));
      }),
      { numRuns: 2_000, seed: SEED },
    );
  });

  it('gives the same corners whichever vertex the ring starts with and however the points are ordered', () => {
    fc.assert(
      fc.property(hostileRing, tolerances, fc.integer(), fc.nat(), (given, limits, seed, shift) => {
        const simplified = simplifyRing(given, { ...limits, passes: PASSES });
        const slice = asSlice(pointsAround(given, seed));
        const turned = { ...slice, xy: reverseRing(slice.xy) };
        const [found] = restoreCorners([simplified], [given], slice);
        const [again] = restoreCorners(
          [startingAt(simplified, shift)],
          [startingAt(given, shift + 5)],
          turned,
        );
        expect(verticesOf(again).sort()).toEqual(verticesOf(found).sort());
      }),
      { numRuns: 500, seed: SEED },
    );
  });
});

/** The vertices and points about them, three each, up to 5 cm away. */
function pointsAround(ring: Ring, seed: number): Float64Array {
  const random = randomNumbers(seed);
  return Float64Array.from({ length: 4 * ring.length }, (_, i) => {
    return ring[i % ring.length] + (i < ring.length ? 0 : 0.1 * (random() - 0.5));
  });
}

/** Triangles clear of each other and of the ring, clockwise, as holes turn; some in it, some out. */
function smallRingsBeside(ring: Ring, seed: number, count: number): Ring[] {
  const random = randomNumbers(seed);
  const found: Ring[] = [];
  for (let k = 0; k < count; k++) {
    const at = 2 * Math.floor((random() * ring.length) / 2);
    const [x, y] = [ring[at] + 0.4 * (random() - 0.5), ring[at + 1] + 0.4 * (random() - 0.5)];
    const isClear = [ring, ...found].every((other) => distanceToRing(x, y, other) > 0.005);
    if (isClear) found.push(Float64Array.of(x, y, x + 0.002, y + 0.003, x + 0.003, y));
  }
  return found;
}

function startingAt(ring: Ring, shift: number): Ring {
  const at = (2 * shift) % ring.length;
  return Float64Array.from([...ring.subarray(at), ...ring.subarray(0, at)]);
}

function isSimple(ring: Ring): boolean {
  return edgeLengths(ring).every((length) => length > 0);
}

function edgeLengths(ring: Ring): number[] {
  return Array.from({ length: ring.length / 2 }, (_, k) => {
    const m = (k + 1) % (ring.length / 2);
    return Math.hypot(ring[2 * m] - ring[2 * k], ring[2 * m + 1] - ring[2 * k + 1]);
  });
}

function distanceToRing(x: number, y: number, ring: Ring): number {
  return Math.min(
    ...Array.from({ length: ring.length / 2 }, (_, k) => {
      const m = (k + 1) % (ring.length / 2);
      const [ax, ay, ux, uy] = [
        ring[2 * k],
        ring[2 * k + 1],
        ring[2 * m] - ring[2 * k],
        ring[2 * m + 1] - ring[2 * k + 1],
      ];
      const share = Math.max(0, Math.min(1, ((x - ax) * ux + (y - ay) * uy) / (ux * ux + uy * uy)));
      return Math.hypot(x - ax - share * ux, y - ay - share * uy);
    }),
  );
}

function verticesOf(r: Ring): string[] {
  return Array.from({ length: r.length / 2 }, (_, k) => `${r[2 * k]},${r[2 * k + 1]}`);
}

describe('takeOffNoise', () => {
  it('leaves simple rings of as many vertices, turning as before, whatever the points', () => {
    fc.assert(
      fc.property(hostileRing, fc.integer(), (given, seed) => {
        const [found] = takeOffNoise([given], asSlice(pointsAround(given, seed)));
        expectValidRing(found);
        expect(found.length).toBe(given.length);
        expect(isCounterClockwise(found)).toBe(isCounterClockwise(given));
      }),
      { numRuns: 2_000, seed: SEED },
    );
  });

  it('moves each vertex the same way whichever comes first and however the points are ordered', () => {
    fc.assert(
      fc.property(hostileRing, fc.integer(), fc.nat(), (given, seed, shift) => {
        const slice = asSlice(pointsAround(given, seed));
        const [found] = takeOffNoise([given], slice);
        const [again] = takeOffNoise([startingAt(given, shift)], { ...slice, xy: reverseRing(slice.xy) });
        expect(verticesOf(again).sort()).toEqual(verticesOf(found).sort());
      }),
      { numRuns: 500, seed: SEED },
    );
  });
});
