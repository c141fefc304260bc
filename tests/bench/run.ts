/**
 * `npm run bench [-- NAME…]`: every stage by size, readers in MB/s, the paper's slice, outlines beside their peers, memory,
 * the page and cancelling, every export of a large plan; with the name `big` also 100 M points, with `linear` the whole
 * chain's growth to 50 M. As tables and as JSON in .cache/bench/results.json. Machines are noisy: compare figures of one run.
 */
import { mkdir, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { benchBig } from './big.ts';
import { benchCancel } from './cancel.ts';
import { cacheFolder } from './clouds.ts';
import { benchExports } from './exports.ts';
import { benchHull } from './hull.ts';
import { benchLinear } from './linear.ts';
import { benchMemory } from './memory.ts';
import { benchPage } from './page.ts';
import { benchPaperSlice } from './paper-slice.ts';
import { benchReading } from './reading.ts';
import { benchStages } from './stages.ts';
import { type Figure, formatFigures } from './table.ts';

const benches: Record<string, () => Promise<readonly Figure[]>> = {
  stages: benchStages,
  reading: benchReading,
  'paper-slice': benchPaperSlice,
  hull: benchHull,
  memory: benchMemory,
  page: benchPage,
  cancel: benchCancel,
  exports: benchExports,
};

/** Minutes long and gigabytes large: only by name. */
const onlyByName: Record<string, () => Promise<readonly Figure[]>> = { big: benchBig, linear: benchLinear };
const all = { ...benches, ...onlyByName };

const chosen = process.argv.slice(2);
const unknown = chosen.find((name) => !Object.hasOwn(all, name));
if (unknown) throw new Error(`No bench "${unknown}"; there are ${Object.keys(all).join(', ')}.`);

const results: Record<string, readonly Figure[]> = {};
for (const name of chosen.length > 0 ? chosen : Object.keys(benches)) {
  console.log(`\n${name}`);
  results[name] = await all[name]();
  console.log(formatFigures(results[name]));
}
await mkdir(cacheFolder, { recursive: true });
await writeFile(join(cacheFolder, 'results.json'), `${JSON.stringify(results, null, 2)}\n`);
