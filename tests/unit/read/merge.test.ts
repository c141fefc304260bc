import { expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import type { OpenCloud, PointChunk } from '../../../src/read/cloud-reader.ts';
import { mergeClouds } from '../../../src/read/merged-cloud.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { memorySource } from './memory-source.ts';

const grid = (from: number, to: number) =>
  Array.from({ length: to - from }, (_, i) => `${(from + i) % 40} ${Math.floor((from + i) / 40)} ${i % 3}\n`);
const OPTIONS = resolveOptions({ unit: 'm' });

it('reads several files as one scan, whatever their order', async () => {
  const tiles = [grid(0, 700), grid(700, 900), grid(900, 1600)].map((rows, i) =>
    memorySource(rows.join(''), `${i}.xyz`),
  );
  const whole = await readScan(
    memorySource([...grid(0, 700), ...grid(700, 900), ...grid(900, 1600)].join(''), 'a.xyz'),
    OPTIONS,
  );
  const merged = await readScan(tiles, OPTIONS);
  const reversed = await readScan([...tiles].reverse(), OPTIONS);
  expect(merged.positions).toEqual(whole.positions);
  expect(reversed.positions).toEqual(whole.positions);
  expect(merged.facts).toMatchObject({ name: '0.xyz + 2', pointsRead: 1600, bytes: whole.facts.bytes });
});

it('passes over what is no cloud among several files, and says so; alone it is refused', async () => {
  const tiles = [grid(0, 700), grid(700, 900)].map((rows, i) => memorySource(rows.join(''), `${i}.xyz`));
  const others = [memorySource('%PDF-1.7\n', 'plan.pdf'), memorySource('', 'empty.las')];
  const whole = await readScan(tiles, OPTIONS);
  const one = await readScan([others[0], ...tiles], OPTIONS);
  expect(one.positions).toEqual(whole.positions);
  expect(one.warnings.map(({ message }) => message)).toEqual([
    'plan.pdf is no point cloud and was passed over.',
  ]);
  const two = await readScan([...tiles, ...others], OPTIONS);
  expect(two.warnings[0].message).toMatch(/^2 files, plan\.pdf among them, are no point clouds/);
  await expect(readScan(others, OPTIONS)).rejects.toMatchObject({
    code: 'input/unknown-format',
    message: expect.stringContaining('a PDF document'),
  });
});

it('does not merge a slice with a cloud', async () => {
  const parts = [memorySource('1 2\n2 3\n4 5\n', 'slice.xyz'), memorySource('1 2 3\n2 3 4\n', 'cloud.xyz')];
  await expect(readScan(parts, OPTIONS)).rejects.toMatchObject({
    code: 'input/malformed',
    message: expect.stringMatching(/slice\.xyz.*cloud\.xyz/),
  });
});

const cloudOf = (facts: Partial<OpenCloud>, station?: number): OpenCloud => ({
  isSlice: false,
  warnings: [],
  ...facts,
  async *chunks(): AsyncGenerator<PointChunk> {
    const chunk = { count: 1, xyz: Float64Array.of(1, 2, 3) };
    yield station === undefined ? chunk : { ...chunk, station: Uint16Array.of(station) };
  },
});
const part = (name: string, cloud: OpenCloud) => ({ name, cloud, size: 10 });

it('counts stations on, and keeps unit and system of the parts that tell them', async () => {
  const merged = mergeClouds([
    part(
      'a',
      cloudOf(
        {
          unit: 'ft',
          stations: [
            [1, 1, 1],
            [2, 2, 2],
          ],
        },
        1,
      ),
    ),
    part('b', cloudOf({ crs: 'EPSG:25832', stations: [[3, 3, 3]] }, 0)),
  ]);
  const seen: (number | undefined)[] = [];
  for await (const { station } of merged.chunks(() => {}, 0)) seen.push(station?.[0]);
  expect(seen).toEqual([1, 2]);
  expect(merged).toMatchObject({
    unit: 'ft',
    crs: 'EPSG:25832',
    stations: [
      [1, 1, 1],
      [2, 2, 2],
      [3, 3, 3],
    ],
  });
});

it('refuses parts of different units and warns of different systems', () => {
  expect(() => mergeClouds([part('a', cloudOf({ unit: 'm' })), part('b', cloudOf({ unit: 'mm' }))])).toThrow(
    expect.objectContaining({
      code: 'input/malformed',
      message: expect.stringMatching(/m in a and mm in b/),
    }),
  );
  const { warnings } = mergeClouds([
    part('a', cloudOf({ crs: 'EPSG:25832' })),
    part('b', cloudOf({ crs: 'EPSG:25833' })),
  ]);
  expect(warnings).toMatchObject([{ code: 'read/mixed-crs' }]);
});

it('has empty places where all parts have them', () => {
  const grid = part('grid', cloudOf({ hasEmptyPlaces: true }));
  expect(mergeClouds([grid, grid]).hasEmptyPlaces).toBe(true);
  expect(mergeClouds([grid, part('plain', cloudOf({}))]).hasEmptyPlaces).toBeUndefined();
});
