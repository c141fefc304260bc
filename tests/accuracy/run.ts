/**
 * `npm run accuracy -- [DIR] [--json FILE] [--out FOLDER] [options for the command]`: plans of scenes with known truth.
 *
 * DIR holds NAME.gt.json beside a scan NAME.ply, NAME.csv …; without it a small corpus is simulated.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { XY } from '../../fixtures/simulator/ring.ts';
import type { Truth } from '../../fixtures/simulator/truth.ts';
import { corpusFolder } from './corpus.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import { meanOfScenes } from './measures.ts';
import { drawComparison } from './picture.ts';
import { formatTable, type SceneResult } from './table.ts';

const root = resolve(import.meta.dirname, '../..');
const command = join(root, 'dist/cli.js');

interface Arguments {
  readonly folder: string;
  readonly json: string | null;
  readonly out: string;
  /** Handed on to the command. */
  readonly rest: readonly string[];
}

function readArguments(words: readonly string[]): Arguments {
  const rest = words.filter((word) => word !== '--');
  const take = (flag: string): string | null => {
    const at = rest.indexOf(flag);
    return at < 0 ? null : resolve(rest.splice(at, 2)[1]);
  };
  const json = take('--json');
  const out = take('--out') ?? join(root, '.cache/accuracy');
  const hasFolder = rest.length > 0 && !rest[0].startsWith('-');
  return { json, out, folder: hasFolder ? resolve(rest.shift()!) : corpusFolder(), rest };
}

interface SceneFiles {
  readonly name: string;
  readonly scan: string;
  readonly truth: string;
}

function scenesIn(folder: string): SceneFiles[] {
  const files = readdirSync(folder).sort();
  const names = files
    .filter((file) => file.endsWith('.gt.json'))
    .map((file) => file.slice(0, -'.gt.json'.length));
  return names.map((name) => {
    const scan = files.find((file) => file.startsWith(`${name}.`) && !file.endsWith('.json'));
    if (scan === undefined) throw new Error(`${folder}: no scan beside ${name}.gt.json`);
    return { name, scan: join(folder, scan), truth: join(folder, `${name}.gt.json`) };
  });
}

function runScene({ name, scan, truth: truthPath }: SceneFiles, { out, rest }: Arguments): SceneResult {
  const folder = join(out, name);
  rmSync(folder, { recursive: true, force: true });
  const words = [command, scan, '-o', folder, '--formats', 'geojson,slice', ...rest];
  const start = performance.now();
  const { status, stderr } = spawnSync(process.execPath, words, { encoding: 'utf8' });
  const seconds = (performance.now() - start) / 1000;
  if (status !== 0) return { name, measures: null, seconds, problem: stderr.trim() || `exit code ${status}` };
  const plan = readJson<PlanFile>(join(folder, 'plan.geojson'));
  const truth = readJson<Truth>(truthPath);
  const points = readSlice(join(folder, 'slice.csv'));
  const storeys = 'storeys' in truth ? truth.storeys.length : 1;
  for (let storey = 0; storey < storeys; storey++) {
    const file = storeys === 1 ? `${name}.svg` : `${name}-${storey}.svg`;
    writeFileSync(join(out, file), drawComparison(plan, truth, points, storey));
  }
  return { name, measures: measurePlan(plan, truth), seconds };
}

function readJson<T>(path: string): T {
  return JSON.parse(readFileSync(path, 'utf8'));
}

function readSlice(path: string): XY[] {
  if (!existsSync(path)) return [];
  const [, ...lines] = readFileSync(path, 'utf8').trim().split('\n');
  return lines.map((line) => {
    const [x, y] = line.split(',').map(Number);
    return [x, y];
  });
}

const given = readArguments(process.argv.slice(2));
mkdirSync(given.out, { recursive: true });
const results = scenesIn(given.folder).map((scene) => {
  const result = runScene(scene, given);
  process.stderr.write(`${result.name}: ${result.seconds.toFixed(1)} s\n`);
  return result;
});
const mean = meanOfScenes(results.map(({ measures }) => measures));
console.log(formatTable(results));
console.log(`\npictures: ${given.out}`);
const json = JSON.stringify({ scenes: results, mean }, null, 2);
writeFileSync(given.json ?? join(given.out, 'accuracy.json'), `${json}\n`);
if (results.some(({ measures }) => measures === null)) process.exitCode = 1;
