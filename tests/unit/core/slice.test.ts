import { expect, test } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import { createRandom } from '../../../src/core/random.ts';
import { makeSlice } from '../../../src/core/slice.ts';
import { everyIndex, makeCloud, roomPoints, shuffled } from './made-scan.ts';

const BAND = [0.5, 2] as const;
const ROOM = roomPoints();

function run(points: ArrayLike<number>, given: Parameters<typeof resolveOptions>[0] = {}, isFlat = false) {
  const cloud = makeCloud(points, { isFlat });
  return makeSlice(cloud, everyIndex(cloud), BAND, resolveOptions(given));
}

test('keeps real points, one a cell, no more than asked for', () => {
  const { xy, band } = run(ROOM, { samplesPer50M2: 2000 });
  const wanted = (7 * 5 * 2000) / 50;
  expect(band).toEqual(BAND);
  expect(xy.length / 2).toBeGreaterThan(0.6 * wanted);
  expect(xy.length / 2).toBeLessThan(1.15 * wanted);
  const real = new Set<string>();
  const positions = Float32Array.from(ROOM);
  for (let i = 0; i < positions.length; i += 3) real.add(`${positions[i]} ${positions[i + 1]}`);
  for (let i = 0; i < xy.length; i += 2) expect(real.has(`${xy[i]} ${xy[i + 1]}`)).toBe(true);
});

test('does not depend on the order of the points', () => {
  expect(run(shuffled(ROOM, 3, createRandom(2)))).toEqual(run(ROOM));
});

test('another seed shifts the lattice', () => {
  expect(run(ROOM, { seed: 2 }).xy).not.toEqual(run(ROOM, { seed: 1 }).xy);
});

test('spacing is the mean distance to the nearest neighbour', () => {
  const grid: number[] = [];
  for (let x = 0; x < 20; x++) for (let y = 0; y < 20; y++) grid.push(x / 2, y / 2, 0);
  expect(run(grid, {}, true).spacing).toBeCloseTo(0.5, 6);
});

test('a ready slice below the density stays as it is, above it is thinned', () => {
  const points = [0, 0, 0, 3, 0, 0, 3, 4, 0, 0, 4, 0, 0, 0, 0];
  expect([...run(points, {}, true).xy]).toEqual([0, 0, 3, 0, 3, 4, 0, 4, 0, 0]);
  const dense = Float64Array.from({ length: 30_000 }, (_, i) =>
    i % 3 === 2 ? 0 : ((i * 7919) % 9973) / 9973,
  );
  expect(run(dense, {}, true).xy.length / 2).toBeLessThan(1200);
});
