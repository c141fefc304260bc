import { execFile } from 'node:child_process';
import { promisify } from 'node:util';
import { bundleChild } from './child-bundle.ts';
import { type CloudFile, cloudFile, foreignFile } from './clouds.ts';
import { cancelInPage, loadInPage, rendererMemory, withPage } from './served-page.ts';
import type { Figure } from './table.ts';

const POINTS = 2_000_000;
/** Until a worker that was ended has given its memory back. */
const SETTLE_MS = 2_000;
const run = promisify(execFile);

const CLOUDS: readonly (readonly [string, () => Promise<CloudFile>])[] = [
  ['PLY', () => cloudFile(POINTS, 'ply-full')],
  ['CSV', () => cloudFile(POINTS, 'csv')],
  ['LAZ', () => foreignFile(POINTS, 'laz')],
  ['E57', () => foreignFile(POINTS, 'e57')],
];

/** How soon reading ends after it was cancelled midway, under Node and in Chromium, and what memory stays. */
export async function benchCancel(): Promise<readonly Figure[]> {
  const child = await bundleChild('read-child');
  const figures: Figure[] = [];
  for (const [name, file] of CLOUDS) {
    const cloud = await file().catch(() => null);
    if (!cloud) {
      console.log(`  ${name}: cannot be written on this machine (pip install laspy lazrs pye57, PYTHON=…)`);
      continue;
    }
    const { stdout } = await run(process.execPath, [child, 'cancel', cloud.path]);
    const { found } = JSON.parse(stdout.trim().split('\n').at(-1)!);
    const figure = (of: string, value: number): Figure => ({ name, of, value, unit: 'cancelled midway' });
    figures.push(figure('Node, ms', found), ...(await inPage(cloud.path, figure)));
  }
  return figures;
}

async function inPage(path: string, figure: (of: string, value: number) => Figure): Promise<Figure[]> {
  return withPage(async (page, browser) => {
    const before = await rendererMemory(browser);
    const { read } = await loadInPage(page, path);
    const whole = await rendererMemory(browser);
    const cancelMs = await cancelInPage(page, read / 2);
    await page.waitForTimeout(SETTLE_MS);
    const after = await rendererMemory(browser);
    return [
      figure('page, ms', cancelMs),
      figure('MB before', before.now),
      figure('MB with plan', whole.now),
      figure('MB after', after.now),
    ];
  });
}
