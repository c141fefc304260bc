/**
 * `METHOD FILE`: one way to read a file, timed apart from all others; prints a {@link ReadRun} as one JSON line. Bundled
 * before it runs, as the product is.
 */
import { readFile } from 'node:fs/promises';
import { createRequire } from 'node:module';
import { resolve } from 'node:path';
import { nodeSource } from '../../src/cli/node-source.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { readScan } from '../../src/read/read-scan.ts';

/** What a method's own process says of itself. */
export interface ReadRun {
  /** Best of its runs, and the least processor time: other work hardly lengthens that. */
  readonly ms: number;
  readonly cpuMs: number;
  /** Of the whole process. */
  readonly peakMB: number;
  /** Points, or bytes for raw reading. */
  readonly found: number;
}

const RUNS = 5;
const ENOUGH_MS = 8_000;
/** Of a run's time the next one is cancelled after this part; both have their code compiled by a first one. */
const CANCELLED_SHARE = 3;

const [method, path, peers] = process.argv.slice(2);

/** Each returns how many points it found; `cancel` how many ms after it was cancelled a run ended. */
const methods: Record<string, () => Promise<number>> = {
  async ours() {
    const { facts } = await readScan(await nodeSource(path), resolveOptions({}));
    return facts.pointsRead;
  },
  async cancel() {
    const source = await nodeSource(path);
    const abort = new AbortController();
    await readScan(source, resolveOptions({}));
    const start = performance.now();
    await readScan(source, resolveOptions({}));
    const due = performance.now() + (performance.now() - start) / CANCELLED_SHARE;
    // A timer comes late where the reader never lets go, and that counts.
    setTimeout(() => abort.abort(), due - performance.now());
    const end = await readScan(source, resolveOptions({}), { signal: abort.signal }).catch(
      ({ code }) => code,
    );
    if (end !== 'cancelled') throw new Error(`Expected reading to be cancelled, found ${end}.`);
    return performance.now() - due;
  },
  async raw() {
    let bytes = 0;
    for await (const piece of (await nodeSource(path)).stream()) bytes += piece.length;
    return bytes;
  },
  async 'three PLYLoader'() {
    const { PLYLoader } = await import('three/examples/jsm/loaders/PLYLoader.js');
    const { buffer, byteOffset, byteLength } = await readFile(path);
    const bytes = buffer.slice(byteOffset, byteOffset + byteLength) as ArrayBuffer;
    return new PLYLoader().parse(bytes).getAttribute('position').count;
  },
  async 'loaders.gl'() {
    const { parse } = requirePeer('@loaders.gl/core');
    if (path.endsWith('.csv')) {
      const { CSVLoader } = requirePeer('@loaders.gl/csv');
      const table = await parse(await readFile(path, 'utf8'), CSVLoader, { worker: false });
      return table.data.length;
    }
    const { PLYLoader } = requirePeer('@loaders.gl/ply');
    const { buffer, byteOffset, byteLength } = await readFile(path);
    const bytes = buffer.slice(byteOffset, byteOffset + byteLength);
    const { attributes } = await parse(bytes, PLYLoader, { worker: false });
    return attributes.POSITION.value.length / 3;
  },
  async papaparse() {
    const text = await readFile(path, 'utf8');
    const options = { header: false, dynamicTyping: true, skipEmptyLines: true };
    return requirePeer('papaparse').parse(text, options).data.length - 1;
  },
};

function requirePeer(name: string) {
  return createRequire(resolve(peers, 'package.json'))(name);
}

let ms = Number.POSITIVE_INFINITY;
let cpuMs = Number.POSITIVE_INFINITY;
let found = 0;
const begin = performance.now();
for (let i = 0; i < RUNS && performance.now() - begin < ENOUGH_MS; i++) {
  const used = process.cpuUsage();
  const start = performance.now();
  const now = await methods[method]();
  // The longest wait; the others always find the same.
  found = Math.max(found, now);
  ms = Math.min(ms, performance.now() - start);
  const { user, system } = process.cpuUsage(used);
  cpuMs = Math.min(cpuMs, (user + system) / 1000);
}
const run: ReadRun = { ms, cpuMs, peakMB: process.resourceUsage().maxRSS / 1024, found };
console.log(JSON.stringify(run));
