import { expect, it } from 'vitest';
import { simulate, writePly } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { makeReport } from '../../../src/session/report.ts';
import type { RunResult } from '../../../src/session/result.ts';
import { Session } from '../../../src/session/session.ts';

/** Codes of a run, which its plan, its result and its report have alike. */
function codesOf(result: RunResult): string[] {
  const codes = result.warnings.map(({ code }) => code);
  expect(result.plan.warnings.map(({ code }) => code)).toEqual(codes);
  expect(makeReport(result, 0).warnings.map(({ code }) => code)).toEqual(codes);
  return codes;
}

const GAP = 'boundary/gap-bridged';

it('a plan of rooms is not told of what befell the outline, a plan of the outline is', async () => {
  const scan = { voxel: 0.05, raysPerStation: 60_000, stationsPerRoom: 1 };
  const { positions } = simulate({ name: 'home', building: homeBuilding(42, { shape: 'L' }), scan });
  const session = new Session({ strokeTest: createStrokeTest() });
  const source = blobSource(new Blob([writePly({ positions })]), 'home.ply');
  const rooms = await session.load(source, { unit: 'm' });
  expect(rooms.plan.storeys[0].rooms.length).toBeGreaterThan(1);
  expect(codesOf(rooms)).not.toContain(GAP);
  const outline = await session.update({ unit: 'm', planMethod: 'outline' });
  expect(codesOf(outline)).toContain(GAP);
  // From the cache too.
  expect(codesOf(await session.update({ unit: 'm' }))).toEqual(codesOf(rooms));
});
