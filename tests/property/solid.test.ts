import fc from 'fast-check';
import { expect, test } from 'vitest';
import type { Operation, Ring, SecondaryBoundary, Storey } from '../../src/core/types.ts';
import { checkSolid } from '../../src/solid/check-solid.ts';
import { extrude } from '../../src/solid/extrude.ts';
import { makeSolid } from '../../src/solid/make-solid.ts';
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

test('every solid is closed, and another kernel finds the same volume for every group and for the whole', async () => {
  const kernel = await manifoldKernel();
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts], options: { floorSlab: false } });
      const solid = await makeSolid(plan, plan.options);
      const check = checkSolid(solid);
      expect(check.openEdges).toBe(0);
      let oracle = oraclePrism(kernel, facts.walls[0].outline, [0, 2.5]);
      let independent = 0;
      for (const { outline, operation } of facts.secondary) {
        const prism = oraclePrism(kernel, outline, [0, 2.5]);
        if (operation === 'add') oracle = oracle.add(prism);
        else if (operation === 'subtract') oracle = oracle.subtract(prism);
        else independent += prism.volume();
      }
      expect(check.volume).toBeCloseTo(oracle.volume() + independent, VOLUME_DIGITS);
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

test('the BSP engine agrees with the exact one, closed as well', async () => {
  await fc.assert(
    fc.asyncProperty(storey, async (facts) => {
      const plan = planOf({ storeys: [facts] });
      const exact = checkSolid(await makeSolid(plan, plan.options));
      const bsp = checkSolid(await makeSolid(plan, { ...plan.options, csg: 'bsp' }));
      expect(bsp.openEdges).toBe(0);
      expect(bsp.volume).toBeCloseTo(exact.volume, 2);
    }),
    { seed: SEED, numRuns: 80 },
  );
});
