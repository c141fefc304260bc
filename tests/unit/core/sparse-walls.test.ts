import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../../src/core/boundary.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { createRandom, type Random } from '../../../src/core/random.ts';
import { regulariseBoundary } from '../../../src/core/regularise.ts';
import { makeSlice } from '../../../src/core/slice.ts';
import { intersectionOverUnion } from './boundary/measures.ts';
import { everyIndex, listen, makeCloud } from './made-scan.ts';

/** No noise lies farther from its wall than this, m. */
const NOISE_REACH = 0.06;

const edgeOf = (samplesPer50M2: number) => Math.sqrt(50 / samplesPer50M2);

function sliceOf(points: readonly number[], samplesPer50M2: number, seed = 1): Float64Array {
  const cloud = makeCloud(points);
  return makeSlice(cloud, everyIndex(cloud), [0, 1], resolveOptions({ samplesPer50M2, seed })).xy;
}

/** Points along a wall, spread evenly, with uniform noise across. */
function wall(
  random: Random,
  [ax, ay, bx, by]: readonly number[],
  { points, noise = 0.005 }: { points: number; noise?: number },
): number[] {
  const length = Math.hypot(bx - ax, by - ay);
  return Array.from({ length: points }, (_, k) => {
    const at = (k + random()) / points;
    const off = (2 * random() - 1) * noise;
    return [
      ax + at * (bx - ax) - (off * (by - ay)) / length,
      ay + at * (by - ay) + (off * (bx - ax)) / length,
      1,
    ];
  }).flat();
}

/** Greatest distance from a point to its nearest of the slice, m. */
function farthestFrom(slice: Float64Array, points: readonly number[]): number {
  let most = 0;
  for (let i = 0; i < points.length; i += 3) {
    let least = Number.POSITIVE_INFINITY;
    for (let k = 0; k < slice.length; k += 2) {
      least = Math.min(least, Math.hypot(slice[k] - points[i], slice[k + 1] - points[i + 1]));
    }
    most = Math.max(most, least);
  }
  return most;
}

describe('a sparse wall beside a dense one', () => {
  it.each([
    [50_000, 0.08],
    [50_000, 0.12],
    [50_000, 0.3],
    [5_000, 0.15],
    [2_000, 0.2],
    [500, 0.4],
  ])('with %i samples stays %f m before it', (samples, apart) => {
    for (let seed = 1; seed <= 6; seed++) {
      const random = createRandom(seed);
      const dense = wall(random, [0, apart, 4, apart], { points: 20_000 });
      const sparse = wall(random, [0, 0, 4, 0], { points: 100 });
      const slice = sliceOf([...dense, ...sparse], samples, seed);
      expect(farthestFrom(slice, sparse)).toBeLessThan(Math.SQRT2 * edgeOf(samples));
      const own = slice.filter((y, i) => i % 2 === 1 && Math.abs(y) < 0.02).length;
      expect(own).toBeGreaterThan(0.9 * Math.min(60, 4 / edgeOf(samples)));
    }
  });

  it('loses no more where it meets it than noise may reach', () => {
    const random = createRandom(3);
    const dense = wall(random, [0, 0, 0, 3], { points: 60_000, noise: 0.02 });
    const sparse = wall(random, [0.03, 0, 5, 0], { points: 170 });
    for (const samples of [50_000, 5_000, 1_000]) {
      const slice = sliceOf([...dense, ...sparse], samples);
      expect(farthestFrom(slice, sparse)).toBeLessThan(NOISE_REACH + Math.SQRT2 * edgeOf(samples));
    }
  });

  it('stays between the frames of a glass front', () => {
    const random = createRandom(4);
    const glass = wall(random, [0, 0, 6, 0], { points: 200 });
    const frames = Array.from({ length: 7 }, (_, k) =>
      wall(random, [k - 0.025, 0, k + 0.025, 0], { points: 2_000 }),
    ).flat();
    const slice = sliceOf([...glass, ...frames], 50_000);
    const xs = [...slice.filter((_, i) => i % 2 === 0)].sort((a, b) => a - b);
    const steps = xs.slice(1).map((x, k) => x - xs[k]);
    expect(Math.max(...steps)).toBeLessThan(NOISE_REACH + 2 * edgeOf(50_000));
  });
});

it('noise of noise is none: what is left of a row of walls leads no farther than one of them', () => {
  for (let seed = 1; seed <= 12; seed++) {
    const random = createRandom(seed);
    const rows = [50, 1_000, 20_000].map((points, k) =>
      wall(random, [0, 0.055 * k, 3, 0.055 * k], { points, noise: 0 }),
    );
    const slice = sliceOf(rows.flat(), 50_000, seed);
    expect(farthestFrom(slice, rows[0])).toBeLessThan(0.08);
  }
});

it.each([50_000, 5_000, 2_000])('a scan from one corner keeps its far walls, with %i samples', (samples) => {
  const corners = [0, 0, 14, 0, 14, 5, 0, 5];
  const { points, truth } = staticScan(corners, [0.6, 0.5], 60_000);
  const options = resolveOptions({ samplesPer50M2: samples });
  const cloud = makeCloud(points);
  const slice = makeSlice(cloud, everyIndex(cloud), [0, 1], options);
  const { context } = listen();
  const boundary = findBoundary(slice, options, context);
  const { polygons } = regulariseBoundary(boundary, slice, options, context);
  expect(intersectionOverUnion(polygons[0].outer, truth)).toBeGreaterThan(0.995);
});

/** What a scanner that turns evenly sees of a convex room: near walls a hundred times as dense as far ones. */
function staticScan(corners: readonly number[], [x, y]: readonly [number, number], rays: number) {
  const random = createRandom(5);
  const n = corners.length / 2;
  const points: number[] = [];
  for (let ray = 0; ray < rays; ray++) {
    const angle = (2 * Math.PI * ray) / rays;
    const [dx, dy] = [Math.cos(angle), Math.sin(angle)];
    let reach = Number.POSITIVE_INFINITY;
    for (let k = 0; k < n; k++) {
      const [ax, ay] = [corners[2 * k] - x, corners[2 * k + 1] - y];
      const m = (k + 1) % n;
      const [ux, uy] = [corners[2 * m] - x - ax, corners[2 * m + 1] - y - ay];
      const across = dx * uy - dy * ux;
      const at = (ax * dy - ay * dx) / across;
      const distance = (ax * uy - ay * ux) / across;
      if (at >= 0 && at <= 1 && distance > 0) reach = Math.min(reach, distance);
    }
    const range = reach + 0.008 * (random() + random() - 1);
    points.push(x + range * dx, y + range * dy, 1);
  }
  return { points, truth: Float64Array.from(corners) };
}
