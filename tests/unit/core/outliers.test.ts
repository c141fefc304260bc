import { describe, expect, test } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import { removeOutliers } from '../../../src/core/outliers.ts';
import { createRandom } from '../../../src/core/random.ts';
import { concat, listen, makeCloud, roomPoints, strayPoints } from './made-scan.ts';

const ROOM = roomPoints();
const ROOM_POINTS = ROOM.length / 3;

function run(points: ArrayLike<number>, given: Parameters<typeof resolveOptions>[0] = {}, isFlat = false) {
  return removeOutliers(makeCloud(points, { isFlat }), resolveOptions(given), listen().context);
}

describe('removeOutliers', () => {
  test('keeps a clean room whole', () => {
    expect(run(ROOM).length).toBe(ROOM_POINTS);
  });

  test('drops strays that lie clear of the surfaces and keeps the room', () => {
    const strays = strayPoints(200, 2, createRandom(3));
    const kept = run(concat(ROOM, strays));
    const isKept = new Set(kept);
    expect(kept.filter((i) => i < ROOM_POINTS).length).toBe(ROOM_POINTS);
    for (let s = 0; s < 200; s++) {
      const [x, y, z] = strays.subarray(3 * s, 3 * s + 3);
      const isClear = x < -0.4 || x > 7.4 || y < -0.4 || y > 5.4 || z < -0.4 || z > 3.1;
      if (isClear) expect(isKept.has(ROOM_POINTS + s), `stray at ${x}, ${y}, ${z}`).toBe(false);
    }
  });

  test('drops a small dense clump far outside, keeps one inside', () => {
    const clump = roomPoints({ corners: [0, 0, 0.2, 0, 0.2, 0.2, 0, 0.2], height: 0.2, hasTable: false });
    const moved = (dx: number, dz: number) =>
      clump.map((v, i) => v + (i % 3 === 0 ? dx : i % 3 === 2 ? dz : 2.5));
    const kept = run(concat(ROOM, moved(20, 1), moved(2, 1.4)));
    const isKept = new Set(kept);
    const size = clump.length / 3;
    for (let i = 0; i < size; i++) {
      expect(isKept.has(ROOM_POINTS + i)).toBe(false);
      expect(isKept.has(ROOM_POINTS + size + i)).toBe(true);
    }
  });

  test('keeps a second room as large as the first, however far', () => {
    const far = ROOM.map((value, i) => (i % 3 === 0 ? value + 30 : value));
    expect(run(concat(ROOM, far)).length).toBe(2 * ROOM_POINTS);
  });

  test('zero deviations keep all', () => {
    expect(run(concat(ROOM, [100, 100, 100]), { outlierDeviations: 0 }).length).toBe(ROOM_POINTS + 1);
  });

  test('works in the plane of a flat cloud', () => {
    const flat = ROOM.map((value, i) => (i % 3 === 2 ? 0 : value));
    const kept = run(concat(flat, [9, 9, 0, -3, 2, 0]), {}, true);
    expect(kept.length).toBe(ROOM_POINTS);
  });

  test('repeats and few points are no trouble', () => {
    expect(run([1, 1, 1, 1, 1, 1, 1, 1, 1])).toEqual(Uint32Array.of(0, 1, 2));
    expect(run([0, 0, 0, 1, 0, 0, 0, 1, 0]).length).toBe(3);
    expect(run([0, 0, 0]).length).toBe(1);
  });

  test('indices rise and more deviations never drop more', () => {
    const cloud = concat(ROOM, strayPoints(300, 1, createRandom(5)));
    let before = 0;
    for (const outlierDeviations of [1, 3, 10]) {
      const kept = run(cloud, { outlierDeviations });
      expect(kept.every((index, k) => k === 0 || index > kept[k - 1])).toBe(true);
      expect(kept.length).toBeGreaterThanOrEqual(before);
      before = kept.length;
    }
  });

  test('what is lonely agrees with exact distances', () => {
    const points = concat(roomPoints({ spacing: 0.25 }), strayPoints(60, 1, createRandom(9)));
    const kept = new Set(run(points));
    const distances = meanDistances(points, 8);
    const lonelyKept = distances.filter((_, i) => kept.has(i));
    const dropped = distances.filter((_, i) => !kept.has(i));
    expect(dropped.length).toBeGreaterThan(10);
    expect(Math.max(...lonelyKept)).toBeLessThanOrEqual(Math.min(...dropped));
  });
});

/** Mean distance of every point to its k nearest others, by comparing all with all. */
function meanDistances(points: Float64Array, k: number): number[] {
  const p = Float32Array.from(points);
  const means: number[] = [];
  for (let i = 0; i < p.length; i += 3) {
    const all: number[] = [];
    for (let j = 0; j < p.length; j += 3) {
      if (j !== i) all.push(Math.hypot(p[i] - p[j], p[i + 1] - p[j + 1], p[i + 2] - p[j + 2]));
    }
    all.sort((a, b) => a - b);
    means.push(all.slice(0, k).reduce((sum, d) => sum + d, 0) / k);
  }
  return means;
}
