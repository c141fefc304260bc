import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { type SceneSpec, simulate, writePly } from '../../fixtures/simulator/index.ts';
import { homeBuilding, officeBuilding } from '../../fixtures/simulator/layouts.ts';
import { paperSlice } from '../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import type { Options } from '../../src/core/params.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import { Session } from '../../src/session/session.ts';
import { measurePlan } from '../accuracy/measure.ts';

/**
 * The paper's chain, fixture → files, as text to the tenth of a millimetre. `vitest run -u` writes them anew: look at
 * the drawings before you commit them. Everything that decides is named here, since presets may change.
 */
const PAPER: Partial<Options> = { preset: 'paper' };
const TEXTS = ['geojson', 'svg', 'minimal-svg', 'dxf', 'slice', 'frame'];

const scan = { voxel: 0.05, raysPerStation: 40_000 };
const homes: Record<string, SceneSpec> = {
  'home-l': { name: 'home-l', building: homeBuilding(11, { shape: 'L' }), scan },
  'home-utm-y-up-mm': {
    name: 'home-utm-y-up-mm',
    building: homeBuilding(12, { shape: 'T' }),
    scan,
    pose: { up: 'y', unit: 'mm', heading: 0.6, offset: [691_000, 5_336_000, 512] },
  },
};

/** Measured only: a floor whose rooms open to the outside by wide windows. */
const measured: Record<string, SceneSpec> = {
  ...homes,
  office: { name: 'office', building: officeBuilding(4), scan: { ...scan, voxel: 0.06 } },
};

const slices = {
  'hallway-1': {},
  'room-1a': { secondaryCount: 1 },
  'room-2': { secondaryCount: 1 },
} as const;

async function run(bytes: BlobPart, name: string, options: Partial<Options>): Promise<Session> {
  const session = new Session({ strokeTest: createStrokeTest() });
  await session.load(blobSource(new Blob([bytes]), name), options);
  return session;
}

async function expectGolden(session: Session, name: string): Promise<void> {
  for (const format of TEXTS) {
    const [file] = await session.write(format);
    await expect(file.content as string).toMatchFileSnapshot(`${name}/${file.name}`);
  }
}

describe('ready slices under the preset paper', () => {
  it.each(Object.entries(slices))('%s', async (name, options) => {
    const { xy } = paperSlice(name as keyof typeof slices, 1);
    const rows = Array.from(
      { length: xy.length / 2 },
      (_, i) => `${xy[2 * i].toFixed(3)},${xy[2 * i + 1].toFixed(3)}`,
    );
    await expectGolden(await run(`x,y\n${rows.join('\n')}\n`, `${name}.csv`, options), name);
  });
});

describe('scans', () => {
  const scores = readFileSync(new URL('scores.json', import.meta.url), 'utf8');
  const best: Record<string, number> = JSON.parse(scores);

  it.each(Object.entries(homes))('%s under the preset paper', async (name, spec) => {
    const { positions } = simulate(spec);
    const ply = writePly({ positions }, { type: 'double' });
    await expectGolden(await run(ply, `${name}.ply`, PAPER), name);
  });

  it.each(Object.entries(measured))("%s: the default's footprint gets no worse", async (name, spec) => {
    const { positions, truth } = simulate(spec);
    const session = await run(writePly({ positions }, { type: 'double' }), `${name}.ply`, {});
    const [{ content }] = await session.write('geojson');
    const iou = measurePlan(JSON.parse(content as string), truth).footprintIou!;
    expect(iou, 'lower a score only with a reason').toBeGreaterThanOrEqual(best[name]);
  });
});
