import { gzipSync, zipSync } from 'fflate';
import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import { unpackedSource } from '../../../src/read/archive/unpacked-source.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { openScan } from '../../../src/read/open-scan.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { bytesOf, memorySource, readAll } from './memory-source.ts';

const ROWS = Array.from({ length: 3000 }, (_, i) => `${i % 60},${Math.floor(i / 60)},${(i * 7) % 5}\n`);
const CSV = bytesOf(`x,y,z\n${ROWS.join('')}`);
const half = (from: number, to: number) => bytesOf(`x,y,z\n${ROWS.slice(from, to).join('')}`);
const OPTIONS = resolveOptions({ unit: 'm' });

/** Bytes at an offset exchanged for others. */
function edited(bytes: Uint8Array, offset: number, ...values: number[]): Uint8Array {
  const copy = bytes.slice();
  copy.set(values, offset);
  return copy;
}

describe('a packed scan', () => {
  const plain = readAll(memorySource(CSV, 'a.csv'));

  it.each([
    ['gzip', 'scan.csv.gz', gzipSync(CSV)],
    ['ZIP', 'scan.zip', zipSync({ 'folder/scan.csv': CSV })],
    ['a ZIP that only stores', 'scan.zip', zipSync({ 'scan.csv': [CSV, { level: 0 }] })],
    ['gzip in a ZIP', 'scan.zip', zipSync({ 'scan.csv.gz': gzipSync(CSV) })],
  ])('%s is read as the file in it, whatever its name', async (_, name, bytes) => {
    expect(await readAll(memorySource(bytes, name, [777, 64]))).toEqual(await plain);
    expect(await readAll(memorySource(bytes, 'download'))).toEqual(await plain);
  });

  it('is the same scan', async () => {
    const { facts: _, ...unpacked } = await readScan(memorySource(CSV, 'a.csv'), OPTIONS);
    const { facts, ...packed } = await readScan(memorySource(gzipSync(CSV), 'a.csv.gz'), OPTIONS);
    expect(packed).toEqual(unpacked);
    expect(facts).toMatchObject({ name: 'a.csv.gz', format: 'csv', bytes: gzipSync(CSV).length });
  });

  it('tells its progress in bytes of the archive, never back', async () => {
    const bytes = zipSync({ 'a.csv': half(0, 1500), 'b.csv': half(1500, 3000) }, { level: 0 });
    const told: number[] = [];
    await readScan(memorySource(bytes, 'a.zip', [5000]), OPTIONS, {
      onProgress: ({ bytesRead, totalBytes }) => {
        expect(totalBytes).toBe(bytes.length);
        told.push(bytesRead);
      },
    });
    expect(told).toEqual([...told].sort((a, b) => a - b));
    expect(told[told.length - 1]).toBeLessThanOrEqual(bytes.length);
    expect(told[told.length - 1]).toBeGreaterThan(0.9 * bytes.length);
  });

  it('can be cancelled', async () => {
    const controller = new AbortController();
    const reading = readScan(memorySource(gzipSync(CSV, { level: 0 }), 'a.gz', [4096]), OPTIONS, {
      signal: controller.signal,
      onProgress: () => controller.abort(),
    });
    await expect(reading).rejects.toMatchObject({ code: 'cancelled' });
  });

  it('gives bytes in any order', async () => {
    const opened: ByteSource[] = [];
    const many = Uint8Array.from({ length: 3 << 20 }, (_, i) => (i * i) >> 9);
    const { openArchive } = await import('../../../src/read/archive/open-archive.ts');
    for (const bytes of [gzipSync(many), zipSync({ a: many }), zipSync({ a: [many, { level: 0 }] })]) {
      opened.push(...(await openArchive(memorySource(bytes, 'a'), bytes)));
    }
    expect(opened).toHaveLength(3);
    for (const source of opened) {
      for (const [begin, end] of [
        [0, 10],
        [2_500_000, 2_500_100],
        [70_000, 70_001],
        [many.length - 5, many.length + 5],
      ]) {
        expect(await source.slice(begin, end)).toEqual(many.slice(begin, end));
      }
      let total = 0;
      for await (const piece of source.stream()) total += piece.length;
      expect(total).toBe(many.length);
    }
  });
});

it('keeps less at hand of each file where there are many', async () => {
  const bytes = new Uint8Array(3 << 20);
  for (const [files, unpacked] of [
    [1, 1],
    [1_000, 2],
  ]) {
    let begun = 0;
    const source = unpackedSource({
      name: 'a',
      size: undefined,
      files,
      unpack: () => {
        begun++;
        return memorySource(bytes, 'a').stream();
      },
    });
    await source.slice(0, 1 << 16);
    await source.slice(1 << 17, 1 << 18);
    expect(begun).toBe(unpacked);
  }
});

describe('the clouds in a ZIP', () => {
  it('are one scan', async () => {
    const bytes = zipSync({ 'b/2.csv': half(1500, 3000), 'b/1.csv': half(0, 1500) });
    const whole = await readScan(memorySource(CSV, 'a.csv'), OPTIONS);
    const merged = await readScan(memorySource(bytes, 'tiles.zip'), OPTIONS);
    expect(merged.positions).toEqual(whole.positions);
    expect(merged.facts).toMatchObject({ name: 'tiles.zip', format: 'csv', pointsRead: 3000 });
    expect(merged.warnings).toEqual([]);
  });

  it('are found among other files, which are named', async () => {
    const bytes = zipSync({
      'readme.txt': bytesOf('A scan of the hall.\n'),
      '__MACOSX/._hall.csv': bytesOf('\0\0'),
      'hall.csv': CSV,
    });
    const { facts, warnings } = await readScan(memorySource(bytes, 'a.zip'), OPTIONS);
    expect(facts.pointsRead).toBe(3000);
    expect(warnings).toMatchObject([
      { code: 'read/files-passed-over', message: expect.stringContaining('readme.txt') },
    ]);
  });

  it('may be missing', async () => {
    const bytes = zipSync({ 'a.jpg': Uint8Array.of(0xff, 0xd8, 0xff, 0xe0), 'b.txt': bytesOf('Hello') });
    await expect(openScan([memorySource(bytes, 'a.zip')])).rejects.toMatchObject({
      code: 'input/unknown-format',
      message: expect.stringContaining('a.zip › a.jpg'),
    });
  });
});

describe('damaged archives', () => {
  const gzip = gzipSync(CSV);
  const zip = zipSync({ 'a.csv': CSV });
  const bomb = gzipSync(bytesOf(`x,y,z\n${'1,2,3\n'.repeat(14_000_000)}`), { level: 9 });

  it.each([
    ['cut gzip', gzip.subarray(0, gzip.length - 20), 'input/malformed'],
    ['gzip of other bytes', edited(gzip, 40, 1, 2, 3, 4, 5, 6, 7, 8), 'input/malformed'],
    ['empty gzip', gzipSync(new Uint8Array(0)), 'input/empty'],
    ['cut ZIP', zip.subarray(0, zip.length - 40), 'input/truncated'],
    ['ZIP with a broken directory', edited(zip, zip.length - 73, 0), 'input/malformed'],
    ['ZIP with broken bytes', edited(zip, 60, 255, 255, 255, 255, 255, 255), 'input/malformed'],
    ['empty ZIP', zipSync({}), 'input/empty'],
    ['ZIP that tells a wrong size', edited(zip, zip.length - 73 + 24, 7), 'input/malformed'],
    ['encrypted ZIP', edited(zip, zip.length - 73 + 8, 1), 'input/malformed'],
    ['bomb', bomb, 'input/too-large'],
  ])('%s', async (_, bytes, code) => {
    const reading = readScan(memorySource(bytes, 'a.gz'), OPTIONS);
    await expect(reading).rejects.toMatchObject({ code, hint: expect.stringMatching(/./) });
  });

  it('files that share their bytes', async () => {
    const stored = zipSync({ 'a.csv': [CSV, { level: 0 }] });
    const end = stored.length - 22;
    const begin = new DataView(stored.buffer).getUint32(end + 16, true);
    const entry = stored.subarray(begin, end);
    const bytes = Uint8Array.from([...stored.subarray(0, end), ...entry, ...stored.subarray(end)]);
    const view = new DataView(bytes.buffer, end + entry.length);
    view.setUint16(10, 2, true);
    view.setUint32(12, 2 * entry.length, true);
    await expect(openScan([memorySource(bytes, 'a.zip')])).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining('side by side'),
    });
  });

  it('archives in archives in archives', async () => {
    let bytes: Uint8Array = CSV;
    for (let i = 0; i < 5; i++) bytes = gzipSync(bytes);
    await expect(openScan([memorySource(bytes, 'a.gz')])).rejects.toMatchObject({ code: 'input/malformed' });
  });
});
