import { unzipSync } from 'fflate';
import { expect, test } from 'vitest';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { WRITE_FORMATS, writeFiles } from '../../../src/write/formats.ts';
import { writeZip, zipFiles } from '../../../src/write/zip.ts';
import { HOSTILE_NAME } from './model/model-plans.ts';
import { home, productOf } from './products.ts';

const row = (name: 'glb' | 'rooms' | 'geojson') => ({ ...WRITE_FORMATS[name], name });
const text = (bytes: Uint8Array): string => new TextDecoder().decode(bytes);

test('files come back as they were, and equal files give equal bytes', () => {
  const files = [
    { name: 'a.txt', content: 'é🏠' },
    { name: 'b.xlsx', content: Uint8Array.of(1, 2, 3) },
  ];
  const entries = unzipSync(zipFiles(files));
  expect(text(entries['a.txt'])).toBe('é🏠');
  expect([...entries['b.xlsx']]).toEqual([1, 2, 3]);
  expect(zipFiles(files)).toEqual(zipFiles(files));
});

test('all formats asked for and a README.txt that tells of each', async () => {
  const product = await productOf(home(), HOSTILE_NAME);
  const formats = [row('glb'), row('rooms')];
  const entries = unzipSync(await writeZip(product, { formats, write: writeFiles }));
  expect(Object.keys(entries)).toEqual(['plan.glb', 'rooms.csv', 'README.txt']);
  const [glb] = await writeFiles(product, 'glb');
  expect(entries['plan.glb']).toEqual(glb.content);
  expect(text(entries['README.txt'])).toContain(`rooms.csv\n  Rooms CSV: ${WRITE_FORMATS.rooms.doc}`);
});

test('a format the plan cannot be written in is left out and told; a bug is not swallowed', async () => {
  const product = await productOf(home());
  const refuse =
    (error: Error) =>
    async (...[given, format]: Parameters<typeof writeFiles>) => {
      if (format === 'glb') throw error;
      return writeFiles(given, format);
    };
  const refused = new FloorPlanError('input/degenerate', 'It has no height.', { hint: 'Give one.' });
  const formats = [row('glb'), row('geojson')];
  const entries = unzipSync(await writeZip(product, { formats, write: refuse(refused) }));
  expect(Object.keys(entries)).toEqual(['plan.geojson', 'README.txt']);
  expect(text(entries['README.txt'])).toContain('No GLB\n  It has no height. Give one.');
  await expect(writeZip(product, { formats: [row('glb')], write: refuse(refused) })).rejects.toBe(refused);
  const bug = new TypeError('undefined is not a function');
  await expect(writeZip(product, { formats, write: refuse(bug) })).rejects.toBe(bug);
});
