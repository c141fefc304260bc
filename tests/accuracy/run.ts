/**
 * `npm run accuracy -- [DIR] [--held-back] [--only NAME] [--list] [--json FILE] [--out FOLDER] [options for the command]`:
 * plans of scenes with known truth.
 *
 * DIR holds NAME.gt.json beside a scan NAME.ply, NAME.csv …; without it the working half of the simulated corpus is run,
 * with --held-back the other half, of which only means are told. --only takes every scene whose name has NAME in it.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, mkdirSync, readdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import type { XY } from '../../fixtures/simulator/ring.ts';
import type { Report } from '../../src/session/report.ts';
import type { CorpusTruth } from './classes.ts';
import { CORPUS } from './corpus.ts';
import { corpusFolder } from './corpus-files.ts';
import type { PlanFile } from './facts.ts';
import { measurePlan } from './measure.ts';
import type { Measures } from './measures.ts';
import { drawComparison } from './picture.ts';
import {
  formatFigures,
  formatList,
  formatMeans,
  formatTable,
  meansByClass,
  type SceneResult,
} from './table.ts';
import { writePicture } from './write-picture.ts';

const root = resolve(import.meta.dirname, '../..');
const command = join(root, 'dist/cli.js');

interface Arguments {
  /** Null for the corpus. */
  readonly folder: string | null;
  readonly isHeldBack: boolean;
  readonly isList: boolean;
  readonly only: string;
  readonly json: string | null;
  readonly out: string;
  /** Handed on to the command. */
  readonly rest: readonly string[];
}

function readArguments(words: readonly string[]): Arguments {
  const rest = words.filter((word) => word !== '--');
  const take = (flag: string): string | null => {
    const at = rest.indexOf(flag);
    return at < 0 ? null : rest.splice(at, 2)[1];
  };
  const has = (flag: string): boolean => {
    const at = rest.indexOf(flag);
    return at >= 0 && rest.splice(at, 1).length > 0;
  };
  const [isHeldBack, isList] = [has('--held-back'), has('--list')];
  const [only, json, out] = [take('--only') ?? '', take('--json'), take('--out')];
  const hasFolder = rest.length > 0 && !rest[0].startsWith('-');
  const folder = hasFolder ? resolve(rest.shift()!) : null;
  const usual = join(root, isHeldBack ? '.cache/accuracy-held-back' : '.cache/accuracy');
  return {
    folder,
    isHeldBack: isHeldBack && folder === null,
    isList,
    only,
    json: json === null ? null : resolve(json),
    out: out === null ? usual : resolve(out),
    rest,
  };
}

async function scenesOf({ folder, isHeldBack, only }: Arguments): Promise<SceneFiles[]> {
  if (folder !== null) return scenesIn(folder).filter(({ name }) => name.includes(only));
  const chosen = CORPUS.filter((scene) => scene.isHeldBack === isHeldBack && scene.name.includes(only));
  const made = await corpusFolder(chosen);
  const names = new Set(chosen.map(({ name }) => name));
  return scenesIn(made).filter(({ name }) => names.has(name));
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

async function runScene(
  { name, scan, truth: truthPath }: SceneFiles,
  { out, rest, isHeldBack }: Arguments,
): Promise<SceneResult> {
  const folder = join(out, name);
  rmSync(folder, { recursive: true, force: true });
  const words = [command, scan, '-o', folder, '--formats', 'geojson,slice', ...rest];
  const start = performance.now();
  const { status, stderr } = spawnSync(process.execPath, words, { encoding: 'utf8' });
  const seconds = (performance.now() - start) / 1000;
  const truth = readJson<CorpusTruth>(truthPath);
  const classed = truth.scene ? { class: truth.scene.class } : {};
  if (status !== 0)
    return { name, ...classed, measures: null, seconds, problem: stderr.trim() || `exit code ${status}` };
  const plan = readJson<PlanFile>(join(folder, 'plan.geojson'));
  const { mesh } = readJson<Pick<Report, 'mesh'>>(join(folder, 'report.json'));
  const measures = { ...measurePlan(plan, truth), watertight: mesh.watertight ? 1 : 0 };
  // What is kept back leaves nothing to look at.
  if (isHeldBack) rmSync(folder, { recursive: true });
  else await drawScene({ name, plan, truth, measures }, out);
  return { name, ...classed, measures, seconds };
}

interface Scored {
  readonly name: string;
  readonly plan: PlanFile;
  readonly truth: CorpusTruth;
  readonly measures: Measures;
}

async function drawScene({ name, plan, truth, measures }: Scored, out: string): Promise<void> {
  const points = readSlice(join(out, name, 'slice.csv'));
  const figures = formatFigures(measures);
  const storeys = 'storeys' in truth ? truth.storeys.length : 1;
  for (let storey = 0; storey < storeys; storey++) {
    const path = join(out, storeys === 1 ? name : `${name}-${storey}`);
    await writePicture(path, drawComparison({ plan, truth, points, storey, figures }));
  }
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

/** Means of all scenes and of each class; scenes by name only where they are not kept back. */
function report(results: readonly SceneResult[], { isHeldBack, out, json }: Arguments): void {
  const means = meansByClass(results);
  console.log(isHeldBack ? formatMeans(means) : `${formatTable(results)}\n\n${formatMeans(means)}`);
  const failed = results.filter(({ measures }) => measures === null).length;
  if (failed > 0) console.log(`\n${failed} scenes without a plan`);
  if (!isHeldBack) console.log(`\npictures: ${out}`);
  const content = isHeldBack ? { means, failed } : { scenes: results, means, failed };
  writeFileSync(json ?? join(out, 'accuracy.json'), `${JSON.stringify(content, null, 2)}\n`);
  if (failed > 0) process.exitCode = 1;
}

const given = readArguments(process.argv.slice(2));
mkdirSync(given.out, { recursive: true });
const scenes = await scenesOf(given);
if (given.isList)
  console.log(
    formatList(scenes.map(({ name, truth }) => ({ name, facts: readJson<CorpusTruth>(truth).scene }))),
  );
else {
  const results: SceneResult[] = [];
  for (const scene of scenes) {
    const result = await runScene(scene, given);
    process.stderr.write(given.isHeldBack ? '.' : `${result.name}: ${result.seconds.toFixed(1)} s\n`);
    results.push(result);
  }
  report(results, given);
}
