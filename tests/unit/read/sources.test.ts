import { execFileSync } from 'node:child_process';
import { mkdtempSync, rmSync, writeFileSync } from 'node:fs';
import { writeFile } from 'node:fs/promises';
import { createServer, type RequestListener, type Server } from 'node:http';
import type { AddressInfo } from 'node:net';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import { afterAll, afterEach, beforeAll, describe, expect, it, vi } from 'vitest';
import { nodeSource } from '../../../src/cli/node-source.ts';
import { blobSource } from '../../../src/read/bytes/blob-source.ts';
import { ByteCursor } from '../../../src/read/bytes/byte-cursor.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { urlSource } from '../../../src/read/bytes/url-source.ts';
import { memorySource } from './memory-source.ts';

/** Longer than one piece of any source. */
const CONTENT = Uint8Array.from({ length: 2_500_000 }, (_, i) => (i * 31 + (i >> 8)) & 255);

async function streamed(source: ByteSource): Promise<Buffer> {
  const pieces: Uint8Array[] = [];
  for await (const piece of source.stream()) pieces.push(piece);
  return Buffer.concat(pieces);
}

async function expectContent(source: ByteSource, content = CONTENT): Promise<void> {
  expect(Buffer.from(await source.slice(0, 10))).toEqual(Buffer.from(content.subarray(0, 10)));
  expect(Buffer.from(await source.slice(70_000, 70_010))).toEqual(
    Buffer.from(content.subarray(70_000, 70_010)),
  );
  expect(Buffer.from(await source.slice(content.length - 3, content.length + 50))).toEqual(
    Buffer.from(content.subarray(content.length - 3)),
  );
  for (let time = 0; time < 2; time++) expect((await streamed(source)).equals(content)).toBe(true);
}

describe('blobSource', () => {
  it('reads a file', async () => {
    const source = blobSource(new File([CONTENT], 'scan.ply'));
    expect(source).toMatchObject({ name: 'scan.ply', size: CONTENT.length });
    await expectContent(source);
  });

  it('says when a file has gone', async () => {
    const fail = () => Promise.reject(new DOMException('gone', 'NotReadableError'));
    const gone = {
      size: 10,
      slice: () => ({ arrayBuffer: fail }),
      stream: () => new ReadableStream({ pull: fail }),
    };
    const source = blobSource(gone as unknown as Blob, 'scan.ply');
    await expect(source.slice(2, 4)).rejects.toMatchObject({
      code: 'input/unreadable',
      detail: { offset: 2 },
    });
    await expect(streamed(source)).rejects.toMatchObject({ code: 'input/unreadable', detail: { offset: 0 } });
  });

  it('lets go of a file that is not read to its end', async () => {
    const cancel = vi.fn();
    const stream = () => new ReadableStream({ pull: (to) => to.enqueue(new Uint8Array(4)), cancel });
    const source = blobSource({ size: 100, stream } as unknown as Blob, 'scan.ply');
    for await (const piece of source.stream()) {
      expect(piece).toHaveLength(4);
      break;
    }
    expect(cancel).toHaveBeenCalledOnce();
  });
});

describe('nodeSource', () => {
  const folder = mkdtempSync(join(tmpdir(), 'grundriss-'));
  afterAll(() => rmSync(folder, { recursive: true }));

  it('reads a file', async () => {
    writeFileSync(join(folder, 'scan.ply'), CONTENT);
    const source = await nodeSource(join(folder, 'scan.ply'));
    expect(source).toMatchObject({ name: 'scan.ply', size: CONTENT.length });
    await expectContent(source);
  });

  it('says what it cannot read', async () => {
    await expect(nodeSource(join(folder, 'missing.ply'))).rejects.toMatchObject({ code: 'input/unreadable' });
    await expect(nodeSource(folder)).rejects.toThrow('it is a folder');
  });

  describe.skipIf(process.platform === 'win32')('of a pipe', () => {
    const pipe = join(folder, 'pipe');
    const fill = () => {
      execFileSync('mkfifo', ['-m', '600', pipe]);
      return writeFile(pipe, CONTENT);
    };
    afterEach(() => rmSync(pipe));

    it('keeps what the pipe gives once', async () => {
      const written = fill();
      const source = await nodeSource(pipe);
      await written;
      expect(source).toMatchObject({ name: 'pipe', size: CONTENT.length });
      await expectContent(source);
      await expectContent(source);
    });

    it('stops when cancelled', async () => {
      const written = fill().catch(() => undefined);
      await expect(nodeSource(pipe, AbortSignal.abort())).rejects.toMatchObject({ code: 'cancelled' });
      await written;
    });
  });
});

describe('urlSource', () => {
  let server: Server;
  let base = '';
  let listener: RequestListener;
  const requests: (string | undefined)[] = [];

  const whole: RequestListener = (_, response) => {
    response.writeHead(200, { 'Content-Length': CONTENT.length }).end(CONTENT);
  };
  const ranges: RequestListener = (request, response) => {
    requests.push(request.headers.range);
    const match = /bytes=(\d+)-(\d+)/.exec(request.headers.range ?? '');
    if (!match) return whole(request, response);
    const [begin, last] = [Number(match[1]), Math.min(Number(match[2]), CONTENT.length - 1)];
    response
      .writeHead(206, { 'Content-Range': `bytes ${begin}-${last}/${CONTENT.length}` })
      .end(CONTENT.subarray(begin, last + 1));
  };

  beforeAll(async () => {
    server = createServer((request, response) => listener(request, response));
    await new Promise<void>((resolve) => server.listen(0, '127.0.0.1', resolve));
    base = `http://127.0.0.1:${(server.address() as AddressInfo).port}`;
  });
  afterEach(() => void requests.splice(0));
  afterAll(() => void server.close());

  it('reads in ranges where the server knows them', async () => {
    listener = ranges;
    const source = urlSource(`${base}/scans/my%20scan.ply?x=1#top`);
    expect(source).toMatchObject({ name: 'my scan.ply', size: undefined });
    await expectContent(source);
    expect(source.size).toBe(CONTENT.length);
    expect(requests).toContain('bytes=70000-70009');
  });

  it('reads from the start where it does not', async () => {
    listener = whole;
    const source = urlSource(`${base}/scan.ply`);
    await expectContent(source);
    expect(source.size).toBe(CONTENT.length);
  });

  it('trusts no size of an encoded body', async () => {
    listener = (_, response) =>
      response.writeHead(200, { 'Content-Encoding': 'identity', 'Content-Length': 3 }).end('abc');
    const source = urlSource(`${base}/scan.ply`);
    expect(Buffer.from(await source.slice(0, 9)).toString()).toBe('abc');
    expect(source.size).toBeUndefined();
  });

  it('names URL and status', async () => {
    listener = (_, response) => response.writeHead(404).end('no');
    await expect(urlSource(`${base}/gone.ply`).slice(0, 9)).rejects.toMatchObject({
      code: 'environment/network',
      message: expect.stringContaining(`${base}/gone.ply, found: HTTP 404`),
      detail: { status: 404 },
    });
  });

  it('says when an answer is shorter than it announces', async () => {
    // As a service worker may answer; a platform's own fetch notices by itself.
    const answer = () => new Response('abc', { headers: { 'Content-Length': '1000' } });
    vi.stubGlobal('fetch', async () => answer());
    await expect(streamed(urlSource('https://a.example/scan.ply')))
      .rejects.toMatchObject({
        code: 'environment/network',
        message: expect.stringContaining('broke after 3 of 1000 bytes'),
      })
      .finally(() => vi.unstubAllGlobals());
  });

  it('says when the connection breaks', async () => {
    listener = (_, response) => {
      response.writeHead(200, { 'Content-Length': 1000 });
      response.write('abc');
      setTimeout(() => response.destroy(), 50);
    };
    await expect(streamed(urlSource(`${base}/scan.ply`))).rejects.toMatchObject({
      code: 'environment/network',
      message: expect.stringContaining('broke after 3 of 1000 bytes'),
    });
    await expect(streamed(urlSource('http://127.0.0.1:1/scan.ply'))).rejects.toMatchObject({
      code: 'environment/network',
    });
  });

  it('stops when cancelled', async () => {
    listener = (_, response) => void response.writeHead(200).write('abc');
    const controller = new AbortController();
    const reading = streamed(urlSource(`${base}/scan.ply`, controller.signal));
    setTimeout(() => controller.abort(), 50);
    await expect(reading).rejects.toMatchObject({ code: 'cancelled' });
    server.closeAllConnections();
  });
});

describe('ByteCursor', () => {
  it('fills and skips over the pieces', async () => {
    const received: number[] = [];
    const cursor = new ByteCursor(memorySource(CONTENT.subarray(0, 100), 'a', [7, 1, 20]).stream(), (n) =>
      received.push(n),
    );
    expect(await cursor.fill(10)).toBe(true);
    expect(cursor.available).toBeGreaterThanOrEqual(10);
    cursor.position += 3;
    expect(cursor.offset).toBe(3);
    expect(await cursor.skip(50)).toBe(true);
    expect(cursor.offset).toBe(53);
    expect(await cursor.fill(1)).toBe(true);
    expect(cursor.bytes[cursor.position]).toBe(CONTENT[53]);
    expect(await cursor.skip(47)).toBe(true);
    expect(await cursor.fill(1)).toBe(false);
    expect(await cursor.skip(1)).toBe(false);
    expect(received.at(-1)).toBe(100);
  });

  it('closes its source', async () => {
    let isClosed = false;
    async function* pieces() {
      try {
        yield CONTENT;
      } finally {
        isClosed = true;
      }
    }
    const cursor = new ByteCursor(pieces(), () => {});
    await cursor.fill(1);
    await cursor.close();
    expect(isClosed).toBe(true);
  });
});
