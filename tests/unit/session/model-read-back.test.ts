import { expect, it } from 'vitest';
import { simulate, writePly } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { polygonArea } from '../../../src/core/geometry/rings.ts';
import { Session } from '../../../src/session/session.ts';
import { memorySource } from '../read/memory-source.ts';

const areasIn = ({ result }: Session): number[] =>
  result!.plan.storeys[0].rooms.map(({ outline }) => polygonArea(outline)).sort((a, b) => a - b);

it('the model of a home, walls with tops and a floor, gives the home again', async () => {
  const scan = { voxel: 0.05, raysPerStation: 40_000 };
  const { positions } = simulate({ name: 'home', building: homeBuilding(3), scan });
  const home = new Session({ strokeTest: createStrokeTest() });
  await home.load(memorySource(writePly({ positions }), 'home.ply'));
  const [{ content }] = await home.write('glb');
  const model = new Session({ strokeTest: createStrokeTest() });
  await model.load(memorySource(content as Uint8Array, 'plan.glb'), { resolution: 0.05 });
  const [scanned, modelled] = [areasIn(home), areasIn(model)];
  expect(scanned.length).toBeGreaterThan(3);
  expect(modelled.length).toBe(scanned.length);
  for (const [i, area] of scanned.entries()) expect(Math.abs(modelled[i] / area - 1)).toBeLessThan(0.01);
});
