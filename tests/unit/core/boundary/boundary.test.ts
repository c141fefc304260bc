import { describe, expect, it } from 'vitest';
import { alphaShape } from '../../../../src/core/boundary/alpha-shape.ts';
import { findBoundary } from '../../../../src/core/boundary.ts';
import { polygonArea } from '../../../../src/core/geometry/rings.ts';
import type { Options } from '../../../../src/core/params.ts';
import { expectValidPolygons } from '../../../invariants.ts';
import { intersectionOverUnion, ringOf } from './measures.ts';
import { asSlice, closed, ELL, listeningContext, optionsWith, scanWalls } from './wall-slices.ts';

const wallsOfEll = scanWalls({ walls: [closed(ELL)], perMetre: 120, noise: 0.004, seed: 1 });

function boundaryOf(xy: Float64Array, given: Partial<Options> = {}) {
  return findBoundary(asSlice(xy), optionsWith(given), listeningContext());
}

describe('findBoundary', () => {
  it.each([
    ['gift-opening', 0.99],
    ['alpha-shape', 0.97],
    ['concaveman', 0.97],
    ['convex', 0.8],
  ] as const)('outlines an L by %s', (boundary, least) => {
    const { method, polygons } = boundaryOf(wallsOfEll, { boundary });
    expect(method).toBe(boundary);
    expectValidPolygons(polygons);
    const share = intersectionOverUnion(polygons[0].outer, ringOf(ELL));
    expect(share).toBeGreaterThan(least);
    if (boundary === 'convex') expect(share).toBeLessThan(0.9);
  });

  it('takes the opening length as given and tells the one it worked out', () => {
    expect(boundaryOf(wallsOfEll, { openingLength: 0.7 }).openingLength).toBe(0.7);
    expect(boundaryOf(wallsOfEll).openingLength).toBeGreaterThanOrEqual(0.1);
    expect(boundaryOf(wallsOfEll, { boundary: 'convex' }).openingLength).toBe(0);
    const coarse = boundaryOf(wallsOfEll, { openingLength: 2 }).polygons[0].outer;
    expect(coarse.length).toBeLessThan(boundaryOf(wallsOfEll).polygons[0].outer.length);
  });

  it('follows concavity and alpha', () => {
    const vertices = (given: Partial<Options>) => boundaryOf(wallsOfEll, given).polygons[0].outer.length;
    expect(vertices({ boundary: 'concaveman', concavity: 8 })).toBeLessThan(
      vertices({ boundary: 'concaveman' }),
    );
    expect(vertices({ boundary: 'alpha-shape', alpha: 5 })).toBeLessThan(
      vertices({ boundary: 'alpha-shape', alpha: 0.3 }),
    );
  });

  it('closes a ring of concaveman on a lattice with repeats', () => {
    const xy: number[] = [];
    for (let i = 0; i < 12; i++) for (let j = 0; j < 9; j++) xy.push(i, j, i, j);
    expectValidPolygons(boundaryOf(Float64Array.from(xy), { boundary: 'concaveman', concavity: 1 }).polygons);
  });

  it.each([
    ['result/no-boundary', []],
    ['input/degenerate', [1, 1, 1, 1, 2, 2]],
    ['input/degenerate', [0, 0, 1, 1, 2, 2, 3, 3]],
    ['input/not-finite', [0, 0, 1, Number.NaN, 2, 5, 3, 3]],
  ])('throws %s for points %j', (code, points) => {
    for (const boundary of ['gift-opening', 'convex', 'alpha-shape', 'concaveman'] as const) {
      const run = () => boundaryOf(Float64Array.from(points), { boundary });
      expect(run).toThrow(expect.objectContaining({ code, hint: expect.stringMatching(/\w/) }));
    }
  });

  it('says so when alpha leaves nothing', () => {
    const xy = Float64Array.of(0, 0, 3, 0, 0, 4, 5, 5);
    const run = () => boundaryOf(xy, { boundary: 'alpha-shape', alpha: 0.001 });
    expect(run).toThrow(expect.objectContaining({ code: 'result/no-boundary', detail: { alpha: 0.001 } }));
  });

  it('says so when alpha leaves scraps', () => {
    const context = listeningContext();
    const options = optionsWith({ boundary: 'alpha-shape', alpha: 0.02 });
    findBoundary(asSlice(wallsOfEll), options, context);
    expect(context.warnings).toMatchObject([
      { code: 'boundary/collapsed', hint: expect.stringContaining('alpha') },
    ]);
  });

  it('says so when the opening length is longer than the slice', () => {
    const context = listeningContext();
    const { polygons } = findBoundary(asSlice(wallsOfEll), optionsWith({ openingLength: 50 }), context);
    expect(context.warnings.map(({ code }) => code)).toContain('boundary/not-opened');
    expect(context.warnings[0].message).toMatch(/50 m.*7\.\d\d m across/);
    expect(context.warnings[0].hint).toContain('let it be auto');
    expect(polygonArea(polygons[0])).toBeGreaterThan(24);
  });

  it('has no auto to offer where the length is auto, and tells three digits of it', () => {
    const context = listeningContext();
    findBoundary(asSlice(Float64Array.of(0, 0, 1, 0, 1 / 3, 2)), optionsWith({}), context);
    const [{ code, message, hint }] = context.warnings;
    expect(code).toBe('boundary/not-opened');
    expect(message).not.toMatch(/\d\.\d{3}/);
    expect(hint).not.toContain('auto');
  });

  it('takes three points', () => {
    const xy = Float64Array.of(0, 0, 3, 0, 0, 4);
    for (const boundary of ['gift-opening', 'convex', 'alpha-shape', 'concaveman'] as const) {
      const { polygons } = boundaryOf(xy, { boundary, alpha: 10 });
      expect(polygonArea(polygons[0])).toBe(6);
      expectValidPolygons(polygons);
    }
  });
});

describe('alphaShape', () => {
  it('keeps the hole of a ring and cuts rings where they touch', () => {
    const xy: number[] = [];
    for (let i = 0; i < 11; i++) {
      for (let j = 0; j < 11; j++) {
        if (i > 3 && i < 7 && j > 3 && j < 7) continue;
        xy.push(i + 0.01 * Math.sin(7 * i + 3 * j), j + 0.01 * Math.cos(5 * i - 2 * j));
      }
    }
    const polygons = alphaShape(Float64Array.from(xy), 0.8);
    expectValidPolygons(polygons);
    expect(polygons.length).toBe(1);
    expect(polygons[0].holes.length).toBe(1);
    // The hole's corners are cut: their triangles have a circumradius of 0.71.
    expect(polygonArea(polygons[0])).toBeCloseTo(100 - 16 + 2, 0);
  });

  it('splits parts that only share a vertex', () => {
    const two = Float64Array.of(0, 0, 1, -0.5, 1, 0.5, -1, -0.5, -1, 0.5);
    const polygons = alphaShape(two, 0.7);
    expect(polygons.length).toBe(2);
    expectValidPolygons(polygons);
  });

  it('is valid at every alpha on a scanned room', () => {
    for (const alpha of [0.02, 0.03, 0.05, 0.1, 0.3, 1, 10]) {
      const polygons = alphaShape(wallsOfEll, alpha);
      if (polygons.length > 0) expectValidPolygons(polygons);
    }
  });
});
