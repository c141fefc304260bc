import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { ByteCursor } from '../../../src/read/bytes/byte-cursor.ts';
import { openScan } from '../../../src/read/open-scan.ts';
import { inflateLzf, mostInflated } from '../../../src/read/pcd/lzf.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { bytesOf, memorySource, readAll } from './memory-source.ts';
import { literalRuns, type PcdContent, pcdBytes, uint32 } from './pcd-bytes.ts';

const DATA = ['ascii', 'binary', 'binary_compressed'] as const;
const read = (bytes: Uint8Array, pieces?: number[]) => readAll(memorySource(bytes, 'a.pcd', pieces));
const POINTS = [
  [1.5, -2.25, 3],
  [0.125, 1e6, -0.5],
  [7, 8, 9],
];
const XYZ: PcdContent = { fields: ['x', 'y', 'z'].map((name) => [name, 8, 'F'] as const), points: POINTS };

describe.each(DATA)('PCD %s', (data) => {
  it('reads coordinates, in pieces of any size', async () => {
    for (const pieces of [[1 << 20], [1], [7, 50]]) {
      const { xyz, colour, isSlice } = await read(pcdBytes(XYZ, { data }), pieces);
      expect(xyz).toEqual(POINTS);
      expect(colour).toBeUndefined();
      expect(isSlice).toBe(false);
    }
  });

  it('takes fields in any order, of any type and count, and skips those it does not know', async () => {
    const content: PcdContent = {
      fields: [
        ['fpfh', 4, 'F', 3],
        ['z', 2, 'U'],
        ['intensity', 4, 'F'],
        ['x', 1, 'U'],
        ['label', 4, 'U'],
        ['y', 8, 'F'],
      ],
      points: [
        [9, 9, 9, 300, 0.5, 10, 77, 20.5],
        [9, 9, 9, 301, 0.25, 11, 77, 21.5],
      ],
    };
    const { xyz, intensity } = await read(pcdBytes(content, { data }));
    expect(xyz).toEqual([
      [10, 20.5, 300],
      [11, 21.5, 301],
    ]);
    expect(intensity).toEqual([0.5, 0.25]);
  });

  it.each(['rgb', 'rgba'] as const)('unpacks %s', async (name) => {
    const content: PcdContent = {
      fields: [...XYZ.fields, [name, 4, 'U']],
      points: POINTS.map((point, i) => [...point, 0xff000000 + (10 + i) * 65536 + 20 * 256 + 30]),
    };
    expect((await read(pcdBytes(content, { data }))).colour).toEqual(
      [10, 11, 12].map((red) => [red, 20, 30]),
    );
  });

  it('unpacks a colour kept in the bits of a float', async () => {
    const packed = new Float32Array(Uint32Array.of(0x00fe8040).buffer)[0];
    const content: PcdContent = { fields: [...XYZ.fields, ['rgb', 4, 'F']], points: [[1, 2, 3, packed]] };
    expect((await read(pcdBytes(content, { data }))).colour).toEqual([[254, 128, 64]]);
  });

  it('takes red, green and blue apart', async () => {
    const rgb = ['r', 'g', 'b'].map((name) => [name, 1, 'U'] as const);
    const content: PcdContent = { fields: [...XYZ.fields, ...rgb], points: [[1, 2, 3, 4, 5, 6]] };
    expect((await read(pcdBytes(content, { data }))).colour).toEqual([[4, 5, 6]]);
  });

  it('says that a file is cut off', async () => {
    const whole = pcdBytes(XYZ, { data });
    const cut = whole.subarray(0, whole.length - 9);
    await expect(read(cut)).rejects.toMatchObject({ code: 'input/truncated' });
    const ofUnknownSize = { ...memorySource(cut, 'a.pcd'), size: undefined };
    await expect(readAll(ofUnknownSize)).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('refuses a header that promises more than the file can hold', async () => {
    const lines = { POINTS: 'POINTS 180000000', WIDTH: 'WIDTH 180000000' };
    await expect(read(pcdBytes(XYZ, { data, lines }))).rejects.toMatchObject({
      code: data === 'binary_compressed' ? 'input/too-large' : 'input/truncated',
    });
  });
});

describe('PCD header', () => {
  it('takes old versions, comments and lines that end in CRLF', async () => {
    const lines = {
      '#': '# made by hand',
      VERSION: 'VERSION .5',
      FIELDS: 'COLUMNS x y z',
      COUNT: '',
      VIEWPOINT: '',
      POINTS: '',
    };
    expect((await read(pcdBytes(XYZ, { data: 'ascii', lines, lineEnd: '\r\n' }))).xyz).toEqual(POINTS);
  });

  it('keeps the place of the scanner, and the points as they are', async () => {
    const bytes = pcdBytes(XYZ, {
      data: 'binary',
      lines: { VIEWPOINT: 'VIEWPOINT 1 2 3 0.7071 0 0.7071 0' },
    });
    const { cloud } = await openScan([memorySource(bytes, 'a.pcd')]);
    expect(cloud.stations).toEqual([[1, 2, 3]]);
    expect((await read(bytes)).xyz).toEqual(POINTS);
    const { cloud: other } = await openScan([memorySource(pcdBytes(XYZ, { data: 'binary' }), 'a.pcd')]);
    expect(other.stations).toBeUndefined();
  });

  it('counts the empty places of a grid without a warning', async () => {
    const points = [...POINTS, [Number.NaN, Number.NaN, Number.NaN]];
    const file = (lines: Record<string, string>) =>
      memorySource(pcdBytes({ ...XYZ, points }, { data: 'binary', lines }), 'a.pcd');
    const grid = await readScan(file({ WIDTH: 'WIDTH 2', HEIGHT: 'HEIGHT 2' }), resolveOptions({}));
    expect(grid).toMatchObject({ facts: { pointsRead: 4, pointsDropped: 1, pointsKept: 3 }, warnings: [] });
    const list = await readScan(file({}), resolveOptions({}));
    expect(list.warnings).toMatchObject([{ code: 'read/points-dropped' }]);
  });

  it.each([
    [{ TYPE: 'TYPE F F Q' }, 'F, I or U'],
    [{ SIZE: 'SIZE 8 8' }, '3 numbers'],
    [{ POINTS: 'POINTS many' }, 'a count'],
    [{ FIELDS: 'FIELDS x y w' }, 'found x, y, w'],
  ])('names what it cannot read: %j', async (lines, message) => {
    await expect(read(pcdBytes(XYZ, { data: 'ascii', lines }))).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining(message),
    });
  });

  it('refuses 0 points and an unknown encoding', async () => {
    await expect(read(pcdBytes({ ...XYZ, points: [] }, { data: 'binary' }))).rejects.toMatchObject({
      code: 'input/empty',
    });
    await expect(read(bytesOf('# .PCD\nFIELDS x y z\nPOINTS 1\nDATA morse\n'))).rejects.toThrow(
      'ascii, binary',
    );
    await expect(read(bytesOf('# .PCD\nFIELDS x y z\n'))).rejects.toMatchObject({ code: 'input/truncated' });
  });
});

describe('a compressed body', () => {
  const XYZ4: PcdContent = {
    fields: ['x', 'y', 'z'].map((name) => [name, 4, 'F'] as const),
    points: [[0, 0, 0]],
  };
  const withBody = (packed: number[], inflated: number) => {
    const whole = pcdBytes(XYZ4, { data: 'binary_compressed' });
    const body = [...uint32(packed.length), ...uint32(inflated), ...packed];
    return Uint8Array.from([...whole.subarray(0, whole.length - 8 - 13), ...body]);
  };

  it('follows references, into themselves too', async () => {
    // A zero, then 11 bytes from one byte back: length 11 = 7 + 2 + 2.
    expect((await read(withBody([0, 0, 0xe0, 2, 0], 12))).xyz).toEqual([[0, 0, 0]]);
  });

  it.each([
    ['a reference before the begin', [0x20, 5, 31, ...Array(32).fill(0)], 12],
    ['text that goes on too long', literalRuns(Array(13).fill(0)), 12],
    ['text that is too short', literalRuns(Array(11).fill(0)), 12],
    ['a reference that lacks its last byte', [0, 0, 0xe0, 2], 12],
    ['another size than the points need', literalRuns(Array(16).fill(0)), 16],
    ['more than LZF can hold', [0], 12_000],
  ])('refuses %s', async (_, packed, inflated) => {
    await expect(read(withBody(packed, inflated))).rejects.toMatchObject({ code: 'input/malformed' });
  });

  it('grows by no more than the longest references', async () => {
    const packed = [0, 7, ...Array(10).fill([0xff, 0xff, 0]).flat()];
    // The first token is a literal byte; references cannot reach back 8,192 bytes, so only their length counts.
    const near = packed.map((byte, i) => (i > 1 && (i - 2) % 3 === 0 ? 0xe0 : byte));
    const into = new Uint8Array(1 + 10 * 264);
    const cursor = new ByteCursor(memorySource(Uint8Array.from(near), 'a').stream(), () => {});
    expect(await inflateLzf(cursor, near.length, into, () => new Error('cut'))).toBe(into.length);
    expect(into.every((byte) => byte === 7)).toBe(true);
    expect(mostInflated(near.length)).toBeGreaterThanOrEqual(into.length);
  });
});

describe('clouds that open3d wrote', () => {
  const fixture = (name: string) => new URL(`../../../fixtures/foreign/${name}`, import.meta.url).pathname;
  const rows = readFileSync(fixture('cloud.txt'), 'utf8')
    .trim()
    .split('\n')
    .map((row) => row.split(' ').map(Number));

  it.each(['ascii', 'binary', 'compressed'])('%s', async (kind) => {
    const { xyz, colour } = await readAll(await nodeSource(fixture(`cloud-${kind}.pcd`)));
    expect(xyz).toHaveLength(rows.length);
    // 32-bit floats of up to 5 m.
    const errors = xyz.flatMap((point, i) => point.map((value, axis) => Math.abs(value - rows[i][axis])));
    expect(Math.max(...errors)).toBeLessThan(1e-6);
    expect(colour).toEqual(rows.map((row) => row.slice(3)));
  });
});
