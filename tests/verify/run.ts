/**
 * `npm run verify-exports [-- DIR|SCAN]`: what others' software says of every file that is written.
 *
 * Scans of the corpus (or SCAN, or the scans in DIR) are written in all formats by the built command, and every
 * NAME_check.py beside this file is asked about plan.NAME, where a Python with the packages it needs is present: PYTHON,
 * else python3. A DIR with a plan.json is checked as it stands. Exit code 1 where a check failed.
 */
import { spawnSync } from 'node:child_process';
import { existsSync, readdirSync, rmSync, statSync } from 'node:fs';
import { basename, extname, join, resolve } from 'node:path';
import { WRITE_FORMATS } from '../../src/write/formats.ts';
import type { WriteFormat } from '../../src/write/plan-writer.ts';
import { CORPUS } from '../accuracy/corpus.ts';
import { corpusFolder } from '../accuracy/corpus-files.ts';
import { scenesIn } from '../accuracy/scene-files.ts';

/** A home, two storeys, curved walls, columns, UTM coordinates, feet. */
const SCENES = [
  'home-100',
  'house-132',
  'round-hall-126',
  'hall-columns-130',
  'home-u-utm-104',
  'home-l-feet-tilted-102',
];
/** Checks of files that are not called plan.NAME. */
const FILES: Readonly<Record<string, string>> = { mesh: 'plan.glb', rooms: 'rooms.xlsx' };

/** Nothing is asked of these; not every scan has a way to WGS 84, which is in the ZIP where it has. */
const LEFT_OUT = ['pictures', 'glb-points', 'png', 'geojson-wgs84'];

const root = resolve(import.meta.dirname, '../..');
const command = join(root, 'dist/cli.js');
const python = process.env.PYTHON ?? 'python3';
const rows: readonly WriteFormat[] = Object.values(WRITE_FORMATS);
const scripts = readdirSync(import.meta.dirname).filter((name) => name.endsWith('_check.py'));

/** What one check said of one file. */
type Verdict = 'ok' | 'failed' | 'skipped';

const tally: Record<Verdict, number> = { ok: 0, failed: 0, skipped: 0 };

for (const folder of await foldersOf(process.argv.slice(2).find((word) => word !== '--')))
  checkFolder(folder);
console.log(`\n${tally.ok} checks passed, ${tally.failed} failed, ${tally.skipped} were skipped`);
process.exitCode = tally.failed > 0 ? 1 : 0;

/** Folders with the files to be checked. */
async function foldersOf(given: string | undefined): Promise<string[]> {
  const isFolder = given !== undefined && statSync(given).isDirectory();
  if (isFolder && existsSync(join(given, 'plan.json'))) return [resolve(given)];
  const scans = given === undefined ? await ownScans() : isFolder ? scansIn(given) : [resolve(given)];
  return scans.flatMap(writeAll);
}

async function ownScans(): Promise<string[]> {
  const scenes = CORPUS.filter(({ name }) => SCENES.includes(name));
  const folder = await corpusFolder(scenes);
  return scenes.map(({ name }) => join(folder, `${name}.ply`));
}

const scansIn = (folder: string): string[] => scenesIn(folder).map(({ scan }) => resolve(scan));

/** All files of a scan; none, and a failure told, where the command fails. */
function writeAll(scan: string): string[] {
  const name = basename(scan, extname(scan));
  const folder = join(root, '.cache/verify', name);
  rmSync(folder, { recursive: true, force: true });
  const formats = Object.keys(WRITE_FORMATS).filter((format) => !LEFT_OUT.includes(format));
  const words = [command, scan, '-o', folder, '--formats', formats.join(',')];
  const { status, stderr } = spawnSync(process.execPath, words, { encoding: 'utf8' });
  if (status === 0) return [folder];
  tell(name, 'failed', stderr.trim() || `exit code ${status}`);
  return [];
}

function checkFolder(folder: string): void {
  console.log(`\n${basename(folder)}`);
  const files = readdirSync(folder).sort();
  for (const script of scripts) {
    const kind = script.replace('_check.py', '');
    const wanted = FILES[kind] ?? `plan.${kind}`;
    const found = files.filter((file) => file.replace(/-\d+(?=\.)/, '') === wanted);
    if (found.length === 0) tell(script, 'skipped', `there is no ${wanted}`);
    for (const file of found) runCheck(script, folder, { file, isPerStorey: isPerStorey(wanted) });
  }
}

function isPerStorey(file: string): boolean {
  const row = rows.find((format) => 'base' in format && `${format.base}.${format.extension}` === file);
  return row !== undefined && 'isPerStorey' in row && row.isPerStorey;
}

/** NAME_check.py FILE plan.json, of a drawing of one storey its index too. */
function runCheck(
  script: string,
  folder: string,
  { file, isPerStorey }: { file: string; isPerStorey: boolean },
): void {
  const storey = isPerStorey ? [/-(\d+)\./.exec(file)?.[1] ?? '0'] : [];
  const words = [join(import.meta.dirname, script), join(folder, file), join(folder, 'plan.json'), ...storey];
  const { status, stdout, stderr, error } = spawnSync(python, words, { encoding: 'utf8' });
  const missing = /No module named '([^']+)'/.exec(stderr ?? '')?.[1];
  const what = `${script} ${file}`;
  if (error !== undefined) tell(what, 'skipped', `there is no ${python}`);
  else if (missing !== undefined) tell(what, 'skipped', `${python} has no package ${missing}`);
  else if (status === 0) tell(what, 'ok', stdout.trim());
  else tell(what, 'failed', `${stdout}\n${stderr}`.trim());
}

function tell(what: string, verdict: Verdict, said: string): void {
  tally[verdict]++;
  console.log(`  ${verdict}: ${what}\n${said.replace(/^(?=.)/gm, '    ')}`);
}
