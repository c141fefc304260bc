import { readdirSync, readFileSync } from 'node:fs';
import { fileURLToPath } from 'node:url';
import { gzipSync, zipSync } from 'fflate';
import { expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import type { ByteSource } from '../../../src/read/bytes/source.ts';
import { READ_FORMAT_NAMES } from '../../../src/read/formats.ts';
import { type ReadStatus, readScan } from '../../../src/read/read-scan.ts';
import { memorySource } from './memory-source.ts';
import { ptxHeader } from './ptx-text.ts';

const folder = fileURLToPath(new URL('../../../fixtures/foreign/', import.meta.url));
/** Small pieces, as a slow disk hands them out. */
const source = (bytes: string | Uint8Array, name: string) => memorySource(bytes, name, [1000, 77]);
const fixture = (name: string) => source(new Uint8Array(readFileSync(folder + name)), name);
const rows = Array.from({ length: 400 }, (_, i) => `${i % 20} ${(i * 7) % 19} ${(i * 3) % 5}\n`).join('');
const ptx = ptxHeader(20, 20) + rows.replaceAll('\n', ' 0.5\n');
const bytes = new TextEncoder().encode(rows);

const foreign = readdirSync(folder).filter((name) => !name.endsWith('.py'));
/** Coarser than its default, so that meshes are sampled with fewer points: progress goes by bytes. */
const OPTIONS = resolveOptions({ resolution: 0.05 });

const CASES: readonly (readonly [string, readonly ByteSource[]])[] = [
  ...foreign.map((name) => [name, [fixture(name)]] as const),
  ['table.csv', [source(rows, 'table.csv')]],
  ['grid.ptx', [source(ptx, 'grid.ptx')]],
  ['several points.pts', [source(`400\n${rows}`, 'points.pts')]],
  ['table.csv.gz', [source(gzipSync(bytes), 'table.csv.gz')]],
  [
    'tables.zip',
    [source(zipSync({ 'a.csv': bytes, 'b.csv': [bytes, { level: 0 }], 'c.txt': bytes }), 'tables.zip')],
  ],
  ['several files', [source(rows, 'a.csv'), fixture('two-scans.e57'), fixture('chunks-6.laz')]],
];

const seen = new Set<string>();

it.each(CASES)('%s: progress never goes back and ends at the whole', async (_, sources) => {
  const states: ReadStatus[] = [];
  const scan = await readScan(sources, OPTIONS, { onProgress: (status) => states.push(status) });
  seen.add(scan.facts.format);
  const shares = states.map(({ bytesRead, totalBytes }) => bytesRead / totalBytes!);
  expect(shares.length).toBeGreaterThan(1);
  expect(shares.every((share) => share >= 0 && share <= 1)).toBe(true);
  expect(new Set(states.map(({ totalBytes }) => totalBytes)).size).toBe(1);
  const reads = states.map(({ bytesRead }) => bytesRead);
  expect(reads).toEqual(reads.toSorted((a, b) => a - b));
  expect(shares.at(-1)).toBe(1);
});

it('looks at every format', () => {
  expect([...seen].sort()).toEqual(expect.arrayContaining([...READ_FORMAT_NAMES].sort()));
});
