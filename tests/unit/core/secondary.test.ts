import { describe, expect, test } from 'vitest';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { findBoundary } from '../../../src/core/boundary.ts';
import { centroid, polygonArea, signedArea } from '../../../src/core/geometry/rings.ts';
import { meanSpacing } from '../../../src/core/geometry/spacing.ts';
import { clusterPoints } from '../../../src/core/kmeans.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { createRandom, type Random } from '../../../src/core/random.ts';
import { regulariseBoundary } from '../../../src/core/regularise.ts';
import { averageDistance } from '../../../src/core/secondary/average-distance.ts';
import { completeShell } from '../../../src/core/secondary/complete-shell.ts';
import { pointsInStroke } from '../../../src/core/secondary/points-in-stroke.ts';
import { findSecondary } from '../../../src/core/secondary.ts';
import type { Slice } from '../../../src/core/types.ts';
import { expectValidPolygons, expectValidRing } from '../../invariants.ts';
import { codesOf, listen, shuffled } from './made-scan.ts';

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
  return { ...result, codes: codesOf(warnings), regularised };
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

describe('pointsInStroke', () => {
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
    expect(averageDistance(square, 0.25, random)).toBe(0);
  });

  test('of a random sample comes near that of all', () => {
    const random = createRandom(2);
    const disc = Float64Array.from({ length: 8000 }, () => random());
    // Mean distance of two points in the unit square.
    expect(averageDistance(disc, 0.75, random)).toBeCloseTo(0.5214, 2);
  });
});
