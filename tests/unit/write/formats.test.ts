import { unzipSync } from 'fflate';
import { expect, test } from 'vitest';
import { makeNodeCanvas } from '../../../src/cli/node-canvas.ts';
import type { PointCloud } from '../../../src/core/types.ts';
import { SIDECARS, WRITE_FORMAT_NAMES, writeFiles } from '../../../src/write/formats.ts';
import type { Product } from '../../../src/write/plan-writer.ts';
import { rectangle, ring } from '../solid/plans.ts';
import { home, productOf } from './products.ts';

const TOOLS = { makeCanvas: makeNodeCanvas };
/** A home with its coordinate system and its points: it can be written in every format. */
async function scannedHome(): Promise<Product> {
  const frame = {
    planOrigin: [691_000, 5_334_000, 500],
    origin: [691_000, 5_334_000, 500],
    crs: 'EPSG:25832',
  } as const;
  const product = await productOf({ ...home(), frame });
  const crop: PointCloud = {
    ...{
      frame: product.plan.frame,
      positions: Float32Array.of(1, 1, 0, 2, 2, 1),
      attributes: {},
      stations: [],
    },
    ...{ floor: 0, ceiling: 2.5, reasons: { unit: '', up: '' }, isFlat: false },
  };
  return { ...product, crop };
}

const namesOf = (files: readonly { name: string }[]): string[] => files.map(({ name }) => name);

test('one storey: the names people build on', async () => {
  const product = await scannedHome();
  expect(
    (await Promise.all(WRITE_FORMAT_NAMES.map((format) => writeFiles(product, format, TOOLS)))).flatMap(
      namesOf,
    ),
  ).toEqual([
    'plan.svg',
    'plan.pdf',
    'plan.png',
    'plan.minimal.svg',
    'plan.dxf',
    'plan.geojson',
    'plan.wgs84.geojson',
    'plan.glb',
    'plan.points.glb',
    'plan.ifc',
    'plan.obj',
    'plan.mtl',
    'plan.stl',
    'plan.ply',
    'plan.json',
    'plan.frame.json',
    'slice.csv',
    'rooms.csv',
    'rooms.xlsx',
    'picture-01-cloud.svg',
    'picture-03-slice.svg',
    'picture-14-plan.svg',
    'picture-15-model.svg',
    'plan.zip',
  ]);
});

test('chosen formats in one ZIP', async () => {
  const product = await productOf(home());
  const [file, ...others] = await writeFiles(product, 'zip:svg,rooms');
  expect([file.name, others]).toEqual(['plan.zip', []]);
  const entries = unzipSync(file.content as Uint8Array);
  expect(Object.keys(entries)).toEqual(['plan.svg', 'rooms.csv', 'README.txt']);
  await expect(writeFiles(product, 'zip:svg,pdx')).rejects.toMatchObject({ code: 'option/invalid' });
});

test('several storeys: drawn formats once a storey, the others with all of them', async () => {
  const product = await productOf({
    storeys: [{}, { primary: [{ outer: rectangle(0, 0, 2, 2), holes: [] }] }],
  });
  expect(namesOf(await writeFiles(product, 'svg'))).toEqual(['plan-0.svg', 'plan-1.svg']);
  expect(namesOf(await writeFiles(product, 'frame'))).toEqual(['plan-0.frame.json', 'plan-1.frame.json']);
  expect(namesOf(await writeFiles(product, 'geojson'))).toEqual(['plan.geojson']);
  expect(namesOf(await writeFiles(product, 'slice'))).toEqual(['slice.csv']);
  const [ground, first] = (await writeFiles(product, 'svg')).map(({ content }) => content as string);
  expect(ground).toContain('storey 0 (0 to 1)');
  expect(first).toContain('storey 1 (0 to 1)');
});

test('every file has a media type and something in it, and is the same when written again', async () => {
  for (const format of WRITE_FORMAT_NAMES) {
    const [first] = await writeFiles(await scannedHome(), format, TOOLS);
    const [second] = await writeFiles(await scannedHome(), format, TOOLS);
    expect(first.mime).toMatch(/^[a-z]+\/[\w.+-]+$/);
    expect(first.content.length).toBeGreaterThan(10);
    expect(second).toEqual(first);
  }
});

test('an SVG goes with its georeference', () => {
  expect(SIDECARS.svg).toEqual(['frame']);
});

test('an unknown format is refused by name', async () => {
  const product = await productOf();
  await expect(writeFiles(product, 'tiff')).rejects.toThrow(
    expect.objectContaining({ code: 'option/invalid' }),
  );
  await expect(writeFiles(product, 'constructor')).rejects.toThrow(
    expect.objectContaining({ code: 'option/invalid' }),
  );
});

test('the slice is in source units and coordinates, in short decimals', async () => {
  const product = await productOf({
    storeys: [{ primary: [{ outer: ring(0, 0, 1.50001, 0.1 + 0.2, 1, 1), holes: [] }] }],
    frame: { planOrigin: [691_000.5, 5_334_000, 0] },
  });
  expect((await writeFiles(product, 'slice'))[0].content).toBe(
    'x,y\n691000.5,5334000\n691002,5334000.3\n691001.5,5334001\n',
  );
});

const ROOMS_HEAD =
  'name,storey,areaM2,heightM,confidence,number,perimeterM,volumeM3,doors,windows,passages\n';

test('rooms are quoted where need be, and no name becomes a formula', async () => {
  const outline = { outer: rectangle(0, 0, 4, 3), holes: [] };
  const rooms = ['Room 1', 'a,"b"\nc', '=1+1'].map((name) => ({
    name,
    outline,
    height: 2.5,
    confidence: 0.875,
  }));
  const product = await productOf({ storeys: [{ rooms }] });
  expect((await writeFiles(product, 'rooms'))[0].content).toBe(
    `${ROOMS_HEAD}Room 1,0,12,2.5,0.875,1,14,30,0,0,0\n"a,""b""\nc",0,12,2.5,0.875,2,14,30,0,0,0\n'=1+1,0,12,2.5,0.875,3,14,30,0,0,0\n`,
  );
  expect((await writeFiles(await productOf(), 'rooms'))[0].content).toBe(ROOMS_HEAD);
});
