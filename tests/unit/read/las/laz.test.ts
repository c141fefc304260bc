import { readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { openScan } from '../../../../src/read/open-scan.ts';
import { memorySource, readAll } from '../memory-source.ts';

const fixture = (name: string) =>
  new Uint8Array(
    readFileSync(fileURLToPath(new URL(`../../../../fixtures/foreign/${name}`, import.meta.url))),
  );

const FIXED = fixture('chunks-1.laz');
const LAYERED = fixture('variable-7.laz');

function edited(file: Uint8Array, edit: (view: DataView, pointsBegin: number) => void): Uint8Array {
  const bytes = file.slice();
  const view = new DataView(bytes.buffer);
  edit(view, view.getUint32(96, true));
  return bytes;
}

/** Place of the chunk table. */
const tableOf = (view: DataView, begin: number) => Number(view.getBigInt64(begin, true));
/** Place of the record of LASzip in a file that has no other. */
const LASZIP = 227 + 54;

describe('chunks', () => {
  it('do not depend on how the bytes come', async () => {
    const whole = await readAll(memorySource(LAYERED, 'a.laz'));
    expect(await readAll(memorySource(LAYERED, 'a.laz', [1, 700, 13]))).toEqual(whole);
  });

  it('may be read again', async () => {
    const { cloud } = await openScan([memorySource(FIXED, 'a.laz')]);
    for (let turn = 0; turn < 2; turn++) {
      let count = 0;
      for await (const chunk of cloud.chunks(() => {}, 0)) count += chunk.count;
      expect(count).toBe(495);
    }
  });

  it('are found where the table stands behind its own place', async () => {
    const moved = edited(FIXED, (view, begin) => view.setBigInt64(begin, -1n, true));
    const bytes = new Uint8Array(moved.length + 8);
    bytes.set(moved);
    new DataView(bytes.buffer).setBigInt64(
      moved.length,
      BigInt(tableOf(new DataView(FIXED.buffer), new DataView(FIXED.buffer).getUint32(96, true))),
      true,
    );
    expect(await readAll(memorySource(bytes, 'a.laz'))).toEqual(await readAll(memorySource(FIXED, 'a.laz')));
  });
});

describe('files that lie', () => {
  it.each<[string, string, Uint8Array, (view: DataView, begin: number) => void]>([
    ['no LASzip record', 'input/malformed', FIXED, (view) => view.setUint16(227 + 18, 1, true)],
    ['another compressor', 'input/unknown-format', FIXED, (view) => view.setUint16(LASZIP, 1, true)],
    [
      'items of another version',
      'input/unknown-format',
      FIXED,
      (view) => view.setUint16(LASZIP + 38, 1, true),
    ],
    [
      'items of another format',
      'input/unknown-format',
      FIXED,
      (view) => {
        view.setUint8(104, 0x83);
        view.setUint16(105, 34, true);
      },
    ],
    [
      'records longer than what is compressed',
      'input/malformed',
      FIXED,
      (view) => view.setUint16(105, 65_044, true),
    ],
    [
      'a format without a decoder',
      'input/unknown-format',
      FIXED,
      (view) => {
        view.setUint8(104, 0x84);
        view.setUint16(105, 57, true);
      },
    ],
    [
      'a table before the points',
      'input/malformed',
      FIXED,
      (view, begin) => view.setBigInt64(begin, 5n, true),
    ],
    [
      'a table past the end',
      'input/truncated',
      FIXED,
      (view, begin) => view.setBigInt64(begin, 1n << 40n, true),
    ],
    ['a table at 2⁶²', 'input/malformed', FIXED, (view, begin) => view.setBigInt64(begin, 1n << 62n, true)],
    [
      'no chunks',
      'input/malformed',
      FIXED,
      (view, begin) => view.setUint32(tableOf(view, begin) + 4, 0, true),
    ],
    [
      '4 billion chunks',
      'input/malformed',
      FIXED,
      (view, begin) => view.setUint32(tableOf(view, begin) + 4, 4e9, true),
    ],
    [
      'fewer chunks than points',
      'input/malformed',
      FIXED,
      (view, begin) => view.setUint32(tableOf(view, begin) + 4, 2, true),
    ],
    ['more points than chunks hold', 'input/malformed', FIXED, (view) => view.setUint32(107, 5_000, true)],
    [
      'a table of other numbers',
      'input/malformed',
      LAYERED,
      (view, begin) => view.setUint32(tableOf(view, begin) + 8, 0xffffffff, true),
    ],
    [
      'hours of points in a few bytes',
      'input/malformed',
      FIXED,
      (view, begin) => {
        view.setUint32(107, 4e9, true);
        view.setUint32(LASZIP + 12, 4e9, true);
        view.setUint32(tableOf(view, begin) + 4, 1, true);
      },
    ],
    [
      'layers larger than their chunk',
      'input/malformed',
      LAYERED,
      (view, begin) => view.setUint32(begin + 8 + 36 + 4, 2 ** 31, true),
    ],
    [
      'a chunk of other points than the table says',
      'input/malformed',
      LAYERED,
      (view, begin) => view.setUint32(begin + 8 + 36, 7, true),
    ],
  ])('%s: %s', async (_, code, file, edit) => {
    const reading = readAll(memorySource(edited(file, edit), 'a.laz'));
    await expect(reading).rejects.toMatchObject({ code, hint: expect.stringMatching(/./) });
  });

  it.each([230, 300, 340, 2_000, FIXED.length - 30])('a file cut after %i bytes', async (length) => {
    const reading = readAll(memorySource(FIXED.subarray(0, length), 'a.laz'));
    await expect(reading).rejects.toMatchObject({
      code: expect.stringMatching(/input\/(truncated|malformed)/),
    });
  });
});
