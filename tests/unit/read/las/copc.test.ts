import { readFileSync } from 'node:fs';
import { createServer, type RequestListener } from 'node:http';
import type { AddressInfo } from 'node:net';
import { fileURLToPath } from 'node:url';
import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../../../src/core/options.ts';
import type { ByteSource } from '../../../../src/read/bytes/source.ts';
import { urlSource } from '../../../../src/read/bytes/url-source.ts';
import { openLaz } from '../../../../src/read/las/open-laz.ts';
import { openScan } from '../../../../src/read/open-scan.ts';
import { readScan } from '../../../../src/read/read-scan.ts';
import { memorySource } from '../memory-source.ts';

const path = fileURLToPath(new URL('../../../../fixtures/foreign/octree.copc.laz', import.meta.url));
const FILE = new Uint8Array(readFileSync(path));
/** Level 0: every eighth point; level 2: every fourth but three; points 99, 199, … are withheld. */
const LEVELS = [0, 1, 2].map(
  (level) =>
    Array.from({ length: 500 }, (_, i) => (i % 8 === 0 ? 0 : i % 4 === 3 ? 2 : 1)).filter(
      (of, i) => of <= level && i % 100 !== 99,
    ).length,
);
const INFO = 375 + 54;
const info = new DataView(FILE.buffer, FILE.byteOffset + INFO);
const ROOT = Number(info.getBigUint64(40, true));
const ROOT_BYTES = Number(info.getBigUint64(48, true));

/** A source that notes what is asked of it. */
function watched(bytes: Uint8Array): ByteSource & { fetched: number; isStreamed: boolean } {
  const memory = memorySource(bytes, 'a.copc.laz');
  return {
    ...memory,
    fetched: 0,
    isStreamed: false,
    async slice(begin, end) {
      const piece = await memory.slice(begin, end);
      this.fetched += piece.length;
      return piece;
    },
    stream() {
      this.isStreamed = true;
      return memory.stream();
    },
  };
}

async function countPoints(source: ByteSource, spacing: number): Promise<number> {
  const { cloud } = await openScan([source]);
  let count = 0;
  for await (const chunk of cloud.chunks(() => {}, spacing)) count += chunk.count;
  return count;
}

function edited(edit: (view: DataView) => void): Uint8Array {
  const bytes = FILE.slice();
  edit(new DataView(bytes.buffer));
  return bytes;
}

describe('levels', () => {
  // The root's points lie 0.5 m apart.
  it.each([
    [1, 0],
    [0.5, 0],
    [0.49, 1],
    [0.25, 1],
    [0.2, 2],
    [0.001, 2],
    [0, 2],
  ])('spacing %d takes level %i and those above', async (spacing, level) => {
    expect(await countPoints(memorySource(FILE, 'a.laz'), spacing)).toBe(LEVELS[level]);
  });

  it('fetches no more than the levels asked for', async () => {
    const [coarse, fine] = [watched(FILE), watched(FILE)];
    const { cloud } = await openScan([coarse]);
    const before = coarse.fetched;
    for await (const _ of cloud.chunks(() => {}, 0.5));
    await countPoints(fine, 0.1);
    expect(coarse.isStreamed || fine.isStreamed).toBe(false);
    // Root page and root node.
    expect(coarse.fetched - before).toBeLessThan(4_000);
    expect(fine.fetched).toBeGreaterThan(15_000);
  });

  it('is the LAZ file that it is, where slices cost as much', async () => {
    const source = watched(FILE);
    expect(await countPoints({ ...source, isSequential: true }, 1)).toBe(LEVELS[2]);
    const { xyz } = await gather(memorySource(FILE, 'a'), 'laz');
    expect((await gather(memorySource(FILE, 'a'), 'copc')).xyz).toEqual(xyz);
  });

  it('becomes a scan with true progress', async () => {
    const seen: number[] = [];
    const scan = await readScan(memorySource(FILE, 'a.copc.laz'), resolveOptions({ resolution: 0.5 }), {
      onProgress: ({ bytesRead }) => seen.push(bytesRead),
    });
    expect(scan).toMatchObject({ unit: 'm', crs: 'EPSG:25832', cellSize: 0.5 });
    expect(scan.facts).toMatchObject({ format: 'copc', pointsRead: LEVELS[0] });
    expect(seen.at(-1)).toBe(FILE.length);
    expect(seen).toEqual([...seen].sort((a, b) => a - b));
  });
});

async function gather(source: ByteSource, as: 'laz' | 'copc') {
  const cloud = as === 'laz' ? await openLaz(source) : (await openScan([source])).cloud;
  const xyz: string[] = [];
  for await (const chunk of cloud.chunks(() => {}, 0.001))
    for (let i = 0; i < chunk.count; i++) xyz.push(chunk.xyz.subarray(3 * i, 3 * i + 3).join());
  return { xyz: xyz.sort() };
}

/** The file with so many bytes between points and octree that the first request does not fetch all. */
const SPREAD_BYTES = 400_000;
function spreadFile(): Uint8Array {
  const gap = Number(new DataView(FILE.buffer).getBigUint64(235, true));
  const bytes = new Uint8Array(FILE.length + SPREAD_BYTES);
  bytes.set(FILE.subarray(0, gap));
  bytes.set(FILE.subarray(gap), gap + SPREAD_BYTES);
  const view = new DataView(bytes.buffer);
  const move = (at: number) =>
    view.setBigUint64(at, view.getBigUint64(at, true) + BigInt(SPREAD_BYTES), true);
  move(235);
  move(INFO + 40);
  // The root page: its first entry is the root itself, the others are pages.
  for (let at = 32; at < ROOT_BYTES; at += 32) move(ROOT + SPREAD_BYTES + at + 16);
  return bytes;
}

async function serving<T>(listener: RequestListener, work: (url: string) => Promise<T>): Promise<T> {
  const server = createServer(listener);
  await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
  try {
    return await work(`http://127.0.0.1:${(server.address() as AddressInfo).port}/a.copc.laz`);
  } finally {
    server.close();
  }
}

describe('over HTTP', () => {
  const file = spreadFile();

  it('fetches ranges only', async () => {
    let sent = 0;
    const count = await serving(
      ({ headers }, response) => {
        const [begin, last] = /=(\d+)-(\d+)/.exec(headers.range!)!.slice(1).map(Number);
        const piece = file.subarray(begin, last + 1);
        sent += piece.length;
        response.writeHead(206, { 'Content-Range': `bytes ${begin}-${last}/${file.length}` }).end(piece);
      },
      (url) => countPoints(urlSource(url), 0.01),
    );
    expect(count).toBe(LEVELS[2]);
    expect(sent).toBeLessThan(150_000);
  });

  it('streams the file where the server knows no ranges', async () => {
    let requests = 0;
    const count = await serving(
      (_, response) => {
        requests++;
        response.writeHead(200, { 'Content-Length': file.length }).end(file);
      },
      (url) => countPoints(urlSource(url), 0.01),
    );
    expect(count).toBe(LEVELS[2]);
    expect(requests).toBeLessThan(8);
  });
});

describe('octrees that lie', () => {
  const lastOfRoot = ROOT + ROOT_BYTES - 32;
  it.each<[string, (view: DataView) => void]>([
    ['a spacing of 0', (view) => view.setFloat64(INFO + 32, 0, true)],
    ['a spacing that is none', (view) => view.setFloat64(INFO + 32, Number.NaN, true)],
    ['a root page of odd size', (view) => view.setBigUint64(INFO + 48, 33n, true)],
    ['a root page of no bytes', (view) => view.setBigUint64(INFO + 48, 0n, true)],
    ['a root page larger than the file', (view) => view.setBigUint64(INFO + 48, 1n << 40n, true)],
    ['a page that leads to itself', (view) => view.setBigUint64(lastOfRoot + 16, BigInt(ROOT), true)],
    ['a node told twice', (view) => putNode(view, ROOT + 32, ROOT)],
    ['a node past the end', (view) => view.setBigUint64(ROOT + 16, 1n << 40n, true)],
    ['a node of more points than there are', (view) => view.setInt32(ROOT + 28, 2 ** 30, true)],
    ['a node of negative size', (view) => view.setInt32(ROOT + 24, -5, true)],
    ['points a node has not', (view) => view.setInt32(ROOT + 28, 5, true)],
    ['a cell above the root', (view) => view.setInt32(ROOT, -1, true)],
    ['a cell of level a thousand', (view) => view.setInt32(ROOT, 1000, true)],
  ])('%s', async (_, edit) => {
    const reading = countPoints(memorySource(edited(edit), 'a.copc.laz'), 0.01);
    await expect(reading).rejects.toMatchObject({
      code: 'input/malformed',
      hint: expect.stringMatching(/./),
    });
  });

  it('pages in a circle, of a file that tells no size', async () => {
    const bytes = edited((view) => {
      for (let at = ROOT; at < ROOT + ROOT_BYTES; at += 32) {
        view.setBigUint64(at + 16, BigInt(ROOT), true);
        view.setInt32(at + 24, ROOT_BYTES, true);
        view.setInt32(at + 28, -1, true);
      }
    });
    const source = { ...watched(bytes), size: undefined };
    await expect(countPoints(source, 0.01)).rejects.toMatchObject({ code: 'input/malformed' });
    expect(source.fetched).toBeLessThan(10 * bytes.length);
  });

  it.each([ROOT + 40, ROOT - 60, 5_000])('a file cut after %i bytes', async (length) => {
    const reading = countPoints(memorySource(FILE.subarray(0, length), 'a.copc.laz'), 0.01);
    await expect(reading).rejects.toMatchObject({
      code: expect.stringMatching(/input\/(truncated|malformed)/),
    });
  });
});

/** Copies the 32 bytes of one entry over another, and makes its neighbours' points room in the count. */
function putNode(view: DataView, to: number, from: number): void {
  for (let i = 0; i < 32; i++) view.setUint8(to + i, view.getUint8(from + i));
}
