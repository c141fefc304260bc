import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { conflictingEdges, isSimpleRing } from '../../../../src/core/geometry/simplicity.ts';
import { ringProblems, twiceArea } from '../../../invariants.ts';

const ring = (...values: number[]) => Float64Array.from(values);
const square = ring(0, 0, 4, 0, 4, 4, 0, 4);

describe('isSimpleRing', () => {
  it('takes simple rings', () => {
    expect(isSimpleRing(square)).toBe(true);
    expect(isSimpleRing(ring(0, 0, 1, 0, 0, 1))).toBe(true);
  });

  it.each([
    ['two vertices', ring(0, 0, 1, 0)],
    ['a bow tie', ring(0, 0, 2, 2, 2, 0, 0, 2)],
    ['a repeated vertex', ring(0, 0, 2, 0, 2, 0, 0, 2)],
    ['a vertex visited twice', ring(0, 0, 2, 0, 1, 1, 2, 2, 0, 2, 1, 1)],
    ['a fold', ring(0, 0, 4, 0, 2, 0, 2, 2)],
    ['all on one line', ring(0, 0, 1, 0, 2, 0)],
    ['a vertex on an edge', ring(0, 0, 4, 0, 4, 4, 2, 0, 0, 4)],
  ])('refuses %s', (_, bad) => {
    expect(isSimpleRing(bad)).toBe(false);
  });

  it('agrees with the judge of the tests on rings of lattice points', () => {
    const vertex = fc.tuple(fc.integer({ min: 0, max: 5 }), fc.integer({ min: 0, max: 5 }));
    fc.assert(
      fc.property(fc.array(vertex, { minLength: 3, maxLength: 8 }), (vertices) => {
        const candidate = Float64Array.from(vertices.flat());
        expect(isSimpleRing(candidate)).toBe(ringProblems(candidate).length === 0);
      }),
      { numRuns: 5_000 },
    );
  });
});

describe('conflictingEdges', () => {
  it('lets rings touch in a vertex, not pass through it', () => {
    const touching = ring(4, 4, 6, 4, 6, 6);
    expect(conflictingEdges([square, touching])).toEqual([]);
    const passing = ring(4, 4, 6, 6, 1, 3);
    expect(conflictingEdges([square, passing]).length).toBeGreaterThan(0);
    const through = ring(4, 4, 5, 1, 3, 1);
    expect(conflictingEdges([square, through]).map(({ ring: r }) => r)).toContain(1);
  });

  it('names the edges that cross', () => {
    const crossing = ring(1, -1, 2, -1, 2, 1, 1, 1);
    expect(conflictingEdges([square, crossing])).toEqual([
      { ring: 0, edge: 0 },
      { ring: 1, edge: 1 },
      { ring: 1, edge: 3 },
    ]);
  });

  it('checks a ring of 20,000 vertices in near-linear time', () => {
    const n = 20_000;
    const star = new Float64Array(2 * n);
    for (let k = 0; k < n; k++) {
      const radius = k % 2 === 0 ? 10 : 9;
      star[2 * k] = radius * Math.cos((2 * Math.PI * k) / n);
      star[2 * k + 1] = radius * Math.sin((2 * Math.PI * k) / n);
    }
    expect(twiceArea(star)).toBeGreaterThan(0);
    const start = performance.now();
    expect(isSimpleRing(star)).toBe(true);
    // Twenty times what it takes; the pairs are 200 million.
    expect(performance.now() - start).toBeLessThan(2_000);
  });
});
