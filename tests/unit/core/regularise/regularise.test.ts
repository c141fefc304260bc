import { describe, expect, it } from 'vitest';
import { findBoundary } from '../../../../src/core/boundary.ts';
import type { Options } from '../../../../src/core/params.ts';
import { passesOf, regulariseBoundary, tolerancesFor } from '../../../../src/core/regularise.ts';
import type { Boundary } from '../../../../src/core/types.ts';
import { expectValidPolygons } from '../../../invariants.ts';
import { intersectionOverUnion, ringOf } from '../boundary/measures.ts';
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

const SMALL: Path = [
  [0, 0],
  [2, 0],
  [2, 1.5],
  [0, 1.5],
];
const slice = asSlice(scanWalls({ walls: [closed(ELL)], perMetre: 200, noise: 0.006, seed: 1 }));
const boundary = findBoundary(slice, optionsWith(), listeningContext());
const run = (given: Partial<Options> = {}) =>
  regulariseBoundary(boundary, slice, optionsWith(given), listeningContext());

describe('regulariseBoundary', () => {
  it('straightens an L to a few vertices and keeps its shape', () => {
    const { passes, polygons } = run();
    expect(passes.map(({ name }) => name)).toEqual([
      'noise',
      'radial',
      'douglas-peucker',
      'visvalingam',
      'corners',
    ]);
    expect(passes[4].polygons).toBe(polygons);
    for (const pass of passes) expectValidPolygons(pass.polygons);
    expect(polygons[0].outer.length / 2).toBeLessThan(20);
    expect(intersectionOverUnion(polygons[0].outer, ringOf(ELL))).toBeGreaterThan(0.98);
  });

  it('shows each pass by itself and runs only those switched on', () => {
    const { passes } = run({
      noisePass: false,
      radialPass: false,
      visvalingamPass: false,
      cornerPass: false,
    });
    expect(passes.map(({ name }) => name)).toEqual(['douglas-peucker']);
    const none = run({
      noisePass: false,
      radialPass: false,
      douglasPeuckerPass: false,
      visvalingamPass: false,
      cornerPass: false,
    });
    expect(none.passes).toEqual([]);
    expect(none.polygons).toBe(boundary.polygons);
  });

  it('drops more the larger its tolerances', () => {
    const vertices = (given: Partial<Options>) =>
      run({ ...given, noisePass: false, cornerPass: false }).polygons[0].outer.length;
    expect(vertices({ epsilon: 0.5 })).toBeLessThan(vertices({ epsilon: 0.01 }));
    expect(vertices({ epsilon: 0.02, visvalingamEpsilon: 0.5 })).toBeLessThan(
      vertices({ epsilon: 0.02, visvalingamEpsilon: 0 }),
    );
  });

  it('never lets thin walls cross, at any tolerance', () => {
    const face: Path = [
      [0, 0],
      [8, 0],
      [8, 6],
      [0, 6],
    ];
    const random = randomNumbers(8);
    const normal = normalNumbers(random);
    // The outline of a free-standing wall 0.1 m thick: two faces, every 2 cm.
    const outer = closed(face).flatMap((a, k, path) => {
      const b = path[(k + 1) % path.length];
      return Array.from({ length: 100 }, (_, m) => [
        a[0] + ((b[0] - a[0]) * m) / 100 + normal() * 0.004,
        a[1] + ((b[1] - a[1]) * m) / 100 + normal() * 0.004,
      ]);
    });
    const ring = Float64Array.from(outer.slice(0, 350).flat());
    const inner = ring.map((value, i) => value * 0.97 + (i % 2 === 0 ? 0.12 : 0.09));
    const back: number[] = [];
    for (let i = inner.length - 2; i >= 0; i -= 2) back.push(inner[i], inner[i + 1]);
    const wall: Boundary = {
      method: 'gift-opening',
      polygons: [{ outer: Float64Array.from([...ring, ...back]), holes: [] }],
      openingLength: 0.1,
      gaps: [],
    };
    expectValidPolygons(wall.polygons);
    for (const epsilon of [0.01, 0.05, 0.1, 0.15, 0.2, 0.5, 1, 5]) {
      const { passes } = regulariseBoundary(wall, slice, optionsWith({ epsilon }), listeningContext());
      for (const pass of passes) expectValidPolygons(pass.polygons);
    }
  });

  it('keeps holes inside their outer ring', () => {
    const outer = Float64Array.of(0, 0, 4, 0, 4, 3, 2, 3.3, 0, 3);
    const holes = [Float64Array.of(1.9, 3.1, 2, 3.2, 2.1, 3.1)];
    const plate: Boundary = {
      method: 'alpha-shape',
      polygons: [{ outer, holes }],
      openingLength: 0,
      gaps: [],
    };
    expectValidPolygons(plate.polygons);
    for (const epsilon of [0.1, 0.5, 2]) {
      expectValidPolygons(
        regulariseBoundary(plate, slice, optionsWith({ epsilon }), listeningContext()).polygons,
      );
    }
  });
});

describe('tolerances larger than the shape', () => {
  it.each([
    [{ epsilon: 10 }, ['regularise/epsilon-too-large']],
    [{ epsilon: 0.05, visvalingamEpsilon: 10 }, ['regularise/epsilon-too-large']],
    [
      { radialPass: false, douglasPeuckerPass: false, visvalingamEpsilon: 10 },
      ['regularise/epsilon-too-large'],
    ],
    [{ epsilon: 0.3 }, []],
    [{}, []],
  ])('leave a valid ring and say so: %j', (given, codes) => {
    const small = asSlice(scanWalls({ walls: [closed(SMALL)], perMetre: 200, noise: 0.004, seed: 3 }));
    const context = listeningContext();
    const hull = findBoundary(small, optionsWith(), context);
    const { passes } = regulariseBoundary(hull, small, optionsWith(given), context);
    expect(context.warnings.map(({ code }) => code)).toEqual(codes);
    for (const { polygons } of passes) expectValidPolygons(polygons);
  });
});

describe('tolerances', () => {
  it("are the paper's in its preset and scale with the spacing in ours", () => {
    const paper = tolerancesFor(slice, optionsWith({ preset: 'paper' }));
    expect(paper.epsilon).toBeCloseTo(0.024, 12);
    expect(paper.areaEpsilon).toBeCloseTo(0.2 / 100 ** 2, 12);
    const sparse = tolerancesFor({ ...slice, spacing: 0.1 }, optionsWith());
    expect(sparse.epsilon).toBeGreaterThan(tolerancesFor(slice, optionsWith()).epsilon);
    expect(sparse.areaEpsilon).toBeCloseTo(sparse.epsilon ** 2, 12);
  });

  it('name the passes in the order of the paper', () => {
    expect(passesOf(optionsWith({ radialPass: false }))).toEqual(['douglas-peucker', 'visvalingam']);
  });
});
