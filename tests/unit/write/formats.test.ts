import { expect, test } from 'vitest';
import { SIDECARS, WRITE_FORMAT_NAMES, writeFiles } from '../../../src/write/formats.ts';
import { rectangle, ring } from '../solid/plans.ts';
import { home, productOf } from './products.ts';

const namesOf = (files: readonly { name: string }[]): string[] => files.map(({ name }) => name);

test('one storey: the names people build on', async () => {
  const product = await productOf(home());
  expect(WRITE_FORMAT_NAMES.flatMap((format) => namesOf(writeFiles(product, format)))).toEqual([
    'plan.svg',
    'plan.minimal.svg',
    'plan.dxf',
    'plan.geojson',
    'plan.glb',
    'plan.json',
    'plan.frame.json',
    'slice.csv',
    'rooms.csv',
    'picture-03-slice.svg',
    'picture-14-plan.svg',
    'picture-15-model.svg',
  ]);
});

test('several storeys: drawn formats once a storey, the others with all of them', async () => {
  const product = await productOf({
    storeys: [{}, { primary: [{ outer: rectangle(0, 0, 2, 2), holes: [] }] }],
  });
  expect(namesOf(writeFiles(product, 'svg'))).toEqual(['plan-0.svg', 'plan-1.svg']);
  expect(namesOf(writeFiles(product, 'frame'))).toEqual(['plan-0.frame.json', 'plan-1.frame.json']);
  expect(namesOf(writeFiles(product, 'geojson'))).toEqual(['plan.geojson']);
  expect(namesOf(writeFiles(product, 'slice'))).toEqual(['slice.csv']);
  const [ground, first] = writeFiles(product, 'svg').map(({ content }) => content as string);
  expect(ground).toContain('storey 0 of 0 to 1');
  expect(first).toContain('storey 1 of 0 to 1');
});

test('every file has a media type and something in it, and is the same when written again', async () => {
  for (const format of WRITE_FORMAT_NAMES) {
    const [first] = writeFiles(await productOf(home()), format);
    const [second] = writeFiles(await productOf(home()), format);
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
  expect(() => writeFiles(product, 'tiff')).toThrow(expect.objectContaining({ code: 'option/invalid' }));
  expect(() => writeFiles(product, 'constructor')).toThrow(
    expect.objectContaining({ code: 'option/invalid' }),
  );
});

test('the slice is in source units and coordinates, in short decimals', async () => {
  const product = await productOf({
    storeys: [{ primary: [{ outer: ring(0, 0, 1.50001, 0.1 + 0.2, 1, 1), holes: [] }] }],
    frame: { planOrigin: [691_000.5, 5_334_000, 0] },
  });
  expect(writeFiles(product, 'slice')[0].content).toBe(
    'x,y\n691000.5,5334000\n691002,5334000.3\n691001.5,5334001\n',
  );
});

test('rooms are quoted where need be, and no name becomes a formula', async () => {
  const outline = { outer: rectangle(0, 0, 4, 3), holes: [] };
  const rooms = ['Room 1', 'a,"b"\nc', '=1+1'].map((name) => ({
    name,
    outline,
    height: 2.5,
    confidence: 0.875,
  }));
  const product = await productOf({ storeys: [{ rooms }] });
  expect(writeFiles(product, 'rooms')[0].content).toBe(
    'name,storey,areaM2,heightM,confidence\nRoom 1,0,12,2.5,0.875\n"a,""b""\nc",0,12,2.5,0.875\n\'=1+1,0,12,2.5,0.875\n',
  );
  expect(writeFiles(await productOf(), 'rooms')[0].content).toBe('name,storey,areaM2,heightM,confidence\n');
});
