/** What holds for every regularised boundary: valid rings, vertices of the ring given, no privileged start. */
import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { reverseRing } from '../../src/core/geometry/rings.ts';
import { simplifyRing, simplifyRings } from '../../src/core/regularise/simplify-ring.ts';
import type { RegularisationPass, Ring } from '../../src/core/types.ts';
import { expectValidPolygon, expectValidRing, ringProblems } from '../invariants.ts';
import { randomNumbers } from '../unit/core/boundary/wall-slices.ts';

const PASSES: readonly RegularisationPass[] = ['radial', 'douglas-peucker', 'visvalingam'];

/** Rings with thin necks and spikes: a wobbling radius, often nearly touching itself after simplification. */
const ring = fc
  .tuple(fc.integer({ min: 3, max: 200 }), fc.integer(), fc.double({ min: 0, max: 1, noNaN: true }))
  .map(([n, seed, wobble]): Ring => {
    const random = randomNumbers(seed);
    const vertices = new Float64Array(2 * n);
    for (let k = 0; k < n; k++) {
      const radius = 1 + 0.98 * wobble * (random() - 1);
      vertices[2 * k] = 4 * radius * Math.cos((2 * Math.PI * k) / n);
      vertices[2 * k + 1] = 3 * radius * Math.sin((2 * Math.PI * k) / n);
    }
    return vertices;
  });
/** A comb with teeth thinner than most tolerances. */
const comb = fc
  .tuple(fc.integer({ min: 1, max: 25 }), fc.constantFrom(0.001, 0.02, 0.1))
  .map(([teeth, width]): Ring => {
    const vertices = [0, 0, teeth, 0];
    for (let k = teeth; k > 0; k--)
      vertices.push(k, 2, k - width, 2, k - width, width, k - 1 + width, width, k - 1 + width, 2);
    return Float64Array.from(vertices);
  });
const anyRing = fc.oneof(ring, comb).filter((candidate) => ringProblems(candidate).length === 0);
const tolerances = fc.record({
  epsilon: fc.constantFrom(0, 0.01, 0.1, 0.5, 2, 10),
  areaEpsilon: fc.constantFrom(0, 1e-4, 0.01, 0.3, 5, 100),
});
const anyPasses = fc.subarray([...PASSES]);

describe('simplifyRing', () => {
  it('leaves simple rings of three vertices or more, turning as before', () => {
    fc.assert(
      fc.property(anyRing, tolerances, anyPasses, (given, limits, passes) => {
        const found = simplifyRing(given, { ...limits, passes });
        expectValidRing(found);
        expect(found.length).toBeLessThanOrEqual(given.length);
        expectValidPolygon({ outer: found, holes: [] });
        const turned = simplifyRing(reverseRing(given), { ...limits, passes });
        expectValidPolygon({ outer: reverseRing(turned), holes: [] });
      }),
      { numRuns: 400 },
    );
  });

  it('keeps vertices of the ring given, in its order', () => {
    fc.assert(
      fc.property(anyRing, tolerances, anyPasses, (given, limits, passes) => {
        const places = verticesOf(simplifyRing(given, { ...limits, passes })).map((v) =>
          verticesOf(given).indexOf(v),
        );
        expect(places).not.toContain(-1);
        const wraps = places.filter((place, k) => place < places[(k + places.length - 1) % places.length]);
        expect(wraps.length).toBeLessThanOrEqual(1);
      }),
    );
  });

  it('gives the same vertices whichever the ring starts with', () => {
    fc.assert(
      fc.property(anyRing, tolerances, anyPasses, fc.nat(), (given, limits, passes, shift) => {
        const at = (2 * shift) % given.length;
        const shifted = Float64Array.from([...given.subarray(at), ...given.subarray(0, at)]);
        const vertices = (r: Ring) => verticesOf(simplifyRing(r, { ...limits, passes })).sort();
        expect(vertices(shifted)).toEqual(vertices(given));
      }),
    );
  });

  it('changes nothing at tolerance 0 but vertices on straight edges', () => {
    fc.assert(
      fc.property(anyRing, (given) => {
        const found = simplifyRing(given, { epsilon: 0, areaEpsilon: 0, passes: PASSES });
        expect(found.length).toBeGreaterThan(0.7 * given.length);
      }),
    );
  });
});

describe('simplifyRings', () => {
  it('keeps rings apart that were apart', () => {
    fc.assert(
      fc.property(ring, tolerances, fc.constantFrom(...PASSES), (outer, limits, pass) => {
        if (ringProblems(outer).length > 0) return;
        const inner = reverseRing(outer.map((value) => 0.97 * value));
        const [found, hole] = simplifyRings([outer, inner], pass, limits);
        expectValidPolygon({ outer: found, holes: [hole] });
      }),
    );
  });
});

function verticesOf(r: Ring): string[] {
  return Array.from({ length: r.length / 2 }, (_, k) => `${r[2 * k]},${r[2 * k + 1]}`);
}
