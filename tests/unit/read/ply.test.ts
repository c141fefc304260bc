import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { PLY_FORMAT } from '../../../src/read/ply/ply.ts';
import type { PlyProperty, PlyType } from '../../../src/read/ply/ply-header.ts';
import { memorySource, readAll } from './memory-source.ts';
import { type PlyContent, plyBytes } from './ply-bytes.ts';

const single = (type: PlyType, ...names: string[]): PlyProperty[] => names.map((name) => ({ name, type }));
const FORMATS = ['ascii', 'binary_little_endian', 'binary_big_endian'] as const;

const POINTS = [
  [1.5, -2.25, 3],
  [0.125, 1e6, -0.5],
  [7, 8, 9],
];
const XYZ: PlyContent = { name: 'vertex', properties: single('double', 'x', 'y', 'z'), records: POINTS };

const read = (bytes: Uint8Array, pieces?: number[]) => readAll(memorySource(bytes, 'a.ply', pieces));

describe.each(FORMATS)('PLY %s', (format) => {
  it('reads coordinates', async () => {
    const { xyz, isSlice, colour } = await read(plyBytes([XYZ], { format }));
    expect(xyz).toEqual(POINTS);
    expect(isSlice).toBe(false);
    expect(colour).toBeUndefined();
  });

  it('says that more comes than the header announces, but not of padding', async () => {
    const whole = plyBytes([XYZ], { format });
    const text = Buffer.from(whole).toString('latin1');
    const fewer = Uint8Array.from(Buffer.from(text.replace('vertex 3', 'vertex 2'), 'latin1'));
    for (const pieces of [undefined, [7], [fewer.length - 5]]) {
      const source = memorySource(fewer, 'a.ply', pieces);
      const cloud = await PLY_FORMAT.open(source);
      for (const _ of [1, 2]) for await (const { count } of cloud.chunks(() => {}, 0)) expect(count).toBe(2);
      expect(cloud.warnings).toMatchObject([
        { code: 'read/more-than-announced', message: expect.stringContaining('2 points') },
      ]);
    }
    const padded = await PLY_FORMAT.open(memorySource(Uint8Array.of(...whole, 10, 10), 'a.ply'));
    for await (const { count } of padded.chunks(() => {}, 0)) expect(count).toBe(3);
    expect(padded.warnings).toEqual([]);
  });

  it.each(['\n', '\r\n', '\r'])('takes lines that end in %j', async (lineEnd) => {
    const comments = ['comment made by hand', 'obj_info nothing', 'comment'];
    expect((await read(plyBytes([XYZ], { format, lineEnd, comments }))).xyz).toEqual(POINTS);
  });

  it('takes properties in any order and skips those it does not know', async () => {
    const vertex: PlyContent = {
      name: 'vertex',
      properties: [
        ...single('uchar', 'blue', 'red', 'flag', 'green'),
        ...single('float', 'z', 'nx', 'x', 'y', 'intensity'),
        ...single('uchar', 'classification'),
      ],
      records: [
        [3, 1, 77, 2, 30, -1, 10, 20, 0.5, 6],
        [6, 4, 77, 5, 31, -1, 11, 21, 0.25, 2],
      ],
    };
    expect(await read(plyBytes([vertex], { format }))).toEqual({
      isSlice: false,
      xyz: [
        [10, 20, 30],
        [11, 21, 31],
      ],
      colour: [
        [1, 2, 3],
        [4, 5, 6],
      ],
      intensity: [0.5, 0.25],
      classification: [6, 2],
    });
  });

  it('passes over other elements and over lists', async () => {
    const strip: PlyContent = {
      name: 'strip',
      properties: [{ name: 'vertex_indices', type: 'int', countType: 'uchar' }, ...single('short', 'flags')],
      records: [
        [[0, 1, 2], 5],
        [[], 6],
        [[2, 1, 0, 1], 7],
      ],
    };
    const camera: PlyContent = { name: 'camera', properties: single('float', 'a', 'b'), records: [[1, 2]] };
    const vertex: PlyContent = {
      name: 'vertex',
      properties: [
        ...single('float', 'x'),
        { name: 'neighbours', type: 'ushort', countType: 'uint' },
        ...single('float', 'y', 'z'),
      ],
      records: [
        [1, [7, 8, 9], 2, 3],
        [4, [], 5, 6],
      ],
    };
    const expected = [
      [1, 2, 3],
      [4, 5, 6],
    ];
    const bytes = plyBytes([strip, camera, vertex, strip], { format });
    expect((await read(bytes)).xyz).toEqual(expected);
    expect((await read(bytes, [1])).xyz).toEqual(expected);
  });

  it.each([
    ['uchar', [0, 128, 255]],
    ['ushort', [0, 32896, 65535]],
    ['float', [0, 0.501, 1]],
    ['double', [0, 128, 255]],
  ] as const)('scales %s colours', async (type, channels) => {
    const vertex: PlyContent = {
      name: 'vertex',
      properties: [...single('float', 'x', 'y', 'z'), ...single(type, 'red', 'green', 'blue')],
      records: [[1, 2, 3, ...channels]],
    };
    expect((await read(plyBytes([vertex], { format }))).colour).toEqual([[0, 128, 255]]);
  });

  it('says that a file is cut off', async () => {
    const whole = plyBytes([XYZ], { format });
    const cut = whole.subarray(0, whole.length - 9);
    await expect(read(cut)).rejects.toMatchObject({ code: 'input/truncated' });
    const ofUnknownSize = { ...memorySource(cut, 'a.ply'), size: undefined };
    await expect(readAll(ofUnknownSize)).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('refuses a header that promises more than the file holds, before reading', async () => {
    const header = `ply\nformat ${format} 1.0\nelement vertex 180000000\nproperty float x\nproperty float y\nproperty float z\nend_header\n`;
    await expect(read(new TextEncoder().encode(header.padEnd(1024, '1 ')))).rejects.toMatchObject({
      code: 'input/truncated',
      detail: { announced: 180_000_000, offset: 1024 },
    });
  });

  it('refuses a header without points', async () => {
    await expect(read(plyBytes([{ ...XYZ, records: [] }], { format }))).rejects.toMatchObject({
      code: 'input/empty',
    });
  });
});

describe('PLY header', () => {
  const header = (lines: string) => new TextEncoder().encode(`ply\n${lines}\nend_header\n`);

  it.each([
    ['format ascii 1.0\nelement vertex many', 3],
    ['format middle_endian 1.0', 2],
    ['format ascii 1.0\nelement vertex 3\nproperty quad x', 4],
    ['format ascii 1.0\nproperty float x', 3],
    ['format ascii 1.0\nelement vertex 3\nsurprise', 4],
  ])('names the line it cannot read: %j', async (lines, line) => {
    await expect(read(header(lines))).rejects.toMatchObject({ code: 'input/malformed', detail: { line } });
  });

  it('tells what is missing', async () => {
    const flat = { ...XYZ, properties: single('double', 'x', 'y', 'w') };
    await expect(read(plyBytes([flat], { format: 'ascii' }))).rejects.toThrow('found x, y, w');
    await expect(read(header('element vertex 3'))).rejects.toThrow('a format line');
    await expect(read(new TextEncoder().encode('ply\nformat ascii 1.0\n'))).rejects.toMatchObject({
      code: 'input/truncated',
    });
  });

  it('takes long comments', async () => {
    const comments = Array.from({ length: 400 }, (_, i) => `comment ${i} ${'x'.repeat(200)}`);
    expect((await read(plyBytes([XYZ], { format: 'binary_big_endian', comments }))).xyz).toEqual(POINTS);
  });

  it('takes the newer names of types', async () => {
    const text =
      'ply\nformat ascii 1.0\nelement vertex 1\nproperty float64 x\nproperty int16 y\nproperty uint8 z\nend_header\n1.5 -2 3\n';
    expect((await read(new TextEncoder().encode(text))).xyz).toEqual([[1.5, -2, 3]]);
  });
});

it('names line and column of text among the points', async () => {
  const bytes = new TextDecoder().decode(plyBytes([XYZ], { format: 'ascii' })).replace('1000000', 'abc');
  await expect(read(new TextEncoder().encode(bytes))).rejects.toMatchObject({
    code: 'input/malformed',
    detail: { line: 9, column: 2, text: 'abc' },
  });
});

describe('files that plyfile wrote', () => {
  const fixture = (name: string) =>
    nodeSource(fileURLToPath(new URL(`../../../fixtures/foreign/${name}`, import.meta.url)));

  it.each(['plyfile-big-endian.ply', 'plyfile-text.ply'])('%s, to the last bit', async (name) => {
    const { xyz, colour, intensity } = await readAll(await fixture(name));
    const indices = Array.from({ length: 150 }, (_, i) => i);
    const place = (i: number) => [
      691000.1234 + ((i * 37) % 100) / 16,
      5334000.4567 + ((i * 53) % 90) / 32,
      512.789 + ((i * 11) % 50) / 20,
    ];
    expect(xyz).toEqual(indices.map(place));
    expect(colour).toEqual(indices.map((i) => [i % 256, (i * 5) % 256, (i * 7) % 256]));
    expect(intensity).toEqual(indices.map((i) => i / 256));
  });
});
