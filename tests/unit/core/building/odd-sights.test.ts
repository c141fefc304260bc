import { expect, it } from 'vitest';
import type { Building, Storey } from '../../../../fixtures/simulator/building.ts';
import { type SceneSpec, simulate, writePly } from '../../../../fixtures/simulator/index.ts';
import type { XY } from '../../../../fixtures/simulator/ring.ts';
import { sampleHome, sampleOffice } from '../../../../fixtures/simulator/sample-buildings.ts';
import {
  withGlassFront,
  withOutdoors,
  withPanes,
  withStairs,
} from '../../../../fixtures/simulator/surroundings.ts';
import { variedBuilding } from '../../../../fixtures/simulator/varied-buildings.ts';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { areaOf } from '../../../../src/core/geometry/areas.ts';
import { blobSource } from '../../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../../src/session/session.ts';
import { measurePlan } from '../../../accuracy/measure.ts';
import { RECIPES } from '../../../accuracy/recipes.ts';

const SCAN = { voxel: 0.03, noise: 0.008, mostRays: 400_000 };

async function measured(spec: SceneSpec) {
  const { positions, truth } = simulate({ ...spec, scan: { ...SCAN, ...spec.scan } });
  const session = new Session({ strokeTest: createStrokeTest() });
  const { plan } = await session.load(blobSource(new Blob([writePly({ positions })]), `${spec.name}.ply`));
  const [{ content }] = await session.write('geojson');
  const file = JSON.parse(typeof content === 'string' ? content : new TextDecoder().decode(content));
  return { plan, measures: measurePlan(file, truth) };
}

const changed = (building: Building, change: (storey: Storey) => Storey): Building => ({
  ...building,
  storeys: building.storeys.map(change),
});

function varied(name: string, seed: number): Building {
  const { sketch, variety } = RECIPES[name];
  return variedBuilding(name, seed, sketch, variety);
}

const glazed = (storey: Storey): Storey => withPanes(withOutdoors(storey));

it('windows are found through their glass, and no garden behind them is a room', async () => {
  const { measures } = await measured({ name: 'glazed', building: changed(varied('home', 503), glazed) });
  expect(measures).toMatchObject({ roomF1: 1, invalidCount: 0 });
  expect(measures.windowF1).toBeGreaterThan(0.85);
  expect(measures.doorF1).toBeGreaterThan(0.9);
  expect(measures.footprintIou).toBeGreaterThan(0.99);
});

it('ground seen through the windows of a furnished home is not its floor', async () => {
  const building = changed(varied('home-l-cupboards', 504), glazed);
  const { measures } = await measured({ name: 'cluttered', building });
  expect(measures.roomHeightErrorMm).toBeLessThan(30);
  expect(measures.roomF1).toBe(1);
  expect(measures.doorF1).toBeGreaterThan(0.9);
});

it('that ground does not tilt what is levelled', async () => {
  const building = changed(varied('home-l-cupboards', 604), glazed);
  const pose = { heading: 0.3, tilt: 0.1, tiltTowards: 1 };
  const { plan, measures } = await measured({ name: 'tilted', building, pose });
  expect(plan.frame.tilt).toBeCloseTo(pose.tilt, 3);
  expect(measures.roomF1).toBe(1);
  expect(measures.footprintIou).toBeGreaterThan(0.93);
});

it('rooms end at a glass front', async () => {
  const front = {
    kind: 'passage',
    from: [2, 3.6],
    to: [4.2, 3.6],
    sill: 0,
    head: 2.6,
    thickness: 0.1,
  } as const;
  const building = changed(sampleOffice(), (storey) => withGlassFront(withOutdoors(storey), front));
  const { measures } = await measured({ name: 'glass-front', building });
  expect(measures).toMatchObject({ roomF1: 1, invalidCount: 0 });
  expect(measures.footprintIou).toBeGreaterThan(0.99);
});

it('a room ends at a wall that is glass from floor to ceiling', async () => {
  const front = {
    kind: 'window',
    from: [13.33, 0.13],
    to: [13.33, 8.67],
    sill: 0,
    head: 2.9,
    thickness: 0.36,
  } as const;
  const building = changed(sampleOffice(), (storey) => {
    const openings = storey.openings.filter(({ from }) => from[0] < 13);
    return withGlassFront(withOutdoors({ ...storey, openings }), front);
  });
  const { plan, measures } = await measured({ name: 'glass-wall', building });
  expect(measures).toMatchObject({ roomF1: 1, invalidCount: 0 });
  expect(measures.footprintIou).toBeGreaterThan(0.98);
  const areas = plan.storeys[0].rooms.map(({ outline }) => areaOf([outline]));
  // The panes are in the middle of the wall.
  expect(Math.max(...areas)).toBeCloseTo(4.7 * 8.7 + 0.18 * 8.54, 0);
});

it('a room that nobody entered is not invented', async () => {
  const { measures } = await measured({
    name: 'unentered',
    building: varied('home', 515),
    scan: { unentered: [0] },
  });
  expect(measures.roomPrecision).toBe(1);
  expect(measures.roomRecall).toBeLessThan(1);
});

it('stairs lose no room, above or below', async () => {
  const [home] = sampleHome().storeys;
  const corner = ([x, y]: XY) => x < 3.4 && y > 3.2 && y < 4.7;
  const bare = { ...home, furniture: home.furniture.filter(({ ring }) => !ring.some(corner)) };
  const storeys = withStairs(bare, { ...bare, floor: home.height + 0.3 }, [0.1, 3.6, 2.9, 0.9]);
  const { measures } = await measured({ name: 'stairs', building: { name: 'stairs', storeys } });
  expect(measures).toMatchObject({ roomRecall: 1, invalidCount: 0 });
  expect(measures.footprintIou).toBeGreaterThan(0.99);
});

it('storeys with ducts between them are two', async () => {
  const [home] = sampleHome().storeys;
  const storeys = [home, { ...home, floor: home.height + 1.5 }];
  const { plan, measures } = await measured({ name: 'ducts', building: { name: 'ducts', storeys } });
  expect(plan.storeys).toHaveLength(2);
  expect(measures.roomF1).toBe(1);
});

it('a storey without walls, under a home, is left out and said to be', async () => {
  const [home] = sampleHome().storeys;
  const { positions } = simulate({
    name: 'carport',
    building: { name: 'carport', storeys: [{ ...home, floor: 3 }] },
    scan: SCAN,
  });
  const open: number[] = [];
  for (let x = 0; x < 10; x += 0.05) for (let y = 0; y < 9; y += 0.05) open.push(x, y, 0, x, y, 2.7);
  const all = Float64Array.from([...positions, ...open]);
  const session = new Session({ strokeTest: createStrokeTest() });
  const { plan } = await session.load(blobSource(new Blob([writePly({ positions: all })]), 'carport.ply'), {
    up: 'z',
  });
  expect(plan.storeys).toHaveLength(1);
  expect(plan.storeys[0].rooms).toHaveLength(6);
  expect(plan.warnings.map(({ code }) => code)).toContain('rooms/storey-left-out');
});
