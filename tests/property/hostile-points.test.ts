/** Ten thousand point sets made to break hulls: every ring valid, every failure named, whatever order or direction. */
import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../src/core/options.ts';
import { makeSlice } from '../../src/core/slice.ts';
import { expectValidPolygons } from '../invariants.ts';
import { randomNumbers } from '../unit/core/boundary/wall-slices.ts';
import { everyIndex, makeCloud } from '../unit/core/made-scan.ts';
import { hostileOutline, hostileProblems } from './hostile-outline.ts';
import { type HostilePoints, hostilePoints } from './hostile-points.ts';

const numbers = (count: number) => Array.from({ length: count }, (_, number) => number);

describe('hostile points', () => {
  it.each([
    ['gift-opening', 10_000],
    ['convex', 1_000],
    ['alpha-shape', 1_000],
    ['concaveman', 1_000],
  ] as const)('give valid rings or a named error: %s, %i sets', { timeout: 300_000 }, (boundary, sets) => {
    const problems = numbers(sets).flatMap((number) => hostileProblems(hostilePoints(number), boundary));
    expect(problems).toEqual([]);
  });

  it('mostly have an outline, so the tests above are about something', () => {
    const outlines = numbers(1_000).map((number) => hostileOutline(hostilePoints(number), 'gift-opening'));
    const opened = outlines.filter((polygons) => polygons !== null && polygons[0].outer.length > 20);
    expect(outlines.filter((polygons) => polygons !== null).length).toBeGreaterThan(850);
    expect(opened.length).toBeGreaterThan(400);
  });

  it('give the same ring in any order', () => {
    for (const number of numbers(1_000)) {
      const points = hostilePoints(number);
      const again = { ...points, xy: shuffled(points.xy, number) };
      expect(hostileOutline(again, 'gift-opening'), points.name).toEqual(
        hostileOutline(points, 'gift-opening'),
      );
    }
  });

  it('give valid rings after sampling too', () => {
    for (const number of numbers(1_000)) {
      const points = hostilePoints(number);
      const flat: number[] = [];
      for (let i = 0; i < points.xy.length; i += 2) flat.push(points.xy[i], points.xy[i + 1], 1);
      const cloud = makeCloud(flat);
      const slice = makeSlice(cloud, everyIndex(cloud), [0, 1], resolveOptions({}));
      expect(slice.xy.every(Number.isFinite), points.name).toBe(true);
      const polygons = hostileOutline({ ...points, xy: slice.xy }, 'gift-opening');
      if (polygons !== null) expectValidPolygons(polygons);
    }
  });
});

describe('points without ties', () => {
  // Of the kinds those whose lengths and angles all differ.
  const isFree = ({ name }: HostilePoints) =>
    /noisy room|uniform/.test(name) && / of (1|30) m at 0/.test(name);
  const free = numbers(4_000).map(hostilePoints).filter(isFree);

  it('give the ring of the same points when they are turned', () => {
    expect(free.length).toBeGreaterThan(50);
    for (const points of free) {
      const ring = ringOf(points);
      for (const angle of [0.3, 1.9, Math.PI / 2]) {
        const turned = ringOf({ ...points, xy: turn(points.xy, angle) });
        if (ring === null || turned === null) expect(turned).toBe(ring);
        else expectSameCycle(turn(ring, angle), turned, points.name);
      }
    }
  });

  const ringOf = (points: HostilePoints) => hostileOutline(points, 'gift-opening')?.[0].outer ?? null;
});

function shuffled(xy: Float64Array, seed: number): Float64Array {
  const random = randomNumbers(seed);
  const order = numbers(xy.length / 2).map((k) => ({ k, key: random() }));
  order.sort((a, b) => a.key - b.key);
  return Float64Array.from(order.flatMap(({ k }) => [xy[2 * k], xy[2 * k + 1]]));
}

function turn(xy: Float64Array, angle: number): Float64Array {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return xy.map((value, i) => (i % 2 === 0 ? value * cos - xy[i + 1] * sin : xy[i - 1] * sin + value * cos));
}

/** The same vertices in the same order, up to rounding, from whichever vertex on. */
function expectSameCycle(a: Float64Array, b: Float64Array, name: string): void {
  expect(b.length, name).toBe(a.length);
  const distance = (i: number, k: number) => Math.hypot(a[i] - b[k], a[i + 1] - b[k + 1]);
  let start = 0;
  for (let k = 2; k < b.length; k += 2) if (distance(0, k) < distance(0, start)) start = k;
  for (let i = 0; i < a.length; i += 2) {
    expect(distance(i, (start + i) % b.length), name).toBeLessThan(1e-9);
  }
}
