import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import { openScan } from '../../../src/read/open-scan.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { lasBytes } from './las/las-bytes.ts';
import { bytesOf, memorySource, readWhole } from './memory-source.ts';
import { pcdBytes } from './pcd-bytes.ts';
import { plyBytes } from './ply-bytes.ts';
import { ptxHeader } from './ptx-text.ts';

const POINTS = 10_000;
const places = Array.from({ length: POINTS }, (_, i) => [i % 40, Math.floor(i / 40) / 8, (i % 7) + 0.5]);
const rows = places.map((place) => `${place.join(' ')}\n`).join('');
const vertices = {
  name: 'vertex',
  properties: ['x', 'y', 'z'].map((name) => ({ name, type: 'float' as const })),
  records: places,
};
const fields = ['x', 'y', 'z'].map((name) => [name, 4, 'F'] as const);
const las = {
  format: 0,
  minor: 2,
  points: places.map(([x, y, z]) => ({ at: [100 * x, 100 * y, 100 * z] as const })),
};

const FILES: readonly (readonly [name: string, bytes: Uint8Array])[] = [
  ['binary.ply', plyBytes([vertices], { format: 'binary_little_endian' })],
  ['ascii.ply', plyBytes([vertices], { format: 'ascii' })],
  ['a.las', lasBytes(las)],
  ['binary.pcd', pcdBytes({ fields, points: places }, { data: 'binary' })],
  ['ascii.pcd', pcdBytes({ fields, points: places }, { data: 'ascii' })],
  ['a.pts', bytesOf(`${POINTS}\n${rows}`)],
  ['two.pts', bytesOf(`100\n${rows.split('\n').slice(0, 100).join('\n')}\n${POINTS}\n${rows}`)],
  ['a.ptx', bytesOf(ptxHeader(100, 100) + rows)],
];

/** Points of which nothing is missing, in the bytes before `end`. */
async function wholePoints(name: string, bytes: Uint8Array, end: number): Promise<number[][]> {
  const whole = await readWhole(memorySource(bytes, name));
  if (!/ascii|pts|ptx/.test(name)) {
    const stride = name === 'a.las' ? 20 : 12;
    return whole.xyz.slice(0, Math.floor((end - (bytes.length - POINTS * stride)) / stride));
  }
  const lost = [...bytes.subarray(end)].filter((byte) => byte === 10).length;
  return whole.xyz.slice(0, whole.xyz.length - lost);
}

describe.each(FILES)('%s', (name, bytes) => {
  // Anywhere in a row, between its numbers and after its last digit.
  const cuts = [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10].map((back) => Math.floor(0.8 * bytes.length) - back);

  it.each(cuts)('cut after %i bytes gives the points that are whole, and says so', async (end) => {
    const cut = memorySource(bytes.slice(0, end), name, [5000]);
    const expected = await wholePoints(name, bytes, end);
    for (const source of [cut, { ...cut, size: undefined }]) {
      const { xyz, cloud } = await readWhole(source);
      expect(xyz).toEqual(expected);
      expect(cloud.warnings).toEqual([
        {
          code: 'read/cut-off',
          message: expect.stringMatching(
            /^The file is cut off: [78],\d{3} of the 10,[01]00 points announced/,
          ),
          hint: expect.stringContaining('Copy'),
        },
      ]);
    }
  });

  it('says so once, however often it is read', async () => {
    const { cloud } = await openScan([memorySource(bytes.slice(0, 0.8 * bytes.length), name)]);
    for (let time = 0; time < 2; time++) for await (const _ of cloud.chunks(() => {}, 0));
    expect(cloud.warnings.length).toBe(1);
  });

  it('of which little is whole is refused', async () => {
    const cut = memorySource(bytes.slice(0, 0.3 * bytes.length), name);
    for (const source of [cut, { ...cut, size: undefined }])
      await expect(readWhole(source)).rejects.toMatchObject({ code: 'input/truncated' });
  });
});

describe('a text table', () => {
  const read = (text: string) => readWhole(memorySource(text, 'a.csv'));

  it.each([
    ['within a row', '1 2', POINTS],
    ['within a number', '1 2 -', POINTS],
    ['where a row may be whole', '1 2 3', POINTS + 1],
  ])('cut off %s', async (_, rest, points) => {
    const { xyz, cloud } = await read(rows + rest);
    expect(xyz.length).toBe(points);
    expect(cloud.warnings.map(({ code }) => code)).toEqual(points === POINTS ? ['read/cut-off'] : []);
  });

  it('with a wrong row in its midst is refused', async () => {
    await expect(read(`${rows}1 2 -\n3 4 5\n`)).rejects.toMatchObject({ code: 'input/malformed' });
  });
});

it('names the part of a scan that is cut off', async () => {
  const [[name, bytes]] = FILES;
  const parts = [memorySource(rows, 'whole.xyz'), memorySource(bytes.slice(0, 0.8 * bytes.length), name)];
  const scan = await readScan(parts, resolveOptions({ unit: 'm' }));
  expect(scan.warnings).toContainEqual(
    expect.objectContaining({
      code: 'read/cut-off',
      message: expect.stringMatching(/^binary\.ply: The file/),
    }),
  );
});

it('a PTX whose next scan is not there gives the scans before', async () => {
  const text = `${ptxHeader(100, 100)}${rows}100\n100\n0 0 0\n`;
  const { xyz, cloud } = await readWhole(memorySource(text, 'a.ptx'));
  expect(xyz.length).toBe(POINTS);
  expect(cloud.warnings.map(({ code }) => code)).toEqual(['read/cut-off']);
});
