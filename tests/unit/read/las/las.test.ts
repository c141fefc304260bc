import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../../../src/core/options.ts';
import { openScan } from '../../../../src/read/open-scan.ts';
import { readScan } from '../../../../src/read/read-scan.ts';
import { memorySource, readAll } from '../memory-source.ts';
import { CORNERS, type LasContent, lasBytes } from './las-bytes.ts';

const CONTENT: LasContent = { format: 0, minor: 2, points: CORNERS };
const PLACES = CORNERS.map(({ at }) => at.map((value) => value * 0.01));
const OPTIONS = resolveOptions({});

function edited(edit: (view: DataView) => void, content = CONTENT): Uint8Array {
  const bytes = lasBytes(content);
  edit(new DataView(bytes.buffer));
  return bytes;
}

describe('points', () => {
  it.each(
    [0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10].flatMap((format) =>
      (format < 4 ? [0, 1, 2, 3, 4] : format < 6 ? [3, 4] : [4]).map((minor) => [format, minor] as const),
    ),
  )('format %i of LAS 1.%i', async (format, minor) => {
    const bytes = lasBytes({ format, minor, points: CORNERS, extraBytes: 3 });
    const all = await readAll(memorySource(bytes, 'a.las', [100, 7]));
    expect(all.xyz).toEqual(PLACES);
    expect(all.classification).toEqual(CORNERS.map((_, i) => i));
    all.intensity!.forEach((value, i) => void expect(value).toBeCloseTo((8191 * i) / 65_535, 6));
    const hasColour = [2, 3, 5, 7, 8, 10].includes(format);
    const colour = CORNERS.map((point) => point.colour!.map((value) => Math.round((value * 255) / 65_535)));
    expect(all.colour).toEqual(hasColour ? colour : undefined);
  });

  it.each([
    [5, 31],
    [6, 200],
  ])('format %i has classes up to %i', async (format, code) => {
    const points = [{ ...CORNERS[0], class: code }];
    const { classification } = await readAll(memorySource(lasBytes({ format, minor: 4, points }), 'a.las'));
    expect(classification).toEqual([code]);
  });

  it('takes 8-bit colours in 16 bits for what they are', async () => {
    const points = CORNERS.map((point, i) => ({ ...point, colour: [30 * i, 20 * i, 0] }));
    const { colour } = await readAll(memorySource(lasBytes({ format: 2, minor: 2, points }), 'a.las'));
    expect(colour).toEqual(points.map((point) => point.colour));
  });

  it('takes black and dark without exception for no colour and no intensity', async () => {
    const points = CORNERS.map(({ at }) => ({ at }));
    const scan = await readScan(memorySource(lasBytes({ format: 2, minor: 2, points }), 'a.las'), OPTIONS);
    expect(Object.keys(scan.attributes)).toEqual(['classification']);
  });

  it.each([1, 6])('leaves withheld points of format %i out and says so', async (format) => {
    const points = CORNERS.map((point, i) => ({ ...point, isWithheld: i === 0 || i === 3 || i === 7 }));
    const source = memorySource(lasBytes({ format, minor: 4, points }), 'a.las', [60]);
    expect((await readAll(source)).xyz).toEqual(PLACES.filter((_, i) => ![0, 3, 7].includes(i)));
    const scan = await readScan(source, OPTIONS);
    const isToldOnce = scan.warnings.filter(({ code }) => code === 'read/withheld-points');
    expect(isToldOnce).toMatchObject([{ message: expect.stringContaining('3 of 8') }]);
  });

  it('keeps millimetres of a large offset, and scales of its own for each axis', async () => {
    const offset = [691_000.5, 5_334_000.25, -3];
    const content = { ...CONTENT, scale: [0.001, 0.01, -0.1], offset };
    const { xyz } = await readAll(memorySource(lasBytes(content), 'a.las'));
    expect(xyz[7]).toEqual([400 * 0.001 + 691_000.5, 300 * 0.01 + 5_334_000.25, 250 * -0.1 - 3]);
  });

  it('reads the legacy count where a 1.4 writer filled in that alone', async () => {
    const bytes = edited(
      (view) => {
        view.setUint32(107, 5, true);
        view.setBigUint64(247, 0n, true);
      },
      { ...CONTENT, minor: 4 },
    );
    expect((await readAll(memorySource(bytes, 'a.las'))).xyz).toEqual(PLACES.slice(0, 5));
  });
});

describe('headers that lie', () => {
  it.each<[string, string, (view: DataView) => void, LasContent?]>([
    ['version', 'input/unknown-format', (view) => view.setUint8(25, 9)],
    ['header size', 'input/malformed', (view) => view.setUint16(94, 100, true)],
    ['points in the header', 'input/malformed', (view) => view.setUint32(96, 90, true)],
    ['points past the end', 'input/truncated', (view) => view.setUint32(96, 4e9, true)],
    ['format', 'input/malformed', (view) => view.setUint8(104, 11)],
    ['short records', 'input/malformed', (view) => view.setUint16(105, 19, true)],
    ['long records', 'input/truncated', (view) => view.setUint16(105, 60_000, true)],
    ['count', 'input/truncated', (view) => view.setUint32(107, 4e9, true)],
    ['no count', 'input/empty', (view) => view.setUint32(107, 0, true)],
    [
      'count of 64 bits',
      'input/malformed',
      (view) => view.setBigUint64(247, 2n ** 62n, true),
      { ...CONTENT, minor: 4 },
    ],
    ['scale 0', 'input/malformed', (view) => view.setFloat64(139, 0, true)],
    ['infinite scale', 'input/malformed', (view) => view.setFloat64(131, Number.POSITIVE_INFINITY, true)],
    ['offset NaN', 'input/malformed', (view) => view.setFloat64(155, Number.NaN, true)],
  ])('%s: %s', async (_, code, edit, content) => {
    const source = memorySource(edited(edit, content), 'a.las');
    await expect(openScan([source])).rejects.toMatchObject({
      code,
      message: expect.stringMatching(/byte \d+|counts none/),
      hint: expect.stringMatching(/./),
    });
  });

  it.each([4, 100, 226, 300])('a file cut after %i bytes', async (length) => {
    const source = memorySource(lasBytes({ ...CONTENT, minor: 4 }).subarray(0, length), 'a.las');
    await expect(openScan([source])).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('ends where the stream of unknown length does', async () => {
    const bytes = lasBytes(CONTENT).subarray(0, 300);
    const source = { ...memorySource(bytes, 'a.las'), size: undefined };
    await expect(readAll(source)).rejects.toMatchObject({ code: 'input/truncated', detail: { offset: 300 } });
  });

  it('survives records that are announced and not there', async () => {
    const bytes = edited((view) => view.setUint32(100, 4_000_000_000, true));
    expect((await readAll(memorySource(bytes, 'a.las'))).xyz).toEqual(PLACES);
    const extended = edited(
      (view) => {
        view.setBigUint64(235, 300n, true);
        view.setUint32(243, 4_000_000_000, true);
      },
      { ...CONTENT, minor: 4 },
    );
    expect((await readAll(memorySource(extended, 'a.las'))).xyz).toEqual(PLACES);
  });
});
