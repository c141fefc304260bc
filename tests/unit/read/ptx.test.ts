import { describe, expect, it } from 'vitest';
import { detectFormat } from '../../../src/read/formats.ts';
import { bytesOf, memorySource, readWhole } from './memory-source.ts';
import { ptxHeader } from './ptx-text.ts';

const read = (text: string, pieces?: number[]) => readWhole(memorySource(text, 'a.ptx', pieces));
/** Rows are multiplied from the left: x becomes y, y becomes −x. */
const TURNED = [
  [0, 1, 0],
  [-1, 0, 0],
  [0, 0, 1],
  [691_000.25, 5_336_000.5, 512],
];
const GREY = `${ptxHeader(2, 2)}1 2 3 0.5\r\n0 0 0 0.500000\r\n-0.0 0 .0 0\r\n4 5 6 0.25\r\n`;
const COLOURED = `${ptxHeader(3, 1, TURNED)}1 2 3 1 10 20 30\n0 0 0 0.5\n0 2 3 0 0 0 255\n`;

describe('PTX', () => {
  it('is recognised by its header, whatever the name', () => {
    expect(detectFormat(bytesOf(GREY), 'a.txt')).toBe('ptx');
    expect(detectFormat(bytesOf('2\n2\n0 0 0\n'), 'a.ptx')).toBe('ptx');
    expect(detectFormat(bytesOf('2\n1 2 3\n4 5 6\n'), 'a.pts')).toBe('pts');
  });

  it('has rows of zeros passed over and uncounted', async () => {
    for (const pieces of [[1000], [7, 1]]) {
      const { xyz, intensity, colour, station, cloud } = await read(GREY, pieces);
      expect(xyz).toEqual([
        [1, 2, 3],
        [4, 5, 6],
      ]);
      expect(intensity).toEqual([0.5, 0.25]);
      expect([colour, station, cloud.warnings]).toEqual([undefined, [0, 0], []]);
    }
  });

  it('stands in the places its matrices give, in float64, several scans in one file', async () => {
    const { xyz, colour, station, cloud } = await read(`${COLOURED}\n${GREY}${COLOURED}`);
    const turned = [
      [690_998.25, 5_336_001.5, 515],
      [690_998.25, 5_336_000.5, 515],
    ];
    expect(xyz).toEqual([...turned, [1, 2, 3], [4, 5, 6], ...turned]);
    const tones = [
      [10, 20, 30],
      [0, 0, 255],
    ];
    expect(colour).toEqual([...tones, [0, 0, 0], [0, 0, 0], ...tones]);
    expect(station).toEqual([0, 0, 1, 1, 2, 2]);
    expect(cloud.stations).toEqual([TURNED[3], [0, 0, 0], TURNED[3]]);
    for await (const { count } of cloud.chunks(() => {}, 0)) expect(count).toBe(2);
    expect(cloud.stations).toHaveLength(3);
  });

  it.each([
    ['columns of words', GREY.replace('2\r\n', 'two\r\n'), 'input/malformed', 'line 1 of'],
    ['negative rows', GREY.replace('2\r\n2', '2\r\n-2'), 'input/malformed', 'line 2 of'],
    ['a short line', GREY.replace('0 1 0\r\n', '0 1\r\n'), 'input/malformed', '3 numbers in line 5'],
    [
      'a matrix on its side',
      ptxHeader(1, 1).replace('1 0 0 0\r\n', '1 0 0 7\r\n'),
      'input/malformed',
      'line 7',
    ],
    ['more rows than cells', `${GREY}7 8 9 0\r\n${GREY}`, 'input/malformed', 'in line 15'],
    ['a word in a row', GREY.replace('4 5', '4 five'), 'input/malformed', 'line 14, column 2'],
    ['fewer rows than cells', GREY.replace('4 5 6 0.25\r\n', ''), 'input/truncated', '4 points'],
    ['half a header', `${GREY}3\r\n1\r\n`, 'input/truncated', '10 lines'],
    ['cells beyond number', GREY.replace('2\r\n', '1e300\r\n'), 'input/truncated', 'points'],
  ])('with %s is refused', async (_, text, code, message) => {
    await expect(read(text)).rejects.toMatchObject({ code, message: expect.stringContaining(message) });
  });
});
