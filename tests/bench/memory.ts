import { execFile } from 'node:child_process';
import { resolve } from 'node:path';
import { promisify } from 'node:util';
import { cacheFolder, cloudFile } from './clouds.ts';
import type { Figure } from './table.ts';

const cli = resolve(import.meta.dirname, '../../dist/cli.js');
const run = promisify(execFile);

/** Peak memory of the command on a file of 10 M points beside one of 1 M: bounded by what is kept, not by the file. */
export async function benchMemory(): Promise<readonly Figure[]> {
  const figures: Figure[] = [];
  for (const points of [1_000_000, 10_000_000]) {
    const { path, bytes } = await cloudFile(points, 'ply');
    const words = [cli, path, '-o', `${cacheFolder}/out`, '--formats', 'report', '--point-budget', '1000000'];
    const { stdout } = await run(process.execPath, words);
    const report = JSON.parse(stdout.trim().split('\n').at(-1)!);
    const size = points.toLocaleString('en-GB');
    const note = `file ${(bytes / 1e6).toFixed(0)} MB, kept ${report.input.pointsKept.toLocaleString('en-GB')}`;
    figures.push({ name: `peak memory, ${size} points`, value: report.peakMemoryMB, unit: 'MB', note });
    figures.push({ name: `whole chain, ${size} points`, value: report.totalMs, unit: 'ms' });
  }
  return figures;
}
