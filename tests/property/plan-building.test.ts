import { expect, it } from 'vitest';
import { simulate, writePly } from '../../fixtures/simulator/index.ts';
import {
  bentSketch,
  curvedSketch,
  homeSketch,
  openPlanSketch,
  type Sketch,
} from '../../fixtures/simulator/sketches.ts';
import { variedBuilding } from '../../fixtures/simulator/varied-buildings.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { isValid } from '../../src/core/building/walls/valid-parts.ts';
import { areaOf, combine } from '../../src/core/geometry/areas.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import { Session } from '../../src/session/session.ts';

const SKETCHES: readonly (readonly [string, Sketch])[] = [
  ['home with alcoves', homeSketch('U', { alcoves: 3 })],
  ['skew home', homeSketch('L', { skew: 0.05 })],
  ['bent office', bentSketch(0.5, 'office')],
  ['curved home', curvedSketch('both')],
  ['open plan', openPlanSketch],
];
const DETAILS = { niches: 2, pilasters: 2, wallEnds: 1, squareColumns: 1, roundColumns: 1, shafts: 1 };

it.each(SKETCHES)('a %s has a plan of valid areas, and walls and rooms apart', async (name, sketch) => {
  const building = variedBuilding(name, 31, sketch, { clutter: 1, details: DETAILS });
  const scan = { voxel: 0.05, noise: 0.015, raysPerStation: 40_000, stationsPerRoom: 1 };
  const { positions } = simulate({ name, building, scan, pose: { heading: 0.7 } });
  const session = new Session({ strokeTest: createStrokeTest() });
  const { plan } = await session.load(blobSource(new Blob([writePly({ positions })]), 'plan.ply'));
  for (const { rooms, walls, primary, secondary } of plan.storeys) {
    expect(rooms.length).toBeGreaterThan(0);
    const areas = rooms.map(({ outline }) => outline);
    const solid = walls.map(({ outline }) => outline);
    const all = [...areas, ...solid, ...primary, ...secondary.map(({ outline }) => outline)];
    expect(all.filter((area) => !isValid(area))).toEqual([]);
    expect(areaOf(areas) - areaOf(combine('union', areas))).toBeLessThan(1e-3);
    expect(areaOf(solid) - areaOf(combine('union', solid))).toBeLessThan(1e-2);
  }
});
