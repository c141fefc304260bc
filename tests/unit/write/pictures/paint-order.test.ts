import { expect, test } from 'vitest';
import { createRandom } from '../../../../src/core/random.ts';
import { paintOrder, type SeenSegment } from '../../../../src/write/pictures/paint-order.ts';

/** Segments that do not cross, from a seed: each new one is kept only where it crosses none before. */
function apart(seed: number, wanted: number): SeenSegment[] {
  const random = createRandom(seed);
  const segments: SeenSegment[] = [];
  for (let tries = 0; segments.length < wanted && tries < 20 * wanted; tries++) {
    const u0 = 10 * random();
    const segment = { u0, v0: 10 * random(), u1: u0 + 0.01 + 3 * random(), v1: 10 * random() };
    if (segments.every((other) => sides(segment, other).every((side) => side !== 0))) segments.push(segment);
  }
  return segments;
}

const depthAt = ({ u0, v0, u1, v1 }: SeenSegment, u: number): number =>
  v0 + ((v1 - v0) * (u - u0)) / (u1 - u0);

/** At both ends of what two segments span together: which is nearer; 0 where that changes, which is a crossing. */
function sides(a: SeenSegment, b: SeenSegment): number[] {
  const [from, to] = [Math.max(a.u0, b.u0), Math.min(a.u1, b.u1)];
  if (from >= to) return [];
  const [first, last] = [from, to].map((u) => Math.sign(depthAt(a, u) - depthAt(b, u)));
  return first === last ? [first] : [0];
}

test.each([1, 2, 3, 4, 5])(
  'of any two that overlap to the eye the nearer one is painted later (%i)',
  (seed) => {
    const segments = apart(seed, 300);
    expect(segments.length).toBeGreaterThan(60);
    const order = paintOrder(segments);
    expect([...order].sort((a, b) => a - b)).toEqual([...segments.keys()]);
    const rank = new Map(order.map((i, place) => [i, place]));
    let pairs = 0;
    for (const [i, a] of segments.entries()) {
      for (const [j, b] of segments.entries()) {
        const [side] = j > i ? sides(a, b) : [];
        if (side === undefined) continue;
        pairs++;
        expect(Math.sign(rank.get(i)! - rank.get(j)!)).toBe(side);
      }
    }
    expect(pairs).toBeGreaterThan(1000);
  },
);

test('segments that share ends, as walls do, are in order too', () => {
  // A zigzag behind a closed box, and a partition from the box's far side to its near side.
  const box: SeenSegment[] = [
    { u0: 0, v0: 1, u1: 1, v1: 0 },
    { u0: 1, v0: 0, u1: 2, v1: 1 },
    { u0: 0, v0: 1, u1: 1, v1: 2 },
    { u0: 1, v0: 2, u1: 2, v1: 1 },
    { u0: 0, v0: 1, u1: 2, v1: 1 },
  ];
  const order = paintOrder(box);
  const rank = (i: number): number => order.indexOf(i);
  for (const far of [0, 1]) {
    expect(rank(far)).toBeLessThan(rank(4));
    expect(rank(far)).toBeLessThan(rank(far + 2));
    expect(rank(4)).toBeLessThan(rank(far + 2));
  }
});
