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

test('keeps one point a cell, the mean of those in it, no more than asked for', () => {
  const { xy, band } = run(ROOM, { samplesPer50M2: 2000 });
  const wanted = (7 * 5 * 2000) / 50;
  expect(band).toEqual(BAND);
  expect(xy.length / 2).toBeGreaterThan(0.6 * wanted);
  expect(xy.length / 2).toBeLessThan(1.15 * wanted);
});

test('a cell with one point keeps it, a cell with several their mean, to an eight-thousandth of its edge', () => {
  const { xy } = run([0, 0, 1, 5, 3, 1, 5.001, 3, 1, 5.002, 3.006, 2], { samplesPer50M2: 100 });
  const expected = [0, 0, 5.001, 3.002];
  expect(xy.length).toBe(4);
  for (let i = 0; i < 4; i++) expect(Math.abs(xy[i] - expected[i])).toBeLessThan(Math.SQRT1_2 / 8000);
});

test('the few points beside a dense wall are its noise, as few points elsewhere are not', () => {
  const wall = Array.from({ length: 3000 }, (_, k) => [(k % 100) / 25, 0, 1]).flat();
  const beside = [1.02, 0.05, 1];
  const apart = [1.02, 0.09, 1];
  const { xy } = run([...wall, ...beside, ...apart]);
  const heights = new Set([...xy].filter((_, i) => i % 2 === 1).map((y) => Math.round(100 * y) / 100));
  expect(heights).toEqual(new Set([0, 0.09]));
});

test('far points are told apart in a table as near ones in a box', () => {
  const wall = Array.from({ length: 300 }, (_, k) => [k / 100, (k % 7) / 1000, 1]).flat();
  const near = run([...wall, 0, 9, 1]).xy;
  // So wide that the box has more cells than any array.
  const far = run([...wall, 0, 900, 1]).xy;
  expect(far.length).toBe(near.length);
  for (let i = 0; i < near.length - 2; i++) if (near[i] < 8.9) expect(far[i]).toBeCloseTo(near[i], 5);
  expect(run([0, 0, 1, 1e6, 0, 1, 0, 1e6, 1]).xy.length).toBe(6);
});

test('does not depend on the order of the points', () => {
  expect(run(shuffled(ROOM, 3, createRandom(2)))).toEqual(run(ROOM));
});

test.each([20, 60])('nor on whether a point %d m out is seen at once', (out) => {
  const near = [...ROOM.slice(0, 30_000)];
  const expected = run([out, out, 1, ...near]);
  // Every second point is looked at before a box is laid.
  expect(run([...near.slice(0, 3), out, out, 1, ...near.slice(3)])).toEqual(expected);
  for (const seed of [1, 2, 3]) {
    expect(run(shuffled([...near, out, out, 1], 3, createRandom(seed)))).toEqual(expected);
  }
});

test('cells hang on the plan, not on the points: whole cells on, the same points stay', () => {
  // Cells of 1/16 m and coordinates in 1/1024 m: nothing is rounded.
  const points = ROOM.map((value) => Math.round(1024 * value) / 1024);
  const moved = run(
    points.map((value, i) => value + [6, -3, 0][i % 3]),
    { samplesPer50M2: 12_800 },
  ).xy;
  const { xy } = run(points, { samplesPer50M2: 12_800 });
  for (const axis of [0, 1]) {
    const along = (values: Float64Array) => values.filter((_, i) => i % 2 === axis).sort();
    const [before, after] = [along(xy), along(moved)];
    expect(after.length).toBe(before.length);
    for (let k = 0; k < before.length; k++) expect(after[k] - before[k]).toBeCloseTo([6, -3][axis], 9);
  }
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
