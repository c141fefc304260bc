import fc from 'fast-check';
import type { Manifold, ManifoldToplevel } from 'manifold-3d';
import { expect, test } from 'vitest';
import { areaOf } from '../../src/core/geometry/areas.ts';
import { polygonArea } from '../../src/core/geometry/rings.ts';
import type { Opening, Operation, Ring, SecondaryBoundary, Storey } from '../../src/core/types.ts';
import { checkSolid } from '../../src/solid/check-solid.ts';
import { extrude } from '../../src/solid/extrude.ts';
import { makeSolid } from '../../src/solid/make-solid.ts';
import { openingBoxes } from '../../src/solid/opening-boxes.ts';
import { wallSection } from '../../src/solid/sections.ts';
import { polygonProblems } from '../invariants.ts';
import { manifoldKernel, oraclePrism, readGroup } from '../unit/solid/manifold-oracle.ts';
import { disc, planOf, rectangle, ring, rotated, secondary, wallAround } from '../unit/solid/plans.ts';

const SEED = 2019;
/** The grid of the Booleans moves a vertex by half a micrometre; times tens of metres of wall, times its height. */
const VOLUME_DIGITS = 3;

const SHAPES: readonly Ring[] = [
  ring(0, 0, 8, 0, 8, 4, 5, 4, 5, 9, 0, 9),
  ring(0, 0, 9, 0, 9, 3, 6, 3, 6, 8, 3, 8, 3, 3, 0, 3),
  ring(0, 0, 10, 0, 10, 8, 7, 8, 7, 3, 3, 3, 3, 8, 0, 8),
];

/** Decimetres, so that edges often lie on each other, which is what breaks Booleans. */
const decimetres = (min: number, max: number) =>
  fc.integer({ min: 10 * min, max: 10 * max }).map((value) => value / 10);
const operation = fc.constantFrom<Operation[]>('subtract', 'add', 'independent');
const square = fc
  .tuple(decimetres(0, 9), decimetres(0, 9), decimetres(0.1, 2), decimetres(0.1, 2))
  .map(([x, y, width, depth]) => rectangle(x, y, width, depth));
const round = fc
  .tuple(decimetres(0, 9), decimetres(0, 9), decimetres(0.2, 1.5), fc.integer({ min: 3, max: 24 }))
  .map(([x, y, radius, sides]) => disc(x, y, radius, sides, 0.1));

const storey = fc
  .record({
    shape: fc.constantFrom(...SHAPES),
    angle: fc.constantFrom(0, 0, 0.3, 1.234, 2),
    thickness: fc.constantFrom(0.1, 0.2, 0.37),
    structures: fc.array(fc.tuple(fc.oneof(square, round), operation), { maxLength: 5 }),
  })
  .map(({ shape, angle, thickness, structures }) => {
    const inner = rotated(shape, angle);
    return {
      primary: [{ outer: inner, holes: [] }],
      walls: [{ outline: wallAround(inner, thickness), thickness, confidence: 1 }],
      secondary: structures.map(([outer, what]): SecondaryBoundary => secondary(rotated(outer, angle), what)),
    } satisfies Partial<Storey>;
  });

/** Volume of walls and structures, 2.5 m high, as another kernel finds it. */
function volumeWith(
  kernel: ManifoldToplevel,
  walls: Manifold,
  structures: readonly SecondaryBoundary[],
): number {
  let [joined, independent] = [walls, 0];
  for (const { outline, operation } of structures) {
    const prism = oraclePrism(kernel, outline, [0, 2.5]);
    if (operation === 'add') joined = joined.add(prism);
    else if (operation === 'subtract') joined = joined.subtract(prism);
    else independent += prism.volume();
  }
  return joined.volume() + independent;
}

test('every solid is closed, and another kernel finds the same volume for every group and for the whole', async () => {
  const kernel = await manifoldKernel();
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts], options: { floorSlab: false } });
      const solid = await makeSolid(plan, plan.options);
      const check = checkSolid(solid);
      expect(check.openEdges).toBe(0);
      const oracle = oraclePrism(kernel, facts.walls[0].outline, [0, 2.5]);
      expect(check.volume).toBeCloseTo(volumeWith(kernel, oracle, facts.secondary), VOLUME_DIGITS);
      const groups = solid.groups.map((_, i) => readGroup(kernel, solid, i).volume());
      expect(groups.reduce((sum, volume) => sum + volume, 0)).toBeCloseTo(check.volume, VOLUME_DIGITS);
    }),
    { seed: SEED, numRuns: 150 },
  );
});

test('slabs and walls are closed and face outwards, whatever stands in the room', async () => {
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts], options: { ceilingSlab: true } });
      expect(checkSolid(await makeSolid(plan, plan.options))).toMatchObject({
        watertight: true,
        openEdges: 0,
      });
    }),
    { seed: SEED, numRuns: 300 },
  );
});

test('sections are valid, and V vertices and h holes give 4V + 4h − 4 triangles', () => {
  fc.assert(
    fc.property(storey, (facts) => {
      const sections = wallSection(planOf({ storeys: [facts] }).storeys[0]);
      for (const section of sections) {
        expect(polygonProblems(section)).toEqual([]);
        const vertices = [section.outer, ...section.holes].reduce((sum, each) => sum + each.length / 2, 0);
        const { indices } = extrude(section, 0, 1);
        expect(indices.length / 3).toBe(4 * vertices + 4 * section.holes.length - 4);
      }
    }),
    { seed: SEED, numRuns: 300 },
  );
});

test('the volume of each wall is the area of its section × height', async () => {
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts], options: { floorSlab: false } });
      const solid = await makeSolid(plan, plan.options);
      const sections = wallSection(plan.storeys[0]);
      const walls = solid.groups.filter(({ kind }) => kind === 'wall');
      expect(walls.length).toBe(sections.length);
      for (const [i, group] of walls.entries()) {
        const { volume } = checkSolid({ ...solid, groups: [group] });
        expect(Math.abs(volume / (polygonArea(sections[i]) * 2.5) - 1)).toBeLessThan(1e-9);
      }
    }),
    { seed: SEED, numRuns: 300 },
  );
});

interface OpeningWish {
  readonly edge: number;
  readonly at: number;
  readonly width: number;
  readonly sill: number;
  readonly rise: number;
}
const door = fc.record({ sill: fc.constant<number>(0), rise: decimetres(1.2, 3) });
const window = fc.record({ sill: decimetres(0.2, 1.2), rise: decimetres(0.3, 1.2) });
const wishes = (kind: fc.Arbitrary<{ sill: number; rise: number }>) =>
  fc.array(
    fc
      .tuple(fc.nat(7), fc.constantFrom(0, 0.1, 0.25, 0.5, 0.618, 0.9), decimetres(0.1, 1.5), kind)
      .map(([edge, at, width, heights]): OpeningWish => ({ edge, at, width, ...heights })),
    { minLength: 1, maxLength: 4 },
  );

/** Openings on edges of the inner face, the axis in the middle of the wall. */
function openingsOf(inner: Ring, thickness: number, wanted: readonly OpeningWish[]): Opening[] {
  return wanted.map(({ edge, at, width, sill, rise }) => {
    const i = (2 * edge) % inner.length;
    const j = (i + 2) % inner.length;
    const [dx, dy] = [inner[j] - inner[i], inner[j + 1] - inner[i + 1]];
    const length = Math.hypot(dx, dy);
    const place = (along: number) =>
      [
        inner[i] + (along * dx + (thickness / 2) * dy) / length,
        inner[i + 1] + (along * dy - (thickness / 2) * dx) / length,
      ] as const;
    const start = at * Math.max(0, length - width);
    return {
      type: 'door',
      from: place(start),
      to: place(start + width),
      sill,
      head: sill + rise,
      confidence: 1,
    };
  });
}

const pierced = (kind: typeof door) =>
  fc.tuple(storey, wishes(kind)).map(
    ([facts, wanted]) =>
      ({
        ...facts,
        openings: openingsOf(facts.primary[0].outer, facts.walls[0].thickness, wanted),
      }) satisfies Partial<Storey>,
  );

test('doors and windows leave every solid closed, with the volume another kernel finds', async () => {
  const kernel = await manifoldKernel();
  await fc.assert(
    fc.asyncProperty(fc.oneof(pierced(door), pierced(window)), async (facts) => {
      const plan = planOf({ storeys: [facts], options: { floorSlab: false } });
      const solid = await makeSolid(plan, plan.options);
      const check = checkSolid(solid);
      expect(check).toMatchObject({ openEdges: 0, watertight: true });
      let oracle = oraclePrism(kernel, facts.walls[0].outline, [0, 2.5]);
      for (const { base, low, high } of openingBoxes(plan.storeys[0])) {
        oracle = oracle.subtract(oraclePrism(kernel, base, [low, high]));
      }
      expect(check.volume).toBeCloseTo(volumeWith(kernel, oracle, facts.secondary), VOLUME_DIGITS);
    }),
    { seed: SEED, numRuns: 300 },
  );
});

test('the volume of walls with doors is that of their sections, height by height', async () => {
  await fc.assert(
    fc.asyncProperty(pierced(door), async (facts) => {
      const openings = facts.openings.map((opening) => ({ ...opening, head: 2 }));
      const plan = planOf({ storeys: [{ ...facts, openings }], options: { floorSlab: false } });
      const solid = await makeSolid(plan, plan.options);
      const groups = solid.groups.filter(({ kind }) => kind === 'wall');
      const [below] = plan.storeys;
      const [open, whole] = [below, { ...below, openings: [] }].map((each) => areaOf(wallSection(each)));
      const { volume } = checkSolid({ ...solid, groups });
      expect(Math.abs(volume / (open * 2 + whole * 0.5) - 1)).toBeLessThan(1e-6);
    }),
    { seed: SEED, numRuns: 200 },
  );
});

test('the BSP engine agrees with the exact one, closed as well', async () => {
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts] });
      const exact = checkSolid(await makeSolid(plan, plan.options));
      const bsp = checkSolid(await makeSolid(plan, { ...plan.options, csg: 'bsp' }));
      expect(bsp.openEdges).toBe(0);
      expect(Math.abs(bsp.volume / exact.volume - 1)).toBeLessThan(1e-6);
    }),
    { seed: SEED, numRuns: 150 },
  );
});

test('the BSP engine cuts doors as the exact one does, but for what parts walls that touch', async () => {
  await fc.assert(
    fc.asyncProperty(pierced(door), async (facts) => {
      const plan = planOf({ storeys: [facts], options: { floorSlab: false } });
      const exact = checkSolid(await makeSolid(plan, plan.options));
      const bsp = checkSolid(await makeSolid(plan, { ...plan.options, csg: 'bsp' }));
      expect(bsp.openEdges).toBe(0);
      expect(Math.abs(bsp.volume / exact.volume - 1)).toBeLessThan(1e-5);
    }),
    { seed: SEED, numRuns: 150 },
  );
});
