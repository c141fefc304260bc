import { describe, expect, test } from 'vitest';
import { seededRandom } from '../../../fixtures/simulator/random.ts';
import {
  drawSlice,
  PAPER_SLICES,
  type PaperSliceName,
  paperSlice,
} from '../../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { findBoundary } from '../../../src/core/boundary.ts';
import { centroid, pointInRing, polygonArea, signedArea } from '../../../src/core/geometry/rings.ts';
import { meanSpacing } from '../../../src/core/geometry/spacing.ts';
import { clusterPoints } from '../../../src/core/kmeans.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { createRandom, type Random } from '../../../src/core/random.ts';
import { regulariseBoundary } from '../../../src/core/regularise.ts';
import { averageDistance } from '../../../src/core/secondary/average-distance.ts';
import { completeShell } from '../../../src/core/secondary/complete-shell.ts';
import { groupPoints } from '../../../src/core/secondary/point-groups.ts';
import { pointsInStroke } from '../../../src/core/secondary/points-in-stroke.ts';
import { proposeCount } from '../../../src/core/secondary/propose-count.ts';
import { RingEdges } from '../../../src/core/secondary/ring-edges.ts';
import { distanceToRing } from '../../../src/core/secondary/structure.ts';
import { findWallFaces } from '../../../src/core/secondary/wall-faces.ts';
import { findSecondary } from '../../../src/core/secondary.ts';
import type { Slice } from '../../../src/core/types.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../src/session/session.ts';
import { expectValidPolygons, expectValidRing } from '../../invariants.ts';
import { codesOf, listen, shuffled } from './made-scan.ts';

const metres = (pixels: Float64Array) => pixels.map((value) => value / 100);

function pointKeys(xy: Float64Array): string[] {
  return Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]} ${xy[2 * i + 1]}`);
}

type Given = Parameters<typeof resolveOptions>[0];

function run(xy: Float64Array, given: Given) {
  const options = resolveOptions(given);
  const slice: Slice = { xy, band: [0, 0], spacing: meanSpacing(xy) };
  const quiet = listen();
  const regularised = regulariseBoundary(
    findBoundary(slice, options, quiet.context),
    slice,
    options,
    quiet.context,
  );
  const { context, warnings } = listen();
  const strokeTest = createStrokeTest();
  const result = findSecondary(slice, regularised, options, { ...context, strokeTest });
  return { ...result, warnings, codes: codesOf(warnings), regularised };
}

interface Shape {
  readonly count: number;
  readonly noise: number;
  readonly random: Random;
}

/** Points along a closed line. */
function outlinePoints(corners: readonly number[], { count, noise, random }: Shape): number[] {
  const lengths = corners.flatMap((_, i) => (i % 2 === 0 ? [edgeLength(corners, i)] : []));
  const total = lengths.reduce((a, b) => a + b, 0);
  const points: number[] = [];
  lengths.forEach((length, e) => {
    const [ax, ay, bx, by] = [0, 1, 2, 3].map((k) => corners[(2 * e + k) % corners.length]);
    const steps = Math.round((count * length) / total);
    for (let s = 0; s < steps; s++) {
      points.push(ax + ((bx - ax) * s) / steps + noise * (random() - 0.5));
      points.push(ay + ((by - ay) * s) / steps + noise * (random() - 0.5));
    }
  });
  return points;
}

function edgeLength(corners: readonly number[], i: number): number {
  const j = (i + 2) % corners.length;
  return Math.hypot(corners[j] - corners[i], corners[j + 1] - corners[i + 1]);
}

const rectangle = (x: number, y: number, w: number, h: number) => [x, y, x + w, y, x + w, y + h, x, y + h];
const circle = (x: number, y: number, r: number) =>
  Array.from({ length: 80 }, (_, k) => [
    x + r * Math.cos((k * Math.PI) / 40),
    y + r * Math.sin((k * Math.PI) / 40),
  ]).flat();

function room(...structures: readonly (readonly number[])[]): Float64Array {
  const random = createRandom(11);
  const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 900, noise: 0.01, random });
  const inner = structures.flatMap((corners) => outlinePoints(corners, { count: 120, noise: 0.01, random }));
  return Float64Array.from([...walls, ...inner]);
}

describe('robust', () => {
  test('outlines a square column by its outer face', () => {
    const { boundaries, clusters, codes } = run(room(rectangle(3, 2, 0.6, 0.6)), { secondaryCount: 1 });
    expect(boundaries.length).toBe(1);
    expectValidPolygons(boundaries.map(({ outline }) => outline));
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(0.36, 1);
    const [x, y] = centroid(boundaries[0].outline.outer);
    expect(x).toBeCloseTo(3.3, 1);
    expect(y).toBeCloseTo(2.3, 1);
    expect(boundaries[0].type).toBe('column');
    expect(clusters.filter((cluster) => cluster === 1).length).toBe(boundaries[0].points);
    expect(codes).toEqual([]);
  });

  test('finds several, the largest first, and gives each its operation', () => {
    const xy = room(circle(2, 2.5, 0.3), rectangle(4, 1.5, 2, 1.6));
    const { boundaries } = run(xy, { secondaryCount: 2, secondaryOperation: ['add', 'independent'] });
    expect(boundaries.map(({ type }) => type)).toEqual(['shaft', 'column']);
    expect(boundaries.map(({ operation }) => operation)).toEqual(['add', 'independent']);
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(3.2, 1);
    expect(polygonArea(boundaries[1].outline)).toBeCloseTo(Math.PI * 0.09, 1);
  });

  test('the last operation counts for all that follow', () => {
    const xy = room(circle(2, 2.5, 0.3), rectangle(4, 1.5, 1, 1), circle(6.5, 3, 0.25));
    const { boundaries } = run(xy, { secondaryCount: 3, secondaryOperation: ['add', 'subtract'] });
    expect(boundaries.map(({ operation }) => operation)).toEqual(['add', 'subtract', 'subtract']);
  });

  test('completes a round column of which half was seen', () => {
    const half = circle(3, 2.5, 0.4).slice(0, 80);
    const random = createRandom(4);
    const arc = half.map((value) => value + 0.01 * (random() - 0.5));
    const { boundaries } = run(Float64Array.from([...room(), ...arc]), { secondaryCount: 1 });
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(Math.PI * 0.16, 1);
    expect(centroid(boundaries[0].outline.outer)[1]).toBeCloseTo(2.5, 1);
  });

  test('what hangs together with a wall is no structure', () => {
    const { boundaries, codes } = run(room(rectangle(3, 0, 0.6, 0.6)), { secondaryCount: 1 });
    expect(boundaries).toEqual([]);
    expect(codes).toEqual(['secondary/fewer-found']);
  });

  test('a free-standing piece of wall comes after a column', () => {
    const { boundaries } = run(room(rectangle(2, 2, 3, 0.12), rectangle(6, 3, 0.4, 0.4)), {
      secondaryCount: 1,
    });
    expect(centroid(boundaries[0].outline.outer)[0]).toBeCloseTo(6.2, 1);
  });

  test('a number left to it takes all structures, but no pieces of wall', () => {
    const xy = room(rectangle(2, 2, 3, 0.12), rectangle(6, 3, 0.4, 0.4), circle(1.2, 1.5, 0.3));
    const { boundaries, codes } = run(xy, { secondaryCount: 'auto' });
    expect(boundaries.map(({ type }) => type)).toEqual(['column', 'column']);
    expect(codes).toEqual([]);
    expect(run(room(), { secondaryCount: 'auto' }).boundaries).toEqual([]);
  });

  test('a number left to it takes nothing filled with points, such as furniture, nor half a cubicle', () => {
    const random = createRandom(7);
    const sofa = Array.from({ length: 600 }, () => [2 + 1.6 * random(), 2 + 0.8 * random()]).flat();
    const half = outlinePoints([5, 2, 7, 2, 7, 3.6], { count: 300, noise: 0.01, random }).slice(0, 2 * 190);
    for (const points of [sofa, half]) {
      const xy = Float64Array.from([...room(), ...points]);
      expect(run(xy, { secondaryCount: 'auto' }).boundaries).toEqual([]);
      expect(run(xy, { secondaryCount: 1 }).boundaries.length).toBe(1);
    }
  });

  test('a column 0.1 m from a wall, or from two, stands free of them', () => {
    for (const [x, y] of [
      [3, 0.1],
      [0.1, 0.1],
    ]) {
      const { boundaries, codes } = run(room(rectangle(x, y, 0.5, 0.5)), { secondaryCount: 'auto' });
      expect(codes).toEqual([]);
      expect(boundaries.length).toBe(1);
      expect(polygonArea(boundaries[0].outline)).toBeCloseTo(0.25, 1);
      expect(centroid(boundaries[0].outline.outer)[0]).toBeCloseTo(x + 0.25, 1);
    }
  });

  test('a partition that grows out of a wall is no structure, drawn or scanned', () => {
    const random = createRandom(2);
    for (const noise of [0, 0.02]) {
      const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 900, noise, random });
      const [left, right] = [3, 3.3].map((x) =>
        Array.from({ length: 60 }, (_, k) => [x + noise * (random() - 0.5), 0.02 * (k + 0.5)]).flat(),
      );
      const end = Array.from({ length: 15 }, (_, k) => [3 + 0.02 * k, 1.2]).flat();
      const xy = Float64Array.from([...walls, ...left, ...right, ...end]);
      expect(run(xy, { secondaryCount: 'auto' }).boundaries).toEqual([]);
    }
  });

  test('a partition that stops and goes on is no structure in any of its pieces', () => {
    const random = createRandom(6);
    const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 1300, noise: 0.01, random });
    const pieces = [0.02, 0.9, 1.8, 3.1].flatMap((y) =>
      outlinePoints(rectangle(3, y, 0.24, 0.8), { count: 100, noise: 0.01, random }),
    );
    // Beyond the opening that ends at 3.1 m the wall leads on to the other side.
    const end = outlinePoints(rectangle(3, 3.95, 0.24, 1.05), { count: 130, noise: 0.01, random });
    const xy = Float64Array.from([...walls, ...pieces, ...end]);
    expect(run(xy, { secondaryCount: 'auto' }).boundaries).toEqual([]);
  });

  test('a stub as thin as a partition is not certain, however short; a slender column is', () => {
    const stub = room(rectangle(3, 2, 0.15, 0.5));
    expect(run(stub, { secondaryCount: 'auto' }).boundaries).toEqual([]);
    expect(run(stub, { secondaryCount: 1 }).boundaries.length).toBe(1);
    const turned = [3, 2, 3.17, 2.17, 3, 2.34, 2.83, 2.17];
    expect(run(room(turned), { secondaryCount: 'auto' }).boundaries.length).toBe(1);
  });

  test('two faces belong together when a few points show the side between them', () => {
    const random = createRandom(9);
    const [left, right] = [3, 3.7].map((x) =>
      Array.from({ length: 60 }, (_, k) => [x + 0.01 * random(), 2 + (0.7 * k) / 60]).flat(),
    );
    const between = [3.14, 2, 3.31, 2, 3.45, 2, 3.58, 2];
    const xy = Float64Array.from([...room(), ...left, ...right, ...between]);
    const { boundaries } = run(xy, { secondaryCount: 'auto' });
    expect(boundaries.map(({ type }) => type)).toEqual(['column']);
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(0.49, 1);
  });

  test('strays on a square are none, however square', () => {
    const strays = outlinePoints(rectangle(3, 2, 0.6, 0.6), { count: 8, noise: 0, random: createRandom(1) });
    const xy = Float64Array.from([...room(), ...strays]);
    expect(run(xy, { secondaryCount: 'auto' }).boundaries).toEqual([]);
  });

  test('what is thinner than the noise of the walls is none', () => {
    const random = createRandom(5);
    const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 2500, noise: 0.5, random });
    const small = outlinePoints(rectangle(4, 2, 0.3, 0.3), { count: 60, noise: 0, random });
    const xy = Float64Array.from([...walls, ...small]);
    expect(run(xy, { secondaryCount: 1 }).boundaries).toEqual([]);
    const clean = Float64Array.from([...room(), ...small]);
    expect(run(clean, { secondaryCount: 1 }).boundaries.length).toBe(1);
  });

  test('a drawn slice without any noise keeps the exact outline', () => {
    const random = createRandom(1);
    const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 900, noise: 0, random });
    const square = outlinePoints(rectangle(3, 2, 0.6, 0.6), { count: 120, noise: 0, random });
    const { boundaries } = run(Float64Array.from([...walls, ...square]), { secondaryCount: 'auto' });
    expect(boundaries.length).toBe(1);
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(0.36, 6);
  });

  test('what would cover the plan is left out, and said', () => {
    const noisy = { count: 900, noise: 0.01, random: createRandom(2) };
    const xy = Float64Array.from([...room(), ...outlinePoints(rectangle(0.5, 0.5, 7, 4), noisy)]);
    const { boundaries, codes, warnings } = run(xy, { secondaryCount: 'auto' });
    expect(boundaries).toEqual([]);
    expect(codes).toEqual(['secondary/covers-plan', 'secondary/fewer-found']);
    expect(warnings[0].hint).not.toContain('robust');
  });

  test('a piece of wall that was asked for is said to be one', () => {
    const xy = room(rectangle(2, 2, 3, 0.12), rectangle(6, 3, 0.4, 0.4));
    expect(run(xy, { secondaryCount: 1 }).codes).toEqual([]);
    const { boundaries, warnings } = run(xy, { secondaryCount: 2 });
    expect(boundaries.length).toBe(2);
    expect(codesOf(warnings)).toEqual(['secondary/sliver']);
    expect(warnings[0].message).toContain('Secondary boundary 2 is');
  });

  test('an epsilon larger than the structure leaves its shape', () => {
    const { boundaries } = run(room(circle(3, 2.5, 0.3)), { secondaryCount: 1, secondaryEpsilon: 5 });
    expect(polygonArea(boundaries[0].outline)).toBeCloseTo(Math.PI * 0.09, 1);
    expect(boundaries[0].outline.outer.length / 2).toBeGreaterThan(5);
  });

  test('none are sought when none are wanted', () => {
    expect(run(room(rectangle(3, 2, 0.6, 0.6)), { secondaryCount: 0 }).boundaries).toEqual([]);
  });

  test('the order of the points does not matter', () => {
    const xy = room(rectangle(3, 2, 0.6, 0.6));
    const other = shuffled(xy, 2, createRandom(8));
    const [a, b] = [run(xy, { secondaryCount: 1 }), run(other, { secondaryCount: 1 })];
    expect(b.boundaries).toEqual(a.boundaries);
  });
});

describe('paper', () => {
  const PAPER: Given = { preset: 'paper', secondaryCount: 1, secondaryMethod: 'paper' };

  /** As the paper's Room_1a: 628 points, a hollow square with thick walls of points. */
  function paperRoom(): Float64Array {
    const random = createRandom(3);
    const walls = outlinePoints(rectangle(0, 0, 6, 4), { count: 260, noise: 0.04, random });
    const square = outlinePoints(rectangle(3.4, 1.4, 1.2, 1.2), { count: 368, noise: 0.2, random });
    return Float64Array.from([...walls, ...square]);
  }

  test('finds the innermost points of the structure: a ring smaller than its outer face', () => {
    const { boundaries, clusters, codes, regularised } = run(paperRoom(), PAPER);
    expect(codes).toEqual([]);
    expectValidPolygons(boundaries.map(({ outline }) => outline));
    const area = polygonArea(boundaries[0].outline);
    expect(area).toBeLessThan(1.4 ** 2);
    expect(area).toBeGreaterThan(1);
    const [x, y] = centroid(boundaries[0].outline.outer);
    expect(x).toBeCloseTo(4, 0);
    expect(y).toBeCloseTo(2, 0);
    expect(area).toBeLessThan(0.1 * polygonArea(regularised.polygons[0]));
    expect(new Set(clusters)).toEqual(new Set([0, 1]));
  });

  test('a round never grows the boundary of the one before', () => {
    const areas = [1, 2, 3].map((secondaryRounds) => {
      const { boundaries } = run(paperRoom(), { ...PAPER, secondaryRounds });
      return polygonArea(boundaries[0].outline);
    });
    expect(areas[1]).toBeLessThan(areas[0]);
    expect(areas[2]).toBeLessThanOrEqual(areas[1]);
  });

  test('equal seeds, equal results, whatever the order of the points', () => {
    const one = run(paperRoom(), PAPER);
    const other = run(shuffled(paperRoom(), 2, createRandom(8)), PAPER);
    expect(run(paperRoom(), PAPER).boundaries).toEqual(one.boundaries);
    expect(centroid(other.boundaries[0].outline.outer)[0]).toBeCloseTo(
      centroid(one.boundaries[0].outline.outer)[0],
      1,
    );
  });
});

test.each([
  [1, false],
  [3, true],
] as const)(
  'the method of the paper, asked for %i, says of slivers that they are: %s',
  (secondaryCount, isSaid) => {
    const given: Given = { preset: 'paper', secondaryMethod: 'paper', secondaryCount };
    const { codes } = run(metres(paperSlice('room-1a').xy), given);
    expect(codes.includes('secondary/sliver')).toBe(isSaid);
  },
);

describe('the search of the paper', () => {
  const given: Given = { preset: 'paper', secondaryCount: 1, secondaryMethod: 'paper', secondaryRounds: 3 };

  test('tells every round, each within the boundary of the one before', () => {
    const slice = paperSlice('room-1a');
    const { clusters, searches, boundaries, regularised } = run(metres(slice.xy), given);
    expect(searches.length).toBe(1);
    const [{ cluster, rounds }] = searches;
    const members = new Set(pointKeys(metres(slice.xy).filter((_, i) => clusters[i >> 1] === cluster)));
    let previous = regularised.polygons[0].outer;
    for (const { near, outline, innermost, result } of rounds) {
      expect(pointKeys(near).every((key) => members.has(key))).toBe(true);
      const isNear = new Set(pointKeys(near));
      expect(pointKeys(innermost).every((key) => isNear.has(key))).toBe(true);
      expect(innermost.length).toBeLessThan(near.length);
      for (let i = 0; i < near.length; i += 2)
        expect(pointInRing(near[i], near[i + 1], previous)).toBeGreaterThan(0);
      for (const ring of [outline, result]) if (ring) expectValidRing(ring);
      if (result) previous = result;
    }
    expect(boundaries[0].outline.outer).toEqual(previous);
    expect(rounds.length).toBeGreaterThan(1);
  });

  test('takes the cluster with the most points, or the one picked', () => {
    const xy = metres(paperSlice('room-1a').xy);
    const byItself = run(xy, given);
    const sizes = [0, 1].map((k) => byItself.clusters.filter((cluster) => cluster === k).length);
    expect(byItself.searches[0].cluster).toBe(sizes[0] > sizes[1] ? 0 : 1);
    for (const cluster of [0, 1]) {
      const picked = run(xy, { ...given, secondaryCluster: cluster });
      expect(picked.searches.map((search) => search.cluster)).toEqual([cluster]);
    }
    const missing = run(xy, { ...given, secondaryCluster: 9 });
    expect(missing.codes).toContain('secondary/no-such-cluster');
    expect(missing.searches[0].cluster).toBe(byItself.searches[0].cluster);
  });

  test('a cluster picked comes first, the largest that hold more than walls follow', () => {
    const xy = room(circle(2, 2.5, 0.4), rectangle(5.5, 2, 0.8, 0.8));
    const { searches } = run(xy, { ...given, secondaryCount: 2, secondaryCluster: 2, secondaryRounds: 1 });
    expect(searches[0].cluster).toBe(2);
    expect(new Set(searches.map(({ cluster }) => cluster)).size).toBe(searches.length);
  });

  test('a number left to it is proposed by silhouette', () => {
    const { searches } = run(metres(paperSlice('room-2').xy), { ...given, secondaryCount: 'auto' });
    expect(searches.length).toBe(1);
  });

  test('more structures than points: said, and the plan goes on', () => {
    const { boundaries, codes } = run(Float64Array.of(0, 0, 4, 0, 4, 3, 0, 3), {
      ...given,
      secondaryCount: 8,
    });
    expect(boundaries).toEqual([]);
    expect(codes).toContain('secondary/too-many');
    expect(codes.at(-1)).toBe('secondary/fewer-found');
  });

  test('a cluster on a line gives no outline, and says so', () => {
    const random = createRandom(3);
    const walls = outlinePoints(rectangle(0, 0, 8, 5), { count: 60, noise: 0, random });
    const line = Array.from({ length: 100 }, (_, k) => [6 + 0.01 * k, 2.5]).flat();
    const { boundaries, searches, codes } = run(Float64Array.from([...walls, ...line]), {
      ...given,
      secondaryCount: 2,
    });
    expect(boundaries).toEqual([]);
    expect(searches[0].rounds).toMatchObject([{ outline: null, result: null }]);
    expect(codes).toContain('secondary/no-outline');
  });

  test('a stroke over all points ends the rounds, and says so', () => {
    const xy = metres(paperSlice('room-1a').xy);
    const { boundaries, codes } = run(xy, { ...given, strokeWidth: 5 });
    expect(boundaries).toEqual([]);
    expect(codes).toEqual(['secondary/no-outline', 'secondary/fewer-found']);
  });
});

test('a proposal is told in the outcome of the stage', async () => {
  const { xy } = paperSlice('room-1a');
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  const session = new Session({ strokeTest: createStrokeTest() });
  const source = blobSource(new Blob([`x,y\n${rows.join('\n')}\n`]), 'room.csv');
  const outcome = async (given: Given) =>
    (await session.load(source, given)).stages.find(({ name }) => name === 'secondary')?.outcome;
  expect(await outcome({ secondaryMethod: 'robust', secondaryCount: 'auto' })).toBe('1 proposed');
  expect(await outcome({ secondaryCount: 'auto' })).toBe('1 proposed');
  expect(await outcome({ secondaryCount: 1 })).toBe('1 structure');
});

describe('proposeCount', () => {
  test('blobs are one more than the structures proposed', () => {
    const random = createRandom(6);
    for (const blobs of [2, 3, 5]) {
      const xy = Float64Array.from({ length: 600 * blobs }, (_, i) => {
        const blob = (i >> 1) % blobs;
        const angle = (2 * Math.PI * blob) / blobs;
        return 6 * (i % 2 === 0 ? Math.cos(angle) : Math.sin(angle)) + random();
      });
      expect(proposeCount(xy, 1)).toBe(blobs - 1);
      expect(proposeCount(shuffled(xy, 2, createRandom(1)), 1)).toBe(blobs - 1);
    }
  });

  test('two points suggest nothing', () => {
    expect(proposeCount(Float64Array.of(0, 0, 1, 1, 0, 0), 1)).toBe(0);
  });
});

describe('RingEdges', () => {
  /** Outlines as rough as scans give them, and one that folds back beside itself. */
  const rough = (vertices: number, wobble: number, random: Random) =>
    Float64Array.from({ length: 2 * vertices }, (_, i) => {
      const angle = (2 * Math.PI * (i >> 1)) / vertices;
      return (i % 2 === 0 ? 5 * Math.cos(angle) : 3 * Math.sin(angle)) * (1 - wobble * random());
    });

  test('finds the nearest edge of many, as looking at each one does', () => {
    const random = createRandom(12);
    for (const [vertices, wobble] of [
      [4, 0],
      [9, 0.3],
      [700, 0.2],
      [2000, 0.9],
    ]) {
      const rings = [rough(vertices, wobble, random), rough(vertices, wobble, random).map((v) => v / 3)];
      const edges = new RingEdges(rings);
      for (let k = 0; k < 300; k++) {
        const [x, y] = [14 * (random() - 0.5), 10 * (random() - 0.5)];
        const least = Math.min(...rings.map((ring) => distanceToRing(x, y, ring)));
        expect(edges.distanceTo(x, y)).toBeCloseTo(least, 9);
      }
    }
  });

  test('of edges as near as each other the first counts, and past says how far beyond its ends a point lies', () => {
    const edges = new RingEdges([Float64Array.from(rectangle(0, 0, 4, 3))]);
    edges.project(5, -1);
    expect([edges.edge, edges.along, edges.across, edges.past]).toEqual([0, 5, -1, 1]);
    edges.project(2, 1.5);
    expect([edges.edge, edges.across, edges.past]).toEqual([0, 1.5, 0]);
  });
});

describe('groupPoints', () => {
  test('parts the points that count, each into one group', () => {
    const xy = Float64Array.of(0, 0, 10, 0, 0.5, 0.5, 5, 5, 10.4, 0.2, 1.2, 1.1);
    const groups = groupPoints(xy, Uint32Array.of(0, 1, 2, 4, 5), 1);
    expect(groups.map((group) => [...group])).toEqual([
      [0, 2, 5],
      [1, 4],
    ]);
  });
});

describe('findWallFaces', () => {
  test.each([0.005, 0.012, 0.03])('tells a noise of %s m, dense or sparse', (noise) => {
    for (const points of [300, 3000]) {
      const design = { points, primary: PAPER_SLICES['room-1a'].primary };
      const xy = metres(drawSlice(design, seededRandom(4), 100 * noise).xy);
      const slice = { xy, band: [0, 0] as const, spacing: meanSpacing(xy) };
      const faces = findWallFaces(slice, resolveOptions({}), listen().context);
      expect(faces.noise / noise).toBeGreaterThan(0.8);
      expect(faces.noise / noise).toBeLessThan(1.25);
      // The face lies in the middle of its points, not along the outermost: 0.6 m in x is 60 px.
      expect(Math.abs(faces.heightAt(1.6, 2.4) - 1)).toBeLessThan(noise);
      expect(faces.heightAt(0.4, 2.4)).toBeLessThan(0);
    }
  });
});

describe('pointsInStroke', () => {
  test.each(Object.keys(PAPER_SLICES) as PaperSliceName[])(
    'agrees with the canvas on every point of %s, along its own outline',
    (name) => {
      const strokeTest = createStrokeTest();
      const xy = metres(paperSlice(name).xy);
      const options = resolveOptions({ preset: 'paper' });
      const slice: Slice = { xy, band: [0, 0], spacing: meanSpacing(xy) };
      const ring = findBoundary(slice, options, listen().context).polygons[0].outer;
      const mixed = pointsInStroke(xy, ring, { width: 0.1, pixelsPerMetre: 100, strokeTest });
      expect(mixed).toEqual(askCanvas(xy, ring, strokeTest));
      expect(mixed.reduce((sum, value) => sum + value, 0)).toBeGreaterThan(100);
    },
  );

  test('agrees with the canvas on every point', () => {
    const strokeTest = createStrokeTest();
    let edges = 0;
    for (let seed = 0; seed < 20; seed++) {
      const random = createRandom(seed);
      const ring = Float64Array.from(circle(5, 5, 1 + random()).filter((_, i) => i % 20 < 2));
      // Half of the points hug the edge of the stroke.
      const xy = Float64Array.from({ length: 2000 }, (_, i) =>
        i % 2 === 0 ? ring[i % ring.length] : ring[i % ring.length],
      );
      for (let i = 0; i < xy.length; i++) xy[i] += 0.16 * (random() - 0.5);
      const mixed = pointsInStroke(xy, ring, { width: 0.1, pixelsPerMetre: 100, strokeTest });
      const canvasOnly = askCanvas(xy, ring, strokeTest);
      expect(mixed).toEqual(canvasOnly);
      edges += mixed.reduce((sum, value) => sum + value, 0);
    }
    expect(edges).toBeGreaterThan(1000);
  });

  function askCanvas(xy: Float64Array, ring: Float64Array, strokeTest: ReturnType<typeof createStrokeTest>) {
    const [minX, minY] = [0, 1].map((k) => Math.min(...[...xy, ...ring].filter((_, i) => i % 2 === k)));
    const toCanvas = (value: number, i: number) => (value - (i % 2 === 0 ? minX : minY)) * 100 + 16;
    const points = xy.map(toCanvas);
    const corners = ring.map(toCanvas);
    const all = new Uint8Array(points.length / 2);
    for (let i = 0; i < corners.length; i += 2) {
      const j = (i + corners.length - 2) % corners.length;
      const answers = strokeTest([corners[j], corners[j + 1], corners[i], corners[i + 1]], 10, points);
      answers.forEach((answer, k) => {
        all[k] |= answer;
      });
    }
    return all;
  }

  test('caps are butt: a stroke ends with its segment', () => {
    const ring = Float64Array.of(0, 0, 4, 0, 4, 3);
    const xy = Float64Array.of(2, 0.04, 2, 0.06, -0.02, 0, 4.02, 1);
    const stroke = { width: 0.1, pixelsPerMetre: 100, strokeTest: createStrokeTest() };
    expect(pointsInStroke(xy, ring, stroke)).toEqual(Uint8Array.of(1, 0, 0, 1));
  });
});

describe('completeShell', () => {
  test('two faces give their rectangle', () => {
    const faces: number[] = [];
    for (let k = 0; k <= 50; k++) faces.push((k * 0.8) / 50, 0, 0, (k * 0.5) / 50);
    const ring = completeShell(Float64Array.from(faces))!;
    expectValidRing(ring);
    expect(signedArea(ring)).toBeCloseTo(0.4, 6);
  });

  test('a shape that is neither stays undecided', () => {
    const random = createRandom(5);
    expect(completeShell(Float64Array.from({ length: 400 }, () => random()))).toBeNull();
  });
});

describe('clusterPoints', () => {
  const random = createRandom(6);
  const blobs = Float64Array.from({ length: 1200 }, (_, i) => {
    const blob = Math.floor(i / 400);
    return [0, 0, 10, 0, 4, 9][2 * blob + (i % 2)] + random();
  });

  test('parts three blobs, from left to right, whatever the order', () => {
    const { sizes, centres, clusterOf } = clusterPoints(blobs, 3, 1);
    expect([...sizes]).toEqual([200, 200, 200]);
    [0.5, 0.5, 4.5, 9.5, 10.5, 0.5].forEach((value, i) => {
      expect(centres[i]).toBeCloseTo(value, 0);
    });
    expect(clusterOf[0]).toBe(0);
    expect(clusterPoints(shuffled(blobs, 2, createRandom(1)), 3, 1).sizes).toEqual(sizes);
  });

  test('fewer points than clusters are clusters of their own', () => {
    expect([...clusterPoints(Float64Array.of(3, 3, 1, 1, 3, 3), 4, 1).sizes]).toEqual([1, 2]);
  });
});

describe('averageDistance', () => {
  test('of all points of a pair and a square', () => {
    const random = createRandom(1);
    expect(averageDistance(Float64Array.of(0, 0, 3, 4), 1, random)).toBe(5);
    const square = Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1);
    expect(averageDistance(square, 1, random)).toBeCloseTo((4 + 2 * Math.SQRT2) / 6, 12);
    expect(averageDistance(Float64Array.of(3, 3), 1, random)).toBe(0);
    // A share that leaves one point still compares two.
    expect([1, Math.SQRT2]).toContainEqual(averageDistance(square, 0.25, random));
    expect(averageDistance(Float64Array.of(0, 0, 3, 4), 0.05, random)).toBe(5);
  });

  test('of a random sample comes near that of all', () => {
    const random = createRandom(2);
    const disc = Float64Array.from({ length: 8000 }, () => random());
    // Mean distance of two points in the unit square.
    expect(averageDistance(disc, 0.75, random)).toBeCloseTo(0.5214, 2);
  });
});
