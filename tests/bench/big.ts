import { execFile } from 'node:child_process';
import { mkdir, rm, statfs } from 'node:fs/promises';
import { resolve } from 'node:path';
import { promisify } from 'node:util';
import { cacheFolder, cloudFile } from './clouds.ts';
import { cancelInPage, loadInPage, rendererMemory, withPage } from './served-page.ts';
import type { Figure } from './table.ts';

const POINTS = Number(process.env.BIG_POINTS ?? 100_000_000);
const LAS_POINT_BYTES = 26;
const CANCEL_AFTER_MS = 3_000;
/** Until a worker that was ended has given its memory back. */
const SETTLE_MS = 2_000;

const cli = resolve(import.meta.dirname, '../../dist/cli.js');
const run = promisify(execFile);

/** A big LAS and one of a tenth, in the command and in Chromium: time, memory, response, cancel. The files are deleted after. */
export async function benchBig(): Promise<readonly Figure[]> {
  await mkdir(cacheFolder, { recursive: true });
  const { bavail, bsize } = await statfs(cacheFolder);
  if (bavail * bsize < 2 * POINTS * LAS_POINT_BYTES) throw new Error('There is too little room on the disk.');
  const figures: Figure[] = [];
  for (const points of [POINTS / 10, POINTS]) {
    const { path } = await cloudFile(points, 'las');
    try {
      const of = `${points / 1e6} M points`;
      figures.push(...(await inCommand(path, of)), ...(await inPage(path, of)));
    } finally {
      await rm(path);
    }
  }
  return figures;
}

async function inCommand(path: string, of: string): Promise<Figure[]> {
  const { stdout } = await run(process.execPath, [
    cli,
    path,
    '-o',
    `${cacheFolder}/out`,
    '--formats',
    'report',
  ]);
  const { totalMs, peakMemoryMB } = JSON.parse(stdout.trim().split('\n').at(-1)!);
  return [
    { name: 'command: plan, s', of, value: totalMs / 1000, unit: 'LAS' },
    { name: 'command: peak memory, MB', of, value: peakMemoryMB, unit: 'LAS' },
  ];
}

async function inPage(path: string, of: string): Promise<Figure[]> {
  return withPage(async (page, browser) => {
    const { raw, read, whole, longest } = await loadInPage(page, path);
    const { peak, now } = await rendererMemory(browser);
    const cancelMs = await cancelInPage(page, Math.min(CANCEL_AFTER_MS, read / 2));
    await page.waitForTimeout(SETTLE_MS);
    const after = await rendererMemory(browser);
    const figure = (name: string, value: number): Figure => ({
      name: `page: ${name}`,
      of,
      value,
      unit: 'LAS',
    });
    return [
      figure('raw bytes, s', raw / 1000),
      figure('read, s', read / 1000),
      figure('plan, s', whole / 1000),
      figure('longest task, ms (0: none over 50)', longest),
      figure('peak memory, MB', peak),
      figure('cancel, ms', cancelMs),
      figure('memory with the plan, MB', now),
      figure('memory after a cancelled run, MB', after.now),
    ];
  });
}
