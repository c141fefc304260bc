import { spawn } from 'node:child_process';
import { createHash } from 'node:crypto';
import { existsSync, mkdirSync, readdirSync, readFileSync, renameSync, writeFileSync } from 'node:fs';
import { availableParallelism } from 'node:os';
import { join, resolve } from 'node:path';
import { type SceneSpec, simulate, writePly } from '../../fixtures/simulator/index.ts';
import { type CorpusTruth, sceneFacts } from './classes.ts';
import { type CorpusScene, sceneNamed } from './corpus.ts';

const root = resolve(import.meta.dirname, '../..');
/** What the scenes are made from, beside the simulator. */
const SOURCES = ['corpus.ts', 'recipes.ts', 'classes.ts'];

/** Folder with these scenes of the corpus, written only where the simulator or the corpus has changed. */
export async function corpusFolder(scenes: readonly CorpusScene[]): Promise<string> {
  const folder = join(root, '.cache', `corpus-${sourceHash()}`);
  mkdirSync(folder, { recursive: true });
  const missing = scenes.map(({ name }) => name).filter((name) => !existsSync(truthPath(folder, name)));
  if (missing.length === 0) return folder;
  process.stderr.write(`making ${missing.length} scenes in ${folder}\n`);
  const hands = Math.min(availableParallelism(), missing.length);
  const shares = Array.from({ length: hands }, (_, hand) => missing.filter((_, i) => i % hands === hand));
  await Promise.all(shares.map((names) => makeApart(folder, names)));
  return folder;
}

/** Makes scenes in a process of its own. */
function makeApart(folder: string, names: readonly string[]): Promise<void> {
  const words = [...process.execArgv, join(import.meta.dirname, 'make-scenes.ts'), folder, ...names];
  return new Promise((done, fail) => {
    const child = spawn(process.execPath, words, { stdio: ['ignore', 'inherit', 'inherit'] });
    child.on('error', fail);
    child.on('exit', (code) =>
      code === 0 ? done() : fail(new Error(`scenes were not made: exit code ${code}`)),
    );
  });
}

export function makeScenes(folder: string, names: readonly string[]): void {
  for (const name of names) writeScene(folder, sceneNamed(name).spec());
}

function writeScene(folder: string, spec: SceneSpec): void {
  const { name, positions, truth } = simulate(spec);
  const isFar = positions.some((value) => Math.abs(value) > 1e5);
  const facts: CorpusTruth = { ...truth, scene: sceneFacts(spec, truth) };
  // The truth comes last and at once: where it stands, the scene is whole.
  writeFileSync(join(folder, `${name}.ply`), writePly({ positions }, { type: isFar ? 'double' : 'float' }));
  writeFileSync(join(folder, `${name}.draft`), JSON.stringify(facts));
  renameSync(join(folder, `${name}.draft`), truthPath(folder, name));
}

const truthPath = (folder: string, name: string): string => join(folder, `${name}.gt.json`);

function sourceHash(): string {
  const simulator = join(root, 'fixtures/simulator');
  const files = readdirSync(simulator).sort();
  const paths = [
    ...SOURCES.map((file) => join(import.meta.dirname, file)),
    ...files.map((file) => join(simulator, file)),
  ];
  const hash = createHash('sha256');
  for (const path of paths) hash.update(readFileSync(path));
  return hash.digest('hex').slice(0, 12);
}
