import { beforeAll, describe, expect, it } from 'vitest';
import { type SceneSpec, simulate, writePly } from '../../../../fixtures/simulator/index.ts';
import {
  columnRoomBuilding,
  homeBuilding,
  roundHallBuilding,
} from '../../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../../src/cli/canvas-stroke.ts';
import { areaOf, combine } from '../../../../src/core/geometry/areas.ts';
import { ON_ARC } from '../../../../src/core/geometry/ring-arcs.ts';
import { isSimpleRing } from '../../../../src/core/geometry/simplicity.ts';
import { distanceToRing } from '../../../../src/core/secondary/structure.ts';
import type { FloorPlan, Polygon, Solid, Storey } from '../../../../src/core/types.ts';
import { blobSource } from '../../../../src/read/bytes/blob-source.ts';
import { Session } from '../../../../src/session/session.ts';
import { checkSolid } from '../../../../src/solid/check-solid.ts';
import { CORPUS } from '../../../accuracy/corpus.ts';
import { measurePlan } from '../../../accuracy/measure.ts';
import type { Measures } from '../../../accuracy/measures.ts';
import { polygonProblems } from '../../../invariants.ts';

const SCAN = { voxel: 0.05, raysPerStation: 60_000, stationsPerRoom: 2 };

interface Made {
  readonly plan: FloorPlan;
  readonly solid: Solid;
  readonly measures: Measures;
}

async function make(spec: SceneSpec): Promise<Made> {
  const { positions, truth } = simulate({ ...spec, scan: { ...SCAN, ...spec.scan } });
  const session = new Session({ strokeTest: createStrokeTest() });
  const result = await session.load(blobSource(new Blob([writePly({ positions })]), `${spec.name}.ply`));
  const [{ content }] = await session.write('geojson');
  const file = JSON.parse(typeof content === 'string' ? content : new TextDecoder().decode(content));
  return { plan: result.plan, solid: result.solid, measures: measurePlan(file, truth) };
}

const areasOf = ({ rooms }: Storey): Polygon[] => rooms.map(({ outline }) => outline);

describe('a furnished home', () => {
  let home: Made;
  beforeAll(async () => {
    home = await make({ name: 'home', building: homeBuilding(42, { shape: 'L' }), pose: { heading: 0.4 } });
  });

  it('has its rooms, to a centimetre', () => {
    expect(home.measures).toMatchObject({ roomF1: 1, valid: 1, invalidCount: 0 });
    expect(home.measures.roomAreaErrorPct).toBeLessThan(1);
    expect(home.measures.footprintIou).toBeGreaterThan(0.99);
    expect(home.measures.faceMedianMm).toBeLessThan(4);
  });

  it('has its doors and windows', () => {
    expect(home.measures.doorF1).toBeGreaterThan(0.85);
    expect(home.measures.windowF1).toBeGreaterThan(0.85);
    expect(home.measures.openingWidthErrorMm).toBeLessThan(30);
  });

  it('rooms, walls and outline do not overlap and leave nothing between them', () => {
    const [storey] = home.plan.storeys;
    const rooms = areasOf(storey);
    expect(areaOf(combine('union', rooms))).toBeCloseTo(areaOf(rooms), 3);
    const walls = storey.walls.map(({ outline }) => outline);
    expect(areaOf(combine('union', walls))).toBeCloseTo(areaOf(walls), 3);
    expect(areaOf(combine('intersection', rooms, walls))).toBeLessThan(1e-3);
    const rest = combine('difference', storey.primary, [...rooms, ...walls]);
    expect(areaOf(rest)).toBeLessThan(1e-2);
    for (const { outer, holes } of [...rooms, ...walls, ...storey.primary]) {
      for (const ring of [outer, ...holes]) expect(isSimpleRing(ring)).toBe(true);
    }
  });

  it('has sound polygons, turned counter-clockwise', () => {
    const { primary, rooms, walls, secondary } = home.plan.storeys[0];
    const outlines = [...primary, ...[...rooms, ...walls, ...secondary].map(({ outline }) => outline)];
    for (const outline of outlines) expect(polygonProblems(outline)).toEqual([]);
  });

  it('rooms are named in reading order, with heights and confidences', () => {
    const [{ rooms }] = home.plan.storeys;
    expect(rooms.map(({ name }) => name)).toEqual(rooms.map((_, i) => `Room ${i + 1}`));
    for (const { height, confidence } of rooms) {
      expect(height).toBeGreaterThan(2.2);
      expect(confidence).toBeGreaterThan(0.5);
      expect(confidence).toBeLessThanOrEqual(1);
    }
  });

  it('is a closed model with holes for the openings', () => {
    expect(checkSolid(home.solid)).toMatchObject({ openEdges: 0 });
    expect(home.plan.storeys[0].openings.length).toBeGreaterThan(3);
    // One shell with faces only where the walls have some: pieces that do not meet would be raised layer by layer.
    expect(home.solid.indices.length / 3).toBeLessThan(2000);
  });
});

it('a house has a plan a storey, with stretches nobody saw by room', async () => {
  const { plan, measures } = await make({ name: 'house', building: homeBuilding(43, { storeys: 2 }) });
  expect(plan.storeys.map(({ index }) => index)).toEqual([0, 1]);
  expect(plan.storeys[1].floor - plan.storeys[0].floor).toBeGreaterThan(2.4);
  expect(measures.roomF1).toBeGreaterThan(0.9);
  for (const { rooms, gaps } of plan.storeys) {
    expect(gaps.length).toBeGreaterThan(0);
    // What no point supports is told with the room whose outline it is of.
    for (const { from, to, room } of gaps) {
      const { outer, holes } = rooms.find(({ name }) => name === room)!.outline;
      for (const place of [from, to]) {
        const away = [outer, ...holes].map((ring) => distanceToRing(...place, ring));
        expect(Math.min(...away)).toBeLessThan(1e-6);
      }
    }
  }
});

it('a curved wall is a fine polygon on its arc, and one wall', async () => {
  const { plan, measures } = await make({ name: 'hall', building: roundHallBuilding(44) });
  expect(measures.roomF1).toBe(1);
  expect(measures.footprintIou).toBeGreaterThan(0.99);
  expect(measures.faceMedianMm).toBeLessThan(5);
  const { rooms, walls, primary } = plan.storeys[0];
  const outlines = [...rooms, ...walls].map(({ outline }) => outline);
  for (const polygon of [...outlines, ...primary]) expectOnArcs(polygon);
  const [hall, ...others] = rooms.filter(({ outline }) => outline.arcs);
  expect(others).toHaveLength(0);
  expect(hall.outline.arcs).toHaveLength(1);
  const curved = walls.filter(({ outline }) => outline.arcs);
  expect(curved).toHaveLength(1);
  const radii = curved[0].outline.arcs!.map(({ radius }) => radius).sort((a, b) => a - b);
  expect(radii[1] - radii[0]).toBeCloseTo(curved[0].thickness, 9);
});

/** Every vertex said to be on an arc is. */
function expectOnArcs({ outer, holes, arcs = [] }: Polygon): void {
  for (const { ring, from, to, centre, radius } of arcs) {
    const xy = [outer, ...holes][ring];
    const n = xy.length / 2;
    const count = from === to ? n : (to - from + n) % n;
    expect(count).toBeGreaterThan(1);
    for (let k = 0; k <= count; k++) {
      const i = (from + k) % n;
      const off = Math.hypot(xy[2 * i] - centre[0], xy[2 * i + 1] - centre[1]) - radius;
      expect(Math.abs(off)).toBeLessThanOrEqual(ON_ARC);
    }
  }
}

it('a column is a structure, not a room', async () => {
  const { plan, measures } = await make({ name: 'column', building: columnRoomBuilding(45, 'round') });
  expect(plan.storeys[0].rooms).toHaveLength(1);
  expect(measures.structureF1).toBe(1);
});

const corpusScene = (name: string): SceneSpec => {
  const { spec } = CORPUS.find((scene) => scene.name === name && !scene.isHeldBack)!;
  const scene = spec();
  return { ...scene, scan: { ...scene.scan, mostRays: 250_000 } };
};

it('a home scanned without its ceilings has its rooms', async () => {
  const { measures } = await make(corpusScene('home-no-ceiling-138'));
  expect(measures.roomF1).toBe(1);
  expect(measures.footprintIou).toBeGreaterThan(0.99);
  expect(measures.doorF1).toBeGreaterThan(0.8);
});

it('furnished offices under lowered ceilings have their rooms', async () => {
  const { measures } = await make(corpusScene('wing-30-office-148'));
  expect(measures.roomF1).toBeGreaterThan(0.82);
  expect(measures.footprintIou).toBeGreaterThan(0.98);
});

it('a closed door stands back in its frame, and is a door', async () => {
  const { plan, measures } = await make(corpusScene('one-room-134'));
  expect(measures.doorF1).toBe(1);
  const door = plan.storeys[0].openings.find(({ type }) => type === 'door')!;
  expect(door.sill).toBe(0);
  expect(Math.abs(door.head - 2.05)).toBeLessThan(0.1);
  expect(Math.abs(Math.hypot(door.to[0] - door.from[0], door.to[1] - door.from[1]) - 0.8)).toBeLessThan(0.1);
});

it('a closed door is one in noise that puts half of its points on the face, too', async () => {
  const { measures } = await make(corpusScene('one-room-cupboards-160'));
  expect(measures).toMatchObject({ doorF1: 1, roomF1: 1 });
});

it('a garden wall has no rooms, and says so', async () => {
  const rows = ['x,y,z'];
  for (let i = 0; i < 400; i++)
    for (let k = 0; k < 40; k++) rows.push(`${i * 0.05},${0.01 * Math.sin(i)},${k * 0.05}`);
  for (let i = 0; i < 100; i++) for (let k = 0; k < 100; k++) rows.push(`${i * 0.2},${k * 0.2 - 10},0`);
  const session = new Session({ strokeTest: createStrokeTest() });
  const { plan } = await session.load(blobSource(new Blob([rows.join('\n')]), 'garden.csv'), {
    up: 'z',
    unit: 'm',
  });
  expect(plan.storeys[0].rooms).toEqual([]);
  expect(plan.warnings.map(({ code }) => code)).toContain('rooms/none-found');
});
