import { expect, it } from 'vitest';
import { simulate, writePly } from '../../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../../fixtures/simulator/layouts.ts';
import { createStrokeTest } from '../../../src/cli/canvas-stroke.ts';
import { makeReport } from '../../../src/session/report.ts';
import { Session } from '../../../src/session/session.ts';
import { cartesianFields, e57Bytes } from '../read/e57-bytes.ts';
import { memorySource } from '../read/memory-source.ts';
import { ptxHeader } from '../read/ptx-text.ts';

const scan = { voxel: 0.06, raysPerStation: 20_000 };
const { positions } = simulate({ name: 'home', building: homeBuilding(11, { shape: 'L' }), scan });
const points = Array.from({ length: positions.length / 3 }, (_, i) => [
  ...positions.subarray(3 * i, 3 * i + 3),
]);
/** Scans of one file: two halves, the second one first. */
const halves = [points.slice(points.length / 2), points.slice(0, points.length / 2)];
const rows = (half: readonly number[][], more = '') =>
  half.map((point) => `${point.join(' ')}${more}\n`).join('');
const pose = '<pose type="Structure"/>';

const files = {
  'home.e57': e57Bytes(
    halves.map((half) => ({ fields: cartesianFields(half), xml: pose })),
    { packets: Math.ceil(points.length / 1000) },
  ),
  'home.ptx': halves
    .map((half) => `${ptxHeader(half.length + 1, 1)}0 0 0 0.5\n${rows(half, ' 0.5')}`)
    .join(''),
  'home.pts': halves.map((half) => `${half.length}\n${rows(half)}`).join(''),
};

async function run(bytes: string | Uint8Array, name: string) {
  const session = new Session({ strokeTest: createStrokeTest() });
  const result = await session.load(memorySource(bytes, name), {});
  const { storeys, frame } = result.plan;
  return { plan: { storeys, frame }, report: makeReport(result, 0) };
}

it('one cloud becomes one plan, whatever the format, the order and the scans it is told in', async () => {
  const ply = await run(writePly({ positions }, { type: 'double' }), 'home.ply');
  expect(ply.report.input.stations).toEqual([]);
  for (const [name, bytes] of Object.entries(files)) {
    const { plan, report } = await run(bytes, name);
    expect(plan).toEqual(ply.plan);
    expect(report.input).toMatchObject({
      format: name.slice(-3),
      pointsRead: points.length,
      stations: name.endsWith('pts')
        ? []
        : [
            [0, 0, 0],
            [0, 0, 0],
          ],
    });
  }
}, 60_000);
