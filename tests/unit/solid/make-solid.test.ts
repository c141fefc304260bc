import { expect, test } from 'vitest';
import { FloorPlanError } from '../../../src/core/errors.ts';
import type { Opening, Warning } from '../../../src/core/types.ts';
import { checkSolid } from '../../../src/solid/check-solid.ts';
import { makeSolid } from '../../../src/solid/make-solid.ts';
import { disc, type PlanFacts, planOf, rectangle, reversed, ring, secondary, wallAround } from './plans.ts';

const ROOM = rectangle(0, 0, 4, 3);
const NO_SLABS = { floorSlab: false } as const;

async function solidOf(facts: PlanFacts) {
  const plan = planOf(facts);
  const solid = await makeSolid(plan, plan.options);
  return { solid, check: checkSolid(solid), names: solid.groups.map(({ name }) => name) };
}

test('a room is a wall and a floor of known volume and the fewest triangles', async () => {
  const { solid, check, names } = await solidOf({});
  expect(names).toEqual(['wall-0', 'floor-0']);
  const wallArea = 4.4 * 3.4 - 4 * 3;
  expect(check.watertight).toBe(true);
  expect(check.volume).toBeCloseTo(wallArea * 2.5 + 4.4 * 3.4 * 0.1, 9);
  // 8 vertices and a hole: 4 · 8 + 4 · 1 − 4; 4 vertices: 4 · 4 − 4.
  expect(solid.groups.map(({ count }) => count / 3)).toEqual([32, 12]);
  expect(solid.positions.length / 3).toBe(2 * 8 + 2 * 4);
});

test("the floor lies under the storey, the ceiling over it, at the plan's heights", async () => {
  const { solid } = await solidOf({
    storeys: [{ floor: 7, height: 3 }],
    options: { ceilingSlab: true, slabThickness: 0.25 },
  });
  const heights = solid.groups.map(({ name, start, count }) => {
    const z = [...solid.indices.subarray(start, start + count)].map(
      (vertex) => solid.positions[3 * vertex + 2],
    );
    return [name, Math.min(...z), Math.max(...z)];
  });
  expect(heights).toEqual([
    ['wall-0', 7, 10],
    ['floor-0', 6.75, 7],
    ['ceiling-0', 10, 10.25],
  ]);
});

test('a subtracted structure cuts walls and slabs', async () => {
  const shaft = secondary(rectangle(3.5, 1, 1, 1), 'subtract');
  const { check, names } = await solidOf({ storeys: [{ secondary: [shaft] }] });
  const lostWall = 0.2 * 1;
  const lostFloor = 0.7 * 1;
  const whole = (4.4 * 3.4 - 12) * 2.5 + 4.4 * 3.4 * 0.1;
  // The shaft pokes 0.1 m out of the outer face, so the wall is cut through.
  expect(check.volume).toBeCloseTo(whole - lostWall * 2.5 - lostFloor * 0.1, 9);
  expect(check.watertight).toBe(true);
  expect(names).toEqual(['wall-0', 'floor-0']);
});

test('an added structure joins the walls it touches and stands alone where it does not', async () => {
  const pilaster = secondary(rectangle(3.5, 1, 0.6, 1), 'add');
  const pillar = secondary(rectangle(1, 1, 0.5, 0.5), 'add');
  const { check, names } = await solidOf({ storeys: [{ secondary: [pilaster, pillar] }], options: NO_SLABS });
  expect(check.volume).toBeCloseTo((4.4 * 3.4 - 12 + 0.5 * 1 + 0.25) * 2.5, 9);
  expect(names).toEqual(['wall-0', 'wall-1']);
  expect(check.watertight).toBe(true);
});

test('an independent structure is a solid of its own and leaves the walls alone', async () => {
  const cubicle = secondary(rectangle(3.5, 1, 0.6, 1), 'independent');
  const { solid, check } = await solidOf({ storeys: [{ secondary: [cubicle] }], options: NO_SLABS });
  expect(solid.groups.map(({ kind }) => kind)).toEqual(['wall', 'secondary']);
  expect(check.volume).toBeCloseTo((4.4 * 3.4 - 12 + 0.6) * 2.5, 9);
});

test('structures act in their order', async () => {
  const carve = secondary(rectangle(1, 1, 1, 1), 'subtract');
  const fill = secondary(rectangle(1, 1, 1, 1), 'add');
  const filled = await solidOf({ storeys: [{ secondary: [carve, fill] }], options: NO_SLABS });
  const carved = await solidOf({ storeys: [{ secondary: [fill, carve] }], options: NO_SLABS });
  expect(filled.check.volume - carved.check.volume).toBeCloseTo(2.5, 9);
});

test('a hollow structure keeps its hollow', async () => {
  const hollow = secondary(rectangle(1, 1, 1, 1), 'independent', [reversed(rectangle(1.2, 1.2, 0.6, 0.6))]);
  const { check } = await solidOf({ storeys: [{ walls: [], primary: [], secondary: [hollow] }] });
  expect(check.volume).toBeCloseTo((1 - 0.36) * 2.5, 9);
});

test('a courtyard stays open in the slab', async () => {
  const court = reversed(rectangle(1, 1, 1, 1));
  const plan = { storeys: [{ walls: [], primary: [{ outer: ROOM, holes: [court] }] }] };
  const { check } = await solidOf(plan);
  expect(check.volume).toBeCloseTo((12 - 1) * 0.1, 6);
});

test('needless vertices go', async () => {
  const outer = ring(0, 0, 2, 0, 4, 0, 4, 3, 3, 3, 1, 3, 0, 3);
  const { solid } = await solidOf({
    storeys: [{ primary: [], walls: [{ outline: { outer, holes: [] }, thickness: 1, confidence: 1 }] }],
    options: NO_SLABS,
  });
  expect(solid.indices.length / 3).toBe(12);
});

test('walls that meet in one point stay closed', async () => {
  const walls = [rectangle(0, 0, 1, 1), rectangle(1, 1, 1, 1), rectangle(0, 2, 1, 1), rectangle(-1, 1, 1, 1)];
  const { check } = await solidOf({
    storeys: [
      { walls: walls.map((outer) => ({ outline: { outer, holes: [] }, thickness: 1, confidence: 1 })) },
    ],
  });
  expect(check).toMatchObject({ watertight: true, openEdges: 0 });
});

test('groups are numbered through all storeys', async () => {
  const { solid, names } = await solidOf({ storeys: [{}, {}] });
  expect(names).toEqual(['wall-0', 'floor-0', 'wall-1', 'floor-1']);
  expect(solid.groups.map(({ storey }) => storey)).toEqual([0, 0, 1, 1]);
  expect(new Set(names).size).toBe(names.length);
});

test('a plan without walls and slabs is an empty solid', async () => {
  const { check } = await solidOf({ storeys: [{ walls: [], primary: [] }] });
  expect(check).toEqual({ watertight: false, volume: 0, area: 0, openEdges: 0 });
});

test('a storey without height is refused', async () => {
  const plan = planOf({ storeys: [{ height: 0 }] });
  const failure = await makeSolid(plan, plan.options).catch((error: unknown) => error);
  expect(failure).toBeInstanceOf(FloorPlanError);
  expect(failure).toMatchObject({ code: 'input/degenerate', detail: { storey: 0 } });
});

const door = (from: Opening['from'], to: Opening['to'], { sill = 0, head = 2 } = {}): Opening => ({
  ...{ type: 'door', from, to, sill, head, confidence: 1 },
});

test('a door is cut out of its wall under a lintel, in one closed shell without faces inside', async () => {
  const openings = [door([1, -0.1], [1.9, -0.1])];
  const { solid, check, names } = await solidOf({ storeys: [{ openings }], options: NO_SLABS });
  expect(names).toEqual(['wall-0']);
  expect(check.watertight).toBe(true);
  const [wallArea, wallFaces] = [4.4 * 3.4 - 12, (2 * 4.4 + 2 * 3.4 + 14) * 2.5];
  expect(check.volume).toBeCloseTo(wallArea * 2.5 - 0.9 * 0.2 * 2, 9);
  // Two jambs and the lintel's underside come, both faces of the door and its sill go.
  expect(check.area).toBeCloseTo(wallFaces + 2 * wallArea + 2 * 2 * 0.2 - 2 * 0.9 * 2, 9);
  // 8 + 4 vertices at the sections, and what the level at the head adds.
  expect(solid.indices.length / 3).toBeLessThanOrEqual(60);
});

test('a door as high as its wall parts it', async () => {
  const openings = [door([1, -0.1], [1.9, -0.1], { head: 2.5 }), door([1, 3.1], [1.9, 3.1], { head: 2.5 })];
  const { check, names } = await solidOf({ storeys: [{ openings }], options: NO_SLABS });
  expect(names).toEqual(['wall-0', 'wall-1']);
  expect(check).toMatchObject({ watertight: true, openEdges: 0 });
  expect(check.volume).toBeCloseTo((4.4 * 3.4 - 12 - 2 * 0.9 * 0.2) * 2.5, 9);
});

test('doors side by side, over each other and of two heights, and a window, stay one closed shell', async () => {
  const openings = [
    door([0.5, -0.1], [1.4, -0.1]),
    door([1.4, -0.1], [2, -0.1], { head: 2.2 }),
    door([1.8, -0.1], [2.5, -0.1], { head: 1.7 }),
    door([4.1, 1], [4.1, 2], { sill: 0.9, head: 2.1 }),
  ];
  const { check, names } = await solidOf({ storeys: [{ floor: 5, openings }], options: NO_SLABS });
  expect(names).toEqual(['wall-0']);
  expect(check.watertight).toBe(true);
  const cut = 0.9 * 2 + 0.6 * 2.2 + 0.5 * 1.7 + 1 * 1.2;
  expect(check.volume).toBeCloseTo((4.4 * 3.4 - 12) * 2.5 - cut * 0.2, 9);
});

test('where openings meet corner to corner the layers there part; the rest stays one shell', async () => {
  const corner = [door([1, -0.1], [1.9, -0.1]), door([1.9, -0.1], [2.8, -0.1], { sill: 2, head: 2.3 })];
  const elsewhere = [
    door([1, 3.1], [1.9, 3.1], { head: 2.1 }),
    door([4.1, 1], [4.1, 2], { sill: 0.9, head: 2.2 }),
  ];
  const { check, names } = await solidOf({
    storeys: [{ openings: [...corner, ...elsewhere] }],
    options: NO_SLABS,
  });
  expect(check).toMatchObject({ watertight: true, openEdges: 0 });
  const cut = 0.9 * 2 + 0.9 * 0.3 + 0.9 * 2.1 + 1 * 1.3;
  expect(check.volume).toBeCloseTo((4.4 * 3.4 - 12) * 2.5 - cut * 0.2, 6);
  // The wall around, and about the corner: beside the door, between head and upper sill, over both.
  expect(names.length).toBeLessThanOrEqual(4);
});

test('an added structure stands in a door; the wall of the next room and openings off every wall are let alone', async () => {
  const pilaster = secondary(rectangle(1.2, -0.2, 0.3, 0.6), 'add');
  const next = wallAround(rectangle(0, -3.3, 4, 3), 0.1);
  const plan = {
    storeys: [
      {
        secondary: [pilaster],
        walls: [
          { outline: wallAround(ROOM, 0.1), thickness: 0.1, confidence: 1 },
          { outline: next, thickness: 0.1, confidence: 1 },
        ],
        openings: [door([1, -0.05], [1.9, -0.05]), door([1, 1.5], [1.9, 1.5])],
      },
    ],
    options: NO_SLABS,
  };
  const { check } = await solidOf(plan);
  expect(check.watertight).toBe(true);
  const walls = 2 * (4.2 * 3.2 - 12);
  // The pilaster reaches through the wall up to the next, which it touches.
  const pillar = 0.3 * 0.6 - 0.3 * 0.1;
  expect(check.volume).toBeCloseTo((walls + pillar) * 2.5 - 0.6 * 0.1 * 2, 4);
});

test("the paper's engine makes the same volume with more triangles", async () => {
  const inner = ring(0, 0, 8, 0, 8, 4, 5, 4, 5, 9, 0, 9);
  const storeys = [
    {
      primary: [{ outer: inner, holes: [] }],
      walls: [{ outline: wallAround(inner, 0.3), thickness: 0.3, confidence: 1 }],
      secondary: [
        secondary(disc(2, 2, 0.8, 24), 'subtract'),
        secondary(rectangle(4.5, 5, 1, 1), 'subtract'),
        secondary(disc(2, 6, 0.4, 12), 'add'),
        secondary(rectangle(-0.2, 3, 0.6, 0.6), 'add'),
      ],
    },
  ];
  const plan = planOf({ storeys });
  const warnings: Warning[] = [];
  const exact = await makeSolid(plan, plan.options);
  const bsp = await makeSolid(plan, { ...plan.options, csg: 'bsp' }, (warning) => warnings.push(warning));
  const [a, b] = [checkSolid(exact), checkSolid(bsp)];
  expect(warnings).toEqual([]);
  expect(b.watertight).toBe(true);
  expect(b.volume).toBeCloseTo(a.volume, 4);
  expect(bsp.indices.length).toBeGreaterThan(exact.indices.length);
  expect(bsp.groups.map(({ name }) => name).sort()).toEqual(exact.groups.map(({ name }) => name).sort());
});

test('equal plans give equal bytes', async () => {
  const facts = { storeys: [{ secondary: [secondary(disc(2, 1.5, 0.5, 17), 'subtract')] }] } as const;
  expect((await solidOf(facts)).solid).toEqual((await solidOf(facts)).solid);
});
