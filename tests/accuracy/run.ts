/**
 * `npm run accuracy -- [DIR] [--held-back] [--series N] [--only NAME] [--list] [--json FILE] [--out FOLDER] [OPTIONS]`, with any
 * options of the command: plans of scenes with known truth.
 *
 * DIR holds scans, with NAME.gt.json beside NAME.ply, NAME.csv … where the truth is known; the others are drawn, to be
 * looked at. Without it the working half of the simulated corpus is run, with --held-back the other half, of which only means
 * are told, and with --series 1, 2 … other buildings of the same kinds, all to be looked at. --only takes every scene whose name
 * has NAME in it.
 */
import { mkdirSync, writeFileSync } from 'node:fs';
import { join, resolve } from 'node:path';
import { corpusOf } from './corpus.ts';
import { corpusFolder } from './corpus-files.ts';
import { runScene } from './run-scene.ts';
import { type SceneFiles, scenesIn } from './scene-files.ts';
import { formatList, formatMeans, formatTable, meansByClass, type SceneResult } from './table.ts';

const root = resolve(import.meta.dirname, '../..');

interface Arguments {
  /** Null for the corpus. */
  readonly folder: string | null;
  readonly isHeldBack: boolean;
  /** Of the corpus. */
  readonly series: number;
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
  const series = Number(take('--series') ?? 0);
  if (!Number.isInteger(series) || series < 0) throw new Error('--series takes 0, 1, 2 …');
  const hasFolder = rest.length > 0 && !rest[0].startsWith('-');
  const folder = hasFolder ? resolve(rest.shift()!) : null;
  const usual = join(root, isHeldBack ? '.cache/accuracy-held-back' : '.cache/accuracy');
  return {
    folder,
    isHeldBack: isHeldBack && folder === null,
    series,
    isList,
    only,
    json: json === null ? null : resolve(json),
    out: out === null ? usual : resolve(out),
    rest,
  };
}

async function scenesOf({ folder, isHeldBack, series, only }: Arguments): Promise<SceneFiles[]> {
  if (folder !== null) return scenesIn(folder).filter(({ name }) => name.includes(only));
  const chosen = corpusOf(series).filter(
    (scene) => scene.isHeldBack === isHeldBack && scene.name.includes(only),
  );
  const made = await corpusFolder(chosen);
  const names = new Set(chosen.map(({ name }) => name));
  return scenesIn(made).filter(({ name }) => names.has(name));
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
if (given.isList) console.log(formatList(scenes.map(({ name, truth }) => ({ name, facts: truth?.scene }))));
else {
  const results: SceneResult[] = [];
  for (const scene of scenes) {
    const result = await runScene(scene, given);
    process.stderr.write(given.isHeldBack ? '.' : `${result.name}: ${result.seconds.toFixed(1)} s\n`);
    results.push(result);
  }
  report(results, given);
}
