import { nodeSource } from '../../src/cli/node-source.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { readScan } from '../../src/read/read-scan.ts';
import { cloudFile } from './clouds.ts';
import type { Figure } from './table.ts';

const POINTS = 1_000_000;
const RUNS = 3;

/** Reading with thinning, beside merely reading the same bytes. */
export async function benchReading(): Promise<readonly Figure[]> {
  const figures: Figure[] = [];
  for (const format of ['ply', 'csv'] as const) {
    const { path, bytes } = await cloudFile(POINTS, format);
    const readMs = await best(async () => {
      await readScan(await nodeSource(path), resolveOptions({}));
    });
    const rawMs = await best(async () => {
      let total = 0;
      for await (const chunk of (await nodeSource(path)).stream()) total += chunk.length;
      if (total !== bytes) throw new Error(`Read ${total} of ${bytes} bytes.`);
    });
    const rate = (ms: number) => bytes / 1e6 / (ms / 1000);
    figures.push({ name: `${format} raw bytes`, value: rate(rawMs), unit: 'MB/s' });
    figures.push({ name: `${format} read and thinned`, value: rate(readMs), unit: 'MB/s' });
    figures.push({
      name: `${format} read and thinned`,
      value: POINTS / 1e6 / (readMs / 1000),
      unit: 'M points/s',
    });
  }
  return figures;
}

async function best(work: () => Promise<void>): Promise<number> {
  let least = Number.POSITIVE_INFINITY;
  for (let i = 0; i < RUNS; i++) {
    const start = performance.now();
    await work();
    least = Math.min(least, performance.now() - start);
  }
  return least;
}
