import { describe, expect, test } from 'vitest';
import { polygonArea } from '../../../src/core/geometry/rings.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { makePlan, type PlanParts } from '../../../src/core/plan.ts';
import { strokeContour } from '../../../src/core/plan-walls.ts';
import { createRandom } from '../../../src/core/random.ts';
import type { Gap, PointCloud, Polygon, Ring } from '../../../src/core/types.ts';
import { expectValidPolygon, expectValidPolygons } from '../../invariants.ts';
import { codesOf, everyIndex, listen, makeCloud } from './made-scan.ts';

const ring = (...coordinates: number[]): Ring => Float64Array.from(coordinates);
const RECTANGLE: Polygon = { outer: ring(0.1, 0.2, 6.1, 0.2, 6.1, 4.2, 0.1, 4.2), holes: [] };
const OUTSIDE = { outside: 0.2, inside: 0 };

describe('strokeContour', () => {
  test('lies outside the inner face, whose corners keep their coordinates', () => {
    const [wall, ...rest] = strokeContour(RECTANGLE, OUTSIDE);
    expect(rest).toEqual([]);
    expectValidPolygon(wall);
    expect(polygonArea(wall)).toBeCloseTo(6.4 * 4.4 - 6 * 4, 6);
    expect(corners(wall.holes[0])).toEqual(corners(RECTANGLE.outer));
  });

  test('is centred as a canvas stroke is', () => {
    const [wall] = strokeContour(RECTANGLE, { outside: 0.1, inside: 0.1 });
    expect(polygonArea(wall)).toBeCloseTo(6.2 * 4.2 - 5.8 * 3.8, 6);
  });

  test('keeps a tenth of a millimetre far from the origin', () => {
    const [dx, dy] = [691_234.567, 5_334_567.891];
    const far = { outer: RECTANGLE.outer.map((value, i) => value + (i % 2 === 0 ? dx : dy)), holes: [] };
    const [wall] = strokeContour(far, OUTSIDE);
    const xs = wall.outer.filter((_, i) => i % 2 === 0);
    expect(Math.min(...xs)).toBeCloseTo(dx - 0.1, 6);
    expect(Math.max(...xs)).toBeCloseTo(dx + 6.3, 6);
    expect(corners(wall.holes[0])).toEqual(corners(far.outer));
  });

  test('walls a courtyard too', () => {
    const courtyard = ring(2, 1.2, 2, 3.2, 4, 3.2, 4, 1.2);
    const walls = strokeContour({ ...RECTANGLE, holes: [courtyard] }, OUTSIDE);
    expectValidPolygons(walls);
    expect(walls.length).toBe(2);
    expect(polygonArea(walls[1])).toBeCloseTo(4 - 1.6 ** 2, 6);
  });

  test('fills a courtyard narrower than two walls', () => {
    const shaft = ring(2, 1.2, 2, 1.5, 2.3, 1.5, 2.3, 1.2);
    const walls = strokeContour({ ...RECTANGLE, holes: [shaft] }, OUTSIDE);
    expect(walls[1].holes).toEqual([]);
    expect(polygonArea(walls[1])).toBeCloseTo(0.09, 6);
  });

  test('squares a needle instead of drawing it out', () => {
    const [wall] = strokeContour({ outer: ring(0, 0, 10, 0, 0, 0.5), holes: [] }, OUTSIDE);
    expectValidPolygon(wall);
    expect(Math.max(...wall.outer)).toBeLessThan(10.5);
  });

  test('stays valid around rings of every shape', () => {
    for (let seed = 0; seed < 150; seed++) {
      const random = createRandom(seed);
      const polygon = { outer: starRing(random), holes: [] };
      const thickness = 0.05 + random();
      const walls = strokeContour(polygon, { outside: thickness, inside: 0 });
      for (const wall of walls) expectValidPolygon(wall, `seed ${seed}`);
      const area = walls.reduce((sum, wall) => sum + polygonArea(wall), 0);
      expect(area).toBeGreaterThan(0.5 * thickness * 4);
    }
  });
});

/** A plan around one polygon. */
function planAround(
  polygon: Polygon,
  given: Parameters<typeof resolveOptions>[0],
  { cloud = makeCloud([0, 0, 0, 1, 1, 2.5]), gaps = [] }: { cloud?: PointCloud; gaps?: readonly Gap[] } = {},
) {
  const { context, warnings } = listen();
  const parts: PlanParts = {
    source: { name: 'a', format: 'ply', bytes: 1, pointsRead: 1, pointsDropped: 0, pointsKept: 1 },
    cloud,
    kept: everyIndex(cloud),
    boundary: { method: 'gift-opening', polygons: [polygon], openingLength: 1, gaps },
    regularised: { passes: [], polygons: [polygon] },
    secondary: { clusters: new Uint8Array(0), searches: [], boundaries: [] },
    building: [],
    options: resolveOptions(given),
  };
  const plan = makePlan(parts, context);
  return { plan, storey: plan.storeys[0], codes: codesOf(warnings), warnings };
}

describe('makePlan', () => {
  const points: number[] = [];
  for (const x of [0.1, 6.1]) for (const y of [0.2, 4.2]) for (const z of [1, 2, 3.5]) points.push(x, y, z);

  function run(extra: Partial<PointCloud>, given: Parameters<typeof resolveOptions>[0] = {}, gapWidth = 0) {
    const gap = { from: [0.1, 0.2], to: [0.1 + gapWidth, 0.2], width: gapWidth } as const;
    const cloud = makeCloud(points, extra);
    return planAround(RECTANGLE, given, { cloud, gaps: gapWidth > 0 ? [gap] : [] });
  }

  test('doors are openings of the storey, no higher than its walls', () => {
    const { storey, codes } = run({ floor: 0, ceiling: 3 }, { wallHeight: 1.9, doors: 'gaps;6.1,2,0.8' }, 1);
    expect(storey.openings.map(({ from, to }) => Math.hypot(to[0] - from[0], to[1] - from[1]))).toEqual([
      expect.closeTo(1, 9),
      expect.closeTo(0.8, 9),
    ]);
    expect(storey.openings.map(({ head }) => head)).toEqual([1.9, 1.9]);
    expect(storey.openings.map(({ confidence }) => confidence)).toEqual([storey.walls[0].confidence, 1]);
    expect(codes).toEqual([]);
  });

  test('stands from floor to ceiling', () => {
    const { storey, codes, plan } = run({ floor: 1, ceiling: 3.4 });
    expect(storey.floor).toBe(1);
    expect(storey.height).toBeCloseTo(2.4, 9);
    expect(storey.primary).toEqual([RECTANGLE]);
    expect(plan.storeys.length).toBe(1);
    expect(codes).toEqual([]);
  });

  test('takes the given height', () => {
    expect(run({ floor: 1, ceiling: 3.4 }, { wallHeight: 2 }).storey.height).toBe(2);
  });

  test('takes the highest point where there is no ceiling, and says so', () => {
    const { storey, codes } = run({ floor: 1 });
    expect(storey.height).toBeCloseTo(2.5, 6);
    expect(codes).toEqual(['plan/height-assumed']);
  });

  test('assumes a height for a slice, and says so, unless it is given', () => {
    expect(run({ isFlat: true }).codes).toEqual(['plan/height-assumed']);
    expect(run({ isFlat: true }).storey.height).toBe(2.5);
    expect(run({ isFlat: true }, { wallHeight: 3 }).codes).toEqual([]);
  });

  test.each([
    [4.6, 0.02, 'set another level'],
    [0.3, 0.02, 'set the unit'],
    [4.6, 0.8, undefined],
  ])('in a scan of %f m an outline of %f m is a room, or says what to try', (extent, side, hint) => {
    const cloud = makeCloud([0, 0, 0, extent, extent, 0.2], { floor: 0, ceiling: 0.2 });
    const outer = ring(0, 0, side, 0, side, side, 0, side);
    const { codes, warnings } = planAround({ outer, holes: [] }, {}, { cloud });
    expect(codes).toEqual(hint ? ['plan/no-room'] : []);
    expect(warnings[0]?.hint).toEqual(hint && expect.stringContaining(hint));
  });

  test('walls have the thickness, side and confidence', () => {
    const { storey } = run({ floor: 0, ceiling: 3 }, { wallThickness: 0.3 }, 5);
    expect(storey.walls.length).toBe(1);
    expect(storey.walls[0].thickness).toBe(0.3);
    expect(storey.walls[0].confidence).toBeCloseTo(1 - 5 / 20, 9);
    expect(polygonArea(storey.walls[0].outline)).toBeCloseTo(6.6 * 4.6 - 24, 6);
    const centred = run({ floor: 0, ceiling: 3 }, { wallSide: 'centre' }).storey.walls[0];
    expect(polygonArea(centred.outline)).toBeCloseTo(6.2 * 4.2 - 5.8 * 3.8, 6);
  });
});

describe('walls of any thickness', () => {
  const courtyard = ring(2, 1.2, 2, 3.2, 4, 3.2, 4, 1.2);
  const outlines = {
    rectangle: RECTANGLE,
    courtyard: { ...RECTANGLE, holes: [courtyard] },
    ell: { outer: ring(0, 0, 6, 0, 6, 2, 3, 2, 3, 4, 0, 4), holes: [] },
  };
  const widths = [0.01, 0.2, 0.999, 1, 2, 3.9, 4, 4.1, 5];
  const cases = Object.keys(outlines).flatMap((name) =>
    widths.flatMap((width) =>
      (['outside', 'centre'] as const).map((side) => [name as keyof typeof outlines, width, side] as const),
    ),
  );

  test.each(cases)('%s, %f m, %s: valid, and told where no room is left', (name, wallThickness, wallSide) => {
    const { storey, codes } = planAround(outlines[name], { wallThickness, wallSide, wallHeight: 2.5 });
    expectValidPolygons(storey.walls.map(({ outline }) => outline));
    const pen = wallSide === 'centre' ? wallThickness / 2 : 0;
    // Half the width of the widest place.
    const clear = { rectangle: 2, courtyard: 1.05, ell: 1.5 }[name];
    expect(codes).toEqual(pen >= clear ? ['plan/walls-fill-room'] : []);
  });
});

function corners(source: Ring): string[] {
  const list: string[] = [];
  for (let i = 0; i < source.length; i += 2) list.push(`${source[i]} ${source[i + 1]}`);
  return list.sort();
}

/** A star-shaped ring of random radii: concave, sharp, always simple. */
function starRing(random: () => number): Ring {
  const vertices = 4 + Math.floor(random() * 20);
  const coordinates: number[] = [];
  for (let k = 0; k < vertices; k++) {
    const angle = (2 * Math.PI * (k + 0.8 * random())) / vertices;
    const radius = 1 + 4 * random();
    coordinates.push(radius * Math.cos(angle), radius * Math.sin(angle));
  }
  return Float64Array.from(coordinates);
}
