import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../../../src/core/boundary.ts';
import { buildPointGrid } from '../../../../src/core/geometry/point-grid.ts';
import { firstFace } from '../../../../src/core/regularise/face-offset.ts';
import { restoreCorners } from '../../../../src/core/regularise/restore-corners.ts';
import { StripPoints } from '../../../../src/core/regularise/strip-points.ts';
import { regulariseBoundary } from '../../../../src/core/regularise.ts';
import type { Ring } from '../../../../src/core/types.ts';
import { expectValidPolygon } from '../../../invariants.ts';
import { areaError, intersectionOverUnion, ringOf } from '../boundary/measures.ts';
import {
  asSlice,
  closed,
  ELL,
  listeningContext,
  normalNumbers,
  optionsWith,
  type Path,
  randomNumbers,
  scanWalls,
} from '../boundary/wall-slices.ts';

const ACUTE: Path = [
  [0, 0],
  [7, 0],
  [6, 3.5],
];
const BENT: Path = [
  [0, 0],
  [4, 0],
  [8, 0.8],
  [8, 5],
  [0, 5],
];
const ROUND: Path = Array.from({ length: 180 }, (_, k) => [
  3 * Math.cos((Math.PI * k) / 90),
  3 * Math.sin((Math.PI * k) / 90),
]);
const SEEDS = [1, 2, 3, 4, 5, 6];

/** The outline before and after the corner pass, the noise still on it. */
function outline(xy: Float64Array) {
  const slice = asSlice(xy);
  const options = optionsWith({ noisePass: false });
  const boundary = findBoundary(slice, options, listeningContext());
  const { passes } = regulariseBoundary(boundary, slice, options, listeningContext());
  const [before, after] = passes.slice(-2).map(({ polygons }) => polygons[0]);
  expectValidPolygon(after);
  return { before: before.outer, after: after.outer };
}

function turned(path: Path, angle: number): Path {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  return path.map(([x, y]) => [x * cos - y * sin + 20, x * sin + y * cos - 7]);
}

/** Mean distance from a true corner to the nearest vertex, m. */
function cornerError(ring: Ring, truth: Path): number {
  const nearest = truth.map(([x, y]) => {
    const distances = Array.from({ length: ring.length / 2 }, (_, k) =>
      Math.hypot(ring[2 * k] - x, ring[2 * k + 1] - y),
    );
    return Math.min(...distances);
  });
  return mean(nearest);
}

function verticesOf(ring: Ring): [x: number, y: number][] {
  return Array.from({ length: ring.length / 2 }, (_, k) => [ring[2 * k], ring[2 * k + 1]]);
}

function mean(values: readonly number[]): number {
  return values.reduce((a, b) => a + b, 0) / values.length;
}

/** Means over the seeds, each with the walls turned another way. */
function measure(path: Path, noise: number) {
  const runs = SEEDS.map((seed) => {
    const truth = turned(path, 0.4 * seed);
    const { before, after } = outline(scanWalls({ walls: [closed(truth)], perMetre: 250, noise, seed }));
    const ring = ringOf(truth);
    return {
      corners: [cornerError(before, truth), cornerError(after, truth)],
      area: [areaError(before, ring), areaError(after, ring)],
      iou: [intersectionOverUnion(before, ring), intersectionOverUnion(after, ring)],
    };
  });
  const over = (key: 'corners' | 'area' | 'iou', k: number) => mean(runs.map((run) => run[key][k]));
  return {
    corners: [over('corners', 0), over('corners', 1)],
    area: [over('area', 0), over('area', 1)],
    iou: [over('iou', 0), over('iou', 1)],
  };
}

describe('restored corners', () => {
  it.each([
    ['an L', ELL, 0.005],
    ['an L', ELL, 0.01],
    ['an L', ELL, 0.02],
    ['a triangle', ACUTE, 0.01],
    ['a wall bent by 11°', BENT, 0.005],
  ])('of %s: noise bias gone, corners within the noise', (_, path, noise) => {
    const { corners, area, iou } = measure(path, noise);
    expect(corners[1]).toBeLessThan(noise / 2);
    expect(corners[1]).toBeLessThan(corners[0] / 3);
    expect(area[1]).toBeLessThan(0.001);
    expect(area[1]).toBeLessThan(area[0] / 5);
    expect(iou[1]).toBeGreaterThan(1 - noise / 5);
  });

  it.each([0.005, 0.01, 0.02])('leave a round wall rounder, noise %f m', (noise) => {
    const { area, iou } = measure(ROUND, noise);
    expect(area[1]).toBeLessThan(area[0]);
    expect(iou[1]).toBeGreaterThan(iou[0]);
  });

  it('are exact for points without noise', () => {
    const truth = turned(ELL, 0.3);
    const { after } = outline(scanWalls({ walls: [closed(truth)], perMetre: 300, noise: 0, seed: 1 }));
    expect(after.length / 2).toBe(truth.length);
    expect(cornerError(after, truth)).toBeLessThan(1e-6);
  });

  it.each([0.1, 0.15, 0.24])(
    'stand on the outer face where both faces of a wall %f m thick were seen',
    (t) => {
      const outer = closed([
        [0, 0],
        [5, 0],
        [5, 4],
        [0, 4],
      ]);
      const inner = closed([
        [t, t],
        [5 - t, t],
        [5 - t, 4 - t],
        [t, 4 - t],
      ]);
      // The inner face twice as dense.
      const walls = [outer, inner, inner];
      const { after } = outline(scanWalls({ walls, perMetre: 250, noise: 0.01, seed: 5 }));
      expect(after.length / 2).toBe(4);
      expect(cornerError(after, outer.slice(0, 4))).toBeLessThan(0.003);
    },
  );

  it('keep a bridged gap straight between its ends', () => {
    const wall: Path = [
      [0, 0],
      [5, 0],
      [5, 4],
      [0, 4],
    ];
    const gaps = [{ wall: 0, from: 12.5, to: 13.5 }];
    const { after } = outline(
      scanWalls({ walls: [closed(wall)], perMetre: 250, noise: 0.006, seed: 2, gaps }),
    );
    expect(after.length / 2).toBe(4);
    expect(cornerError(after, wall)).toBeLessThan(0.003);
  });

  it('move no vertex far where ε is large', () => {
    const slice = asSlice(scanWalls({ walls: [closed(ROUND)], perMetre: 250, noise: 0.01, seed: 4 }));
    const options = optionsWith({ epsilon: 0.5 });
    const boundary = findBoundary(slice, options, listeningContext());
    const { passes } = regulariseBoundary(boundary, slice, options, listeningContext());
    const [before, after] = passes.slice(-2).map(({ polygons }) => verticesOf(polygons[0].outer));
    const moves = after.map(([x, y]) => Math.min(...before.map(([u, v]) => Math.hypot(x - u, y - v))));
    // Four times the 2.5 cm within which points are one face; the lines fitted to such long chords pass twice as far off.
    expect(Math.max(...moves)).toBeLessThanOrEqual(0.1);
  });

  it('leave the outline of a filled area where it is', () => {
    const random = randomNumbers(6);
    const filled = Float64Array.from({ length: 20_000 }, (_, i) => (i % 2 === 0 ? 5 : 4) * random());
    const { before, after } = outline(filled);
    expect(areaError(after, before)).toBeLessThan(0.005);
  });

  it('leave edges without points where they are', () => {
    const ring = Float64Array.of(0, 0, 5, 0, 5, 4, 0, 4);
    const far = asSlice(
      scanWalls({
        walls: [
          closed([
            [2, 2],
            [3, 2],
            [3, 3],
          ]),
        ],
        perMetre: 100,
        noise: 0,
        seed: 1,
      }),
    );
    expect(restoreCorners([ring], [ring], far)).toEqual([ring]);
    expect(restoreCorners([ring], [ring], { ...far, xy: new Float64Array(0) })).toEqual([ring]);
  });
});

describe('the face of a wall', () => {
  const normal = normalNumbers(randomNumbers(3));
  const around = (offset: number, count: number, noise = 0.008) =>
    Array.from({ length: count }, () => offset + noise * normal());
  const faceOf = (offsets: number[]) =>
    firstFace(Float64Array.from(offsets), offsets.length, [-0.05, 0.35], 0.025);

  it('is the first dense one, not the densest', () => {
    const face = faceOf([...around(0.03, 300), ...around(0.18, 700)]);
    expect(face?.peak).toBeCloseTo(0.03, 2);
    expect(face?.end).toBeGreaterThan(0.06);
    expect(face?.end).toBeLessThan(0.16);
  });

  it('is none of the few points before it', () => {
    expect(faceOf([...around(-0.03, 15), ...around(0.05, 300)])?.peak).toBeCloseTo(0.05, 2);
  });

  it('is nowhere without points', () => {
    expect(faceOf([])).toBeNull();
  });

  it('is nowhere where points fill an area', () => {
    const random = randomNumbers(8);
    expect(faceOf(Array.from({ length: 2_000 }, () => 0.4 * random() - 0.05))).toBeNull();
  });
});

it('a strip holds the points that lie in it', () => {
  const random = randomNumbers(11);
  const xy = Float64Array.from({ length: 4_000 }, () => 10 * random() - 3);
  const points = new StripPoints(buildPointGrid(xy, 0.2));
  for (let k = 0; k < 200; k++) {
    const angle = k % 4 === 0 ? (k / 8) * Math.PI : 7 * random();
    const [x, y, ux, uy] = [8 * random() - 2, 8 * random() - 2, Math.cos(angle), Math.sin(angle)];
    const strip = { x, y, ux, uy, along: [-1, 4 * random()], across: [-random(), random()] } as const;
    points.gather(strip);
    let expected = 0;
    for (let i = 0; i < xy.length; i += 2) {
      const along = (xy[i] - x) * ux + (xy[i + 1] - y) * uy;
      const across = (xy[i + 1] - y) * ux - (xy[i] - x) * uy;
      const isIn = along >= strip.along[0] && along <= strip.along[1];
      if (isIn && across >= strip.across[0] && across <= strip.across[1]) expected++;
    }
    expect(points.size).toBe(expected);
  }
});
