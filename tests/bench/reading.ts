import { execFile } from 'node:child_process';
import { join } from 'node:path';
import { promisify } from 'node:util';
import { bundleChild } from './child-bundle.ts';
import { type CloudFile, cacheFolder, cloudFile, foreignFile } from './clouds.ts';
import type { ReadRun } from './read-child.ts';
import type { Figure } from './table.ts';

const POINTS = 2_000_000;
/** Peers hold every row as an object. */
const PEER_LIMIT_MS = 60_000;
/** Peers that the project does not need are looked for here. */
const peers = join(cacheFolder, 'peers');
const run = promisify(execFile);

interface Reading {
  readonly name: string;
  readonly note: string;
  file(): Promise<CloudFile>;
  readonly peers: readonly string[];
}

const readings: readonly Reading[] = [
  {
    name: 'PLY, double, colour, intensity',
    note: '31 bytes a point, as exporters write it',
    file: () => cloudFile(POINTS, 'ply-full'),
    peers: ['three PLYLoader', 'loaders.gl'],
  },
  {
    name: 'PLY, bare float',
    note: '12 bytes a point',
    file: () => cloudFile(POINTS, 'ply'),
    peers: ['three PLYLoader', 'loaders.gl'],
  },
  {
    name: 'PLY, bare float, shuffled',
    note: 'the worst case: no point lies near the one before',
    file: () => cloudFile(POINTS, 'ply-shuffled'),
    peers: [],
  },
  {
    name: 'CSV',
    note: '21 bytes a point',
    file: () => cloudFile(POINTS, 'csv'),
    peers: ['papaparse', 'loaders.gl'],
  },
  { name: 'LAS', note: '26 bytes a point', file: () => cloudFile(POINTS, 'las'), peers: [] },
  { name: 'LAZ', note: 'by laspy', file: () => foreignFile(POINTS, 'laz'), peers: [] },
  { name: 'E57', note: 'by pye57', file: () => foreignFile(POINTS, 'e57'), peers: [] },
];

/** Reading with thinning, beside merely reading the same bytes and beside peers, which keep every point and thin none. */
export async function benchReading(): Promise<readonly Figure[]> {
  const child = await bundleChild('read-child');
  const figures: Figure[] = [];
  for (const { name, note, file, peers: others } of readings) {
    const cloud = await file().catch(() => null);
    if (!cloud) {
      console.log(`  ${name}: cannot be written on this machine (pip install laspy lazrs pye57, PYTHON=…)`);
      continue;
    }
    for (const method of ['raw', 'ours', ...others]) {
      const result = await runChild(child, method, cloud.path);
      if (result) figures.push(...figuresOf(`${name}: ${method}`, note, cloud.bytes, result));
    }
  }
  return figures;
}

function figuresOf(name: string, note: string, bytes: number, run: ReadRun): Figure[] {
  const figure = (of: string, value: number): Figure => ({
    name,
    of,
    value,
    unit: 'reading, best of its runs',
    note,
  });
  return [
    figure('MB/s', bytes / 1000 / run.ms),
    figure('M points/s', POINTS / 1000 / run.ms),
    figure('MB/s of CPU', bytes / 1000 / run.cpuMs),
    figure('M pts/s of CPU', POINTS / 1000 / run.cpuMs),
    figure('peak MB', run.peakMB),
  ];
}

async function runChild(child: string, method: string, path: string): Promise<ReadRun | null> {
  try {
    const words = ['--max-old-space-size=8000', child, method, path, peers];
    const { stdout } = await run(process.execPath, words, { timeout: PEER_LIMIT_MS, maxBuffer: 2 ** 24 });
    return JSON.parse(stdout.trim().split('\n').at(-1)!);
  } catch (error) {
    if (method === 'ours' || method === 'raw') throw error;
    console.log(
      `  ${method}: not on this machine, or too slow (npm i --prefix ${peers} papaparse @loaders.gl/{core,ply,csv})`,
    );
    return null;
  }
}
