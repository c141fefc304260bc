import { expect, it } from 'vitest';
import { findOpenings } from '../../../../src/core/building/openings/find-openings.ts';

const LENGTH = 6;
const CEILING = 2.6;
const WINDOW = { from: 2, to: 3.3, sill: 0.9, head: 2.1, depth: 0.3 };

/** A wall with a window, seen but for what lies behind a wardrobe up to a height; and stray points just behind its face. */
function look(
  wardrobe: { from: number; to: number; height: number } | null,
  strays: readonly number[][] = [],
) {
  const points: number[][] = [...strays];
  const isHidden = (s: number, z: number) =>
    wardrobe !== null && s > wardrobe.from && s < wardrobe.to && z < wardrobe.height;
  const add = (s: number, d: number, z: number) => {
    if (!isHidden(s, z)) points.push([s, d, z]);
  };
  const { from, to, sill, head, depth } = WINDOW;
  for (let s = 0.01; s < LENGTH; s += 0.03)
    for (let z = 0.05; z < CEILING; z += 0.03) if (s < from || s > to || z < sill || z > head) add(s, 0, z);
  for (let d = 0.04; d < depth; d += 0.03) {
    for (let s = from; s < to; s += 0.03) for (const z of [sill, head]) add(s, d, z);
    for (let z = sill; z < head; z += 0.03) for (const s of [from, to]) add(s, d, z);
  }
  const column = (k: number) => Float64Array.from(points, (point) => point[k]);
  return {
    strip: { count: points.length, along: column(0), deep: column(1), high: column(2) },
    ...{ length: LENGTH, thickness: Infinity, noise: 0.003, ceiling: CEILING, isThrough: () => false },
  };
}

it('a window is as wide as between its jambs', () => {
  const [window, ...others] = findOpenings(look(null));
  expect(others).toEqual([]);
  expect(window.type).toBe('window');
  expect(window.from).toBeCloseTo(2, 1);
  expect(window.to).toBeCloseTo(3.3, 1);
});

it('a window of which a wardrobe hides an end is as wide as its sill and head were seen', () => {
  for (const to of [4.5, LENGTH]) {
    const [window, ...others] = findOpenings(look({ from: 3.1, to, height: 2.3 }));
    expect(others).toEqual([]);
    expect(window.from).toBeCloseTo(2, 1);
    expect(window.to).toBeGreaterThan(3);
    expect(window.to).toBeLessThan(3.2);
    expect([window.sill, window.head]).toEqual([expect.closeTo(0.9, 2), expect.closeTo(2.1, 2)]);
  }
});

it('stray points just behind the face, below a sill, make no jamb of it', () => {
  const strays = [0.35, 0.4, 0.45, 0.5].map((z) => [2.6, 0.035, z]);
  expect(findOpenings(look(null, strays))).toHaveLength(1);
});

it('the outer face below a sill, seen from another wing, makes no jambs', () => {
  const outer = Array.from({ length: 200 }, (_, s) =>
    [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8].map((z) => [0.03 * s, 0.32, z]),
  );
  const [window, ...others] = findOpenings(look(null, outer.flat()));
  expect(others).toEqual([]);
  expect([window.from, window.to]).toEqual([expect.closeTo(2, 1), expect.closeTo(3.3, 1)]);
});
