import { describe, expect, test } from 'vitest';
import { chooseLevel, storeyRange } from '../../../src/core/level.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import type { PointCloud } from '../../../src/core/types.ts';
import { codesOf, everyIndex, listen, makeCloud, roomPoints } from './made-scan.ts';

function run(cloud: PointCloud, given: Parameters<typeof resolveOptions>[0] = {}) {
  const { context, warnings } = listen();
  const level = chooseLevel(cloud, everyIndex(cloud), resolveOptions(given), context);
  return { ...level, codes: codesOf(warnings) };
}

/** Heights 1, 2, 2, 3, 6 above a floor at 10: least 1, mean 2.8, greatest 6, cuts at 1.9 and 4.4. */
const HEIGHTS = [11, 12, 12, 13, 16];
const CONSTRUCTED = makeCloud(
  HEIGHTS.flatMap((z, i) => [
    [i, 0, z],
    [i, 2, z],
  ]).flat(),
  { floor: 10 },
);

describe('chooseLevel', () => {
  test('cuts lie halfway between the least, mean and greatest height', () => {
    const { levels } = run(CONSTRUCTED);
    expect(levels.map(({ points }) => points)).toEqual([2, 6, 2]);
    const edges = [1, 1.9, 4.4, 6];
    levels.forEach(({ low, high }, k) => {
      expect(low).toBeCloseTo(edges[k], 6);
      expect(high).toBeCloseTo(edges[k + 1], 6);
    });
  });

  test('density is points per m² of the bounding box', () => {
    const { levels } = run(CONSTRUCTED);
    expect(levels[1].densityPerM2).toBeCloseTo(6 / (2 * 2), 9);
    // All points of the level at one x: no area.
    expect(levels[0].densityPerM2).toBe(0);
  });

  test('the rules differ: density takes the crowded corner, count the larger number', () => {
    const points: number[] = [];
    for (let x = 0; x < 10; x++) for (let y = 0; y < 10; y++) points.push(x, y, 1);
    for (let x = 0; x < 5; x++) for (let y = 0; y < 5; y++) points.push(x / 10, y / 10, 3);
    points.push(0, 0, 0);
    const cloud = makeCloud(points);
    expect(run(cloud, { levelRule: 'density' }).chosen).toBe(2);
    expect(run(cloud, { levelRule: 'count' }).chosen).toBe(1);
  });

  test('a level can be named', () => {
    const { chosen, band, levels, indices } = run(roomCloud(), { level: '2' });
    expect(chosen).toBe(2);
    expect(levels.map((level) => level.chosen)).toEqual([false, false, true]);
    expect(band).toEqual([levels[2].low, levels[2].high]);
    expect(indices.length).toBe(levels[2].points);
  });

  test("a height band of one's own counts from the floor", () => {
    const cloud = roomCloud(4);
    const { chosen, band, indices, levels } = run(cloud, { level: '1.5:2' });
    expect(chosen).toBeNull();
    expect(band).toEqual([1.5, 2]);
    expect(levels.some((level) => level.chosen)).toBe(false);
    expect(indices.length).toBeGreaterThan(100);
    for (const i of indices) {
      expect(cloud.positions[3 * i + 2]).toBeGreaterThanOrEqual(5.5);
      expect(cloud.positions[3 * i + 2]).toBeLessThan(6);
    }
  });

  test('floor and ceiling are left out, or kept', () => {
    const cloud = roomCloud();
    const total = cloud.positions.length / 3;
    const sum = (result: ReturnType<typeof run>) => result.levels.reduce((n, { points }) => n + points, 0);
    const isPlane = (i: number) => cloud.positions[3 * i + 2] < 0.02 || cloud.positions[3 * i + 2] > 2.68;
    const planes = everyIndex(cloud).filter(isPlane).length;
    const left = sum(run(cloud));
    expect(left).toBeLessThanOrEqual(total - planes);
    expect(left).toBeGreaterThan(0.9 * (total - planes));
    expect(sum(run(cloud, { keepFloorAndCeiling: true }))).toBe(total);
  });

  test('a cloud of floor and ceiling alone is kept, with a warning', () => {
    const points: number[] = [];
    for (let x = 0; x < 5; x += 0.2) for (let y = 0; y < 5; y += 0.2) points.push(x, y, 0, x, y, 2.5);
    const { codes, indices } = run(makeCloud(points, { floor: 0, ceiling: 2.5 }));
    expect(codes).toEqual(['level/only-planes']);
    expect(indices.length).toBeGreaterThan(0);
  });

  test('a flat cloud lies in the middle level whole', () => {
    const cloud = makeCloud([0, 0, 0, 4, 0, 0, 4, 3, 0], { isFlat: true });
    const { levels, chosen, band, indices } = run(cloud, { level: '2' });
    expect(levels.map(({ points }) => points)).toEqual([0, 3, 0]);
    expect(chosen).toBe(1);
    expect(band).toEqual([0, 0]);
    expect(indices.length).toBe(3);
  });

  test('an empty band is refused', () => {
    expect(() => run(roomCloud(), { level: '50:60' })).toThrow(
      expect.objectContaining({ code: 'input/too-few-points' }),
    );
  });
});

describe('storeyRange', () => {
  test('falls back to the lowest and highest kept point', () => {
    const cloud = makeCloud([0, 0, -9, 0, 0, 1, 0, 0, 3, 0, 0, 9]);
    expect(storeyRange(cloud, Uint32Array.of(1, 2))).toEqual({ floor: 1, ceiling: 3 });
    expect(storeyRange({ ...cloud, floor: 0.5 }, Uint32Array.of(1, 2))).toEqual({ floor: 0.5, ceiling: 3 });
  });
});

function roomCloud(floor = 0): PointCloud {
  return makeCloud(roomPoints({ floor }), { floor, ceiling: floor + 2.7 });
}
