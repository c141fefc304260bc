import fc from 'fast-check';
import { describe, expect, it } from 'vitest';
import { convexHull } from '../../../../src/core/geometry/convex-hull.ts';
import { buildPointGrid, squaredDistanceToNearest } from '../../../../src/core/geometry/point-grid.ts';
import { distinctPoints, lexicographicOrder } from '../../../../src/core/geometry/point-order.ts';
import { orientation } from '../../../../src/core/geometry/predicates.ts';
import { pointInRing } from '../../../../src/core/geometry/rings.ts';
import { meanSpacing } from '../../../../src/core/geometry/spacing.ts';

/** Without the denormals whose products underflow. */
const near = fc.double({ min: -5, max: 5, noNaN: true }).map((v) => (Math.abs(v) < 1e-100 ? 0 : v));
const lattice = fc.integer({ min: 0, max: 6 });
const far = fc.constantFrom(0, 1e-12, 1, 1e9, -1e12);
const points = fc
  .array(fc.oneof(fc.tuple(near, near), fc.tuple(lattice, lattice), fc.tuple(far, near)), { maxLength: 120 })
  .map((pairs) => Float64Array.from(pairs.flat()));

function sorted(xy: Float64Array): [number, number][] {
  const pairs = Array.from({ length: xy.length / 2 }, (_, k): [number, number] => [xy[2 * k], xy[2 * k + 1]]);
  return pairs.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
}

describe('lexicographicOrder', () => {
  it('sorts as a comparison sort does', () => {
    fc.assert(
      fc.property(points, (xy) => {
        const order = [...lexicographicOrder(xy)];
        expect(order.map((i) => [xy[2 * i], xy[2 * i + 1]])).toEqual(sorted(xy));
      }),
    );
  });

  it('sorts when one far point squeezes all others into one step', () => {
    const xy = Float64Array.from({ length: 100_000 }, (_, k) => Math.sin(k * 12.9898) * 43_758.5453 - k);
    xy[0] = 1e15;
    const order = lexicographicOrder(xy);
    for (let k = 1; k < order.length; k++) expect(xy[2 * order[k - 1]] <= xy[2 * order[k]]).toBe(true);
  });
});

describe('distinctPoints', () => {
  it('drops repeats', () => {
    expect([...distinctPoints(Float64Array.of(2, 1, 0, 5, 2, 1, 0, 4))]).toEqual([0, 4, 0, 5, 2, 1]);
  });
});

describe('convexHull', () => {
  it('is what the brute oracle finds: edges with no point to their right', () => {
    fc.assert(
      fc.property(points, (xy) => {
        const hull = convexHull(xy);
        expect(new Set(pairsOf(hull).map(String))).toEqual(bruteHullVertices(xy));
      }),
    );
  });

  it('turns counter-clockwise, strictly, and holds all points', () => {
    fc.assert(
      fc.property(points, (xy) => {
        const hull = convexHull(xy);
        const n = hull.length;
        if (n < 6) return;
        for (let i = 0; i < n; i += 2) {
          const at = (k: number) => [hull[(i + k) % n], hull[(i + k + 1) % n]] as const;
          expect(orientation(...at(0), ...at(2), ...at(4))).toBeGreaterThan(0);
        }
        for (let i = 0; i < xy.length; i += 2) {
          expect(pointInRing(xy[i], xy[i + 1], hull)).toBeGreaterThanOrEqual(0);
        }
      }),
    );
  });

  it('is what a monotone chain finds, for sets large enough to be sorted out first', () => {
    const at = (k: number) => (2 * Math.PI * k) / 3_000;
    const shapes: ((k: number) => [number, number])[] = [
      (k) => [Math.cos(at(k)), Math.sin(at(k))],
      (k) => [k % 60, Math.floor(k / 60)],
      (k) => [k % 60, (k % 60) / 3 + (k % 7) * Number.EPSILON],
      (k) => [Math.sin(k * 12.9898) % 1, Math.sin(k * 78.233) % 1],
      (k) => [((k % 60) * 3 - Math.floor(k / 60)) / 7, ((k % 60) + 3 * Math.floor(k / 60)) / 7],
    ];
    for (const shape of shapes) {
      const xy = Float64Array.from(Array.from({ length: 3_000 }, (_, k) => shape(k)).flat());
      expect(pairsOf(convexHull(xy))).toEqual(monotoneChain(xy));
    }
  });

  it('has fewer than three vertices for points on one line', () => {
    expect([...convexHull(Float64Array.of(0, 0, 1, 1, 2, 2, 3, 3))]).toEqual([0, 0, 3, 3]);
    expect(convexHull(Float64Array.of(1, 1, 1, 1)).length).toBe(2);
    expect(convexHull(new Float64Array(0)).length).toBe(0);
  });
});

describe('point grid', () => {
  it('holds every point once, in the cell its coordinates say', () => {
    fc.assert(
      fc.property(points, (xy) => {
        if (xy.length === 0) return;
        const grid = buildPointGrid(xy);
        expect([...grid.source].sort((a, b) => a - b)).toEqual([...Array(xy.length / 2).keys()]);
        expect(grid.start[grid.start.length - 1]).toBe(xy.length / 2);
        for (let k = 0; k < grid.x.length; k++) expect(grid.x[k]).toBe(xy[2 * grid.source[k]]);
      }),
    );
  });

  it('finds the nearest neighbour a scan of all pairs finds', () => {
    fc.assert(
      fc.property(points, (given) => {
        const xy = distinctPoints(given);
        if (xy.length === 0) return;
        const grid = buildPointGrid(xy);
        for (let i = 0; i < grid.x.length; i++) {
          let best = Number.POSITIVE_INFINITY;
          for (let k = 0; k < grid.x.length; k++) {
            if (k !== i) best = Math.min(best, (grid.x[k] - grid.x[i]) ** 2 + (grid.y[k] - grid.y[i]) ** 2);
          }
          expect(squaredDistanceToNearest(grid, i)).toBe(best);
        }
      }),
    );
  });
});

describe('meanSpacing', () => {
  it('is the step of a lattice, repeats left out', () => {
    const xy: number[] = [];
    for (let i = 0; i < 40; i++) for (let j = 0; j < 30; j++) xy.push(i * 0.25, j * 0.25, i * 0.25, j * 0.25);
    expect(meanSpacing(Float64Array.from(xy))).toBeCloseTo(0.25, 12);
  });

  it('is 0 without two distinct points', () => {
    expect(meanSpacing(Float64Array.of(1, 2, 1, 2))).toBe(0);
    expect(meanSpacing(new Float64Array(0))).toBe(0);
  });

  it('changes by less than 2 % when it samples', () => {
    const many = Float64Array.from({ length: 120_000 }, (_, k) => (Math.sin(k + 1) * 1e4) % 10);
    const xy = distinctPoints(many);
    const grid = buildPointGrid(xy);
    let sum = 0;
    for (let i = 0; i < grid.x.length; i++) sum += Math.sqrt(squaredDistanceToNearest(grid, i));
    expect(meanSpacing(many) / (sum / grid.x.length)).toBeCloseTo(1, 1.7);
  });
});

/** Andrew's hull, counter-clockwise from the leftmost, lowest point. */
function monotoneChain(xy: Float64Array): [number, number][] {
  const all = pairsOf(distinctPoints(xy));
  const half = (points: readonly [number, number][]) => {
    const chain: [number, number][] = [];
    for (const p of points) {
      while (chain.length > 1 && orientation(...chain.at(-2)!, ...chain.at(-1)!, ...p) <= 0) chain.pop();
      chain.push(p);
    }
    return chain.slice(0, -1);
  };
  return [...half(all), ...half(all.toReversed())];
}

function pairsOf(ring: Float64Array): [number, number][] {
  return Array.from({ length: ring.length / 2 }, (_, k): [number, number] => [ring[2 * k], ring[2 * k + 1]]);
}

/** Points that are the end of a longest edge with every point on it or to its left; for one line its ends. */
function bruteHullVertices(xy: Float64Array): Set<string> {
  const all = pairsOf(distinctPoints(xy));
  if (all.length < 3) return new Set(all.map(String));
  const vertices = new Set<string>();
  for (const a of all) {
    for (const b of all) {
      if (a === b) continue;
      const isEdge = all.every((c) => {
        const side = orientation(...a, ...b, ...c);
        const isBetween = Math.min(a[0], b[0]) <= c[0] && c[0] <= Math.max(a[0], b[0]);
        const isLevel = Math.min(a[1], b[1]) <= c[1] && c[1] <= Math.max(a[1], b[1]);
        return side > 0 || (side === 0 && isBetween && isLevel);
      });
      if (isEdge) vertices.add(String(a)).add(String(b));
    }
  }
  return vertices;
}
