import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { detectFormat } from '../../../src/read/formats.ts';
import { bytesOf, memorySource, readWhole } from './memory-source.ts';

const read = (text: string, pieces?: number[]) => readWhole(memorySource(text, 'a.pts', pieces));

describe('PTS', () => {
  it('is recognised by the lone number before its rows; without it, it is a text table', () => {
    expect(detectFormat(bytesOf('2\n1 2 3\n4 5 6\n'), 'a.txt')).toBe('pts');
    expect(detectFormat(bytesOf('\n 2 \n1\t2\t3\t-5\n'), 'a')).toBe('pts');
    expect(detectFormat(bytesOf('1 2 3\n4 5 6\n'), 'a.pts')).toBe('csv');
    expect(detectFormat(bytesOf('2\n1,2,3\n4,5,6\n'), 'a.csv')).toBe('csv');
    expect(detectFormat(bytesOf('2\n1 2 3 4 5\n'), 'a.csv')).toBe('csv');
  });

  it('written by Open3D', async () => {
    const path = fileURLToPath(new URL('../../../fixtures/foreign/open3d.pts', import.meta.url));
    const { xyz, colour, intensity } = await readWhole(await nodeSource(path));
    expect(xyz).toEqual(
      [0, 2.5].flatMap((z) => [
        [0, 0, z],
        [4, 0, z],
        [4, 3, z],
        [0, 3, z],
      ]),
    );
    expect(colour).toEqual(xyz.map((_, i) => [10 * i, 20 * i, 30 * i]));
    expect(intensity).toEqual(xyz.map(() => 0));
  });

  it('has a number before each of its scans', async () => {
    const text = '2\r\n1 2 3\r\n4 5 6\r\n\r\n0\r\n1\r\n7 8 9';
    for (const pieces of [[1000], [5, 1]]) {
      const { xyz, cloud } = await read(text, pieces);
      expect(xyz).toEqual([
        [1, 2, 3],
        [4, 5, 6],
        [7, 8, 9],
      ]);
      expect(cloud.warnings).toEqual([]);
    }
  });

  it.each([
    ["Leica's", [-2048, 2047, 0], [0, 1, 2048 / 4095]],
    ["Leica's without negatives", [0, 2047], [2048 / 4095, 1]],
    ['bytes', [0, 255, 51], [0, 1, 0.2]],
    ['shares', [0, 1, 0.25], [0, 1, 0.25]],
    ['what fits none', [0, 65_535], [0, 65_535]],
  ])('maps intensity to 0 … 1: %s', async (_, values, expected) => {
    const { intensity } = await read(
      `${values.length}\n${values.map((value) => `1 2 3 ${value}\n`).join('')}`,
    );
    expect(intensity).toEqual(expected.map(Math.fround));
  });

  it.each([
    ['x y z r g b', '1 2 3 10 20 30', undefined],
    ['x y z i r g b', '1 2 3 -2048 10 20 30', [0]],
    ['x y z r g b i', '1 2 3 10 20 30 -2048', [0]],
  ])('takes %s', async (_, row, expected) => {
    const { xyz, colour, intensity } = await read(`1\n${row}\n`);
    expect({ xyz, colour, intensity }).toEqual({
      xyz: [[1, 2, 3]],
      colour: [[10, 20, 30]],
      intensity: expected,
    });
  });

  it('reads more points than it announces, with a warning', async () => {
    const { xyz, cloud } = await read('1\n1 2 3\n4 5 6\n7 8 9\n');
    expect(xyz).toHaveLength(3);
    expect(cloud.warnings).toMatchObject([
      { code: 'read/more-than-announced', message: expect.stringContaining('from line 3 on') },
    ]);
    for await (const { count } of cloud.chunks(() => {}, 0)) expect(count).toBe(3);
    expect(cloud.warnings).toHaveLength(1);
  });

  it.each([
    ['fewer points than announced', '3\n1 2 3\n4 5 6\n', 'input/truncated', '3 points'],
    ['a number too early', '3\n1 2 3\n1\n4 5 6\n', 'input/malformed', 'line 3'],
    ['a row cut off', '2\n1 2 3\n4 5', 'input/truncated', 'line 3'],
    ['no table at all', 'points\nhere\n', 'input/malformed', 'points'],
  ])('with %s is refused', async (_, text, code, message) => {
    await expect(read(text)).rejects.toMatchObject({ code, message: expect.stringContaining(message) });
  });
});
