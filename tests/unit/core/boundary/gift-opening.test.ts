import { describe, expect, it } from 'vitest';
import { openGift } from '../../../../src/core/boundary/gift-opening.ts';
import { coordinatesOf } from '../../../../src/core/boundary/hull-ring.ts';
import { convexHull } from '../../../../src/core/geometry/convex-hull.ts';
import { distinctPoints } from '../../../../src/core/geometry/point-order.ts';
import { orientation } from '../../../../src/core/geometry/predicates.ts';
import { segmentsTouch } from '../../../../src/core/geometry/segments.ts';
import { meanSpacing } from '../../../../src/core/geometry/spacing.ts';
import { expectValidRing } from '../../../invariants.ts';
import { closed, randomNumbers, scanWalls } from './wall-slices.ts';

type Point = readonly [number, number];

/** Gift opening as the report words it, scanning all points and all edges. */
function plainGiftOpening(xy: Float64Array, openingLength: number): Point[] {
  const all = pointsOf(distinctPoints(xy));
  const ring = pointsOf(convexHull(xy));
  const isFinal = new Set<string>();
  const keyOf = (k: number) => `${ring[k]}|${ring[(k + 1) % ring.length]}`;
  for (;;) {
    let longest = -1;
    let length = openingLength;
    ring.forEach((a, k) => {
      const far = distance(a, ring[(k + 1) % ring.length]);
      if (far > length && !isFinal.has(keyOf(k))) [longest, length] = [k, far];
    });
    if (longest < 0) return ring;
    const a = ring[longest];
    const b = ring[(longest + 1) % ring.length];
    const p = bestPoint(all, ring, a, b);
    if (p === null || isBlocked(ring, longest, p)) isFinal.add(keyOf(longest));
    else ring.splice(longest + 1, 0, p);
  }
}

function bestPoint(all: readonly Point[], ring: readonly Point[], a: Point, b: Point): Point | null {
  const onRing = new Set(ring.map(String));
  let best: Point | null = null;
  let least = Math.PI / 2;
  for (const p of all) {
    if (onRing.has(String(p)) || orientation(...a, ...b, ...p) <= 0) continue;
    const larger = Math.max(angle(a, b, p), angle(b, a, p));
    if (larger < least) [best, least] = [p, larger];
  }
  return best;
}

function isBlocked(ring: readonly Point[], k: number, p: Point): boolean {
  const a = ring[k];
  const b = ring[(k + 1) % ring.length];
  return ring.some((u, m) => {
    const v = ring[(m + 1) % ring.length];
    if (m === k) return false;
    const meets = (end: Point) =>
      u === end || v === end
        ? orientation(...end, ...p, ...(u === end ? v : u)) === 0 && angle(end, p, u === end ? v : u) < 1
        : segmentsTouch(...end, ...p, ...u, ...v);
    return meets(a) || meets(b);
  });
}

const pointsOf = (xy: Float64Array): Point[] =>
  Array.from({ length: xy.length / 2 }, (_, k) => [xy[2 * k], xy[2 * k + 1]] as const);
const distance = (a: Point, b: Point) => Math.hypot(b[0] - a[0], b[1] - a[1]);
function angle(at: Point, b: Point, p: Point): number {
  const cross = (b[0] - at[0]) * (p[1] - at[1]) - (b[1] - at[1]) * (p[0] - at[0]);
  const dot = (b[0] - at[0]) * (p[0] - at[0]) + (b[1] - at[1]) * (p[1] - at[1]);
  return Math.atan2(Math.abs(cross), dot);
}

/** As a string from the least vertex on, so that rings compare. */
function canonical(ring: readonly Point[]): string {
  const least = ring.reduce((best, p, k) => (p[0] < ring[best][0] ? k : best), 0);
  return [...ring.slice(least), ...ring.slice(0, least)].join(' ');
}

function plainRules(xy: Float64Array, openingLength: number) {
  return { openingLength, supportLength: 0.2, bridgeLimit: 0, spacing: meanSpacing(xy) };
}

describe('openGift without bridging', () => {
  const ell = closed([
    [0, 0],
    [5, 0],
    [5, 2],
    [2, 2],
    [2, 4],
    [0, 4],
  ]);
  it.each([1, 2, 3, 4, 5, 6])('is what scanning all points and edges gives on walls, seed %i', (seed) => {
    const xy = scanWalls({ walls: [ell], perMetre: 12, noise: 0.02, seed });
    for (const openingLength of [0.15, 0.4, 1]) {
      const ours = coordinatesOf(openGift(distinctPoints(xy), plainRules(xy, openingLength)).hull);
      expect(canonical(pointsOf(ours))).toBe(canonical(plainGiftOpening(xy, openingLength)));
      expectValidRing(ours);
    }
  });

  it.each([1, 2, 3, 4, 5, 6])('is what scanning all points and edges gives on a cloud, seed %i', (seed) => {
    const random = randomNumbers(seed);
    const xy = Float64Array.from({ length: 300 }, () => random() * 10);
    for (const openingLength of [0.3, 1, 3]) {
      const ours = coordinatesOf(openGift(distinctPoints(xy), plainRules(xy, openingLength)).hull);
      expect(canonical(pointsOf(ours))).toBe(canonical(plainGiftOpening(xy, openingLength)));
      expectValidRing(ours);
    }
  });

  it('leaves no edge longer than the opening length that could be opened', () => {
    const xy = scanWalls({ walls: [ell], perMetre: 100, noise: 0.005, seed: 3 });
    const ring = pointsOf(coordinatesOf(openGift(distinctPoints(xy), plainRules(xy, 0.3)).hull));
    for (let k = 0; k < ring.length; k++) {
      expect(distance(ring[k], ring[(k + 1) % ring.length])).toBeLessThan(0.3);
    }
  });
});
