import { execFile } from 'node:child_process';
import { join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { cacheFolder } from './clouds.ts';

const run = promisify(execFile);
const here = import.meta.dirname;
const rustTarget = join(cacheFolder, 'rust');

/** What a method's own process says of itself. */
export interface HullRun {
  /** The first run, with code still cold, and the best of all: the machine's other work only ever adds. */
  readonly firstMs: number;
  readonly ms: number;
  /** Least processor time of a run: other work hardly lengthens it. */
  readonly cpuMs?: number;
  /** Of the whole process, its points included. */
  readonly peakMB: number;
  /** x, y a vertex. */
  readonly ring: readonly number[];
  /** Edge length the method chose by itself, m; 0 for those told one or using none. */
  readonly openingLength?: number;
}

/** A way to an outline: a command to which file and edge length are added. */
export interface HullMethod {
  readonly name: string;
  /** What its outline is, where the name does not say. */
  readonly note?: string;
  readonly command: readonly string[];
  /** Makes ready; rejects where it is not to be had on this machine. */
  prepare?(): Promise<unknown>;
  /** What to do where {@link prepare} rejects. */
  readonly remedy?: string;
}

const node = [process.execPath, '--import', 'tsx', resolve(here, 'hull-child.ts')];
const python = process.env.PYTHON ?? 'python3';
const script = resolve(here, 'peers/hull.py');
const manifest = resolve(here, 'peers/rust/Cargo.toml');
// The crate uses a feature that stable compilers hide.
const rustEnvironment = { ...process.env, RUSTC_BOOTSTRAP: '1' };

/**
 * Ours first, then its peers. None needs the network; those not installed are left out and told of.
 *
 * Ours thrice: as gift opening leaves it, on the outermost of the noise, as the paper's preset does; as the preset
 * building goes on with it, vertex by vertex on the walls; and straightened, as it goes into the plan.
 */
export const hullMethods: readonly HullMethod[] = [
  { name: 'ours, raw', command: [...node, 'ours'], note: "the paper's hull: on the outermost of the noise" },
  {
    name: 'ours, noise off',
    command: [...node, 'ours-noise-off'],
    note: 'the hull as the preset building goes on with it: each vertex on its wall',
  },
  { name: 'ours, straightened', command: [...node, 'ours-straightened'] },
  { name: 'concaveman', command: [...node, 'concaveman'] },
  { name: 'concaveman, 2 cm', command: [...node, 'concaveman-thinned'] },
  {
    name: 'hull.js',
    command: [...node, 'hull.js'],
    prepare: () => run(process.execPath, ['-e', 'require("hull.js")'], { cwd: here }),
    remedy: 'npm ci, or NODE_PATH to where it is',
  },
  {
    name: 'GEOS concave_hull',
    command: [python, script, 'geos'],
    prepare: () => run(python, ['-c', 'import numpy, shapely']),
    remedy: 'pip install shapely, PYTHON=…',
  },
  {
    name: 'concaveman in C++',
    command: [python, script, 'cpp'],
    prepare: () => run(python, ['-c', 'import numpy, concave_hull']),
    remedy: 'pip install concave-hull, PYTHON=…',
  },
  {
    name: 'gift opening in Rust',
    command: [join(rustTarget, 'release/hull')],
    prepare: () => run('cargo', cargoWords('build', '--release', '--offline'), { env: rustEnvironment }),
    remedy: `cargo fetch --manifest-path ${manifest}`,
  },
];

/**
 * Runs a method on a file of points in a process of its own.
 *
 * @returns null when the time is up
 */
export async function runHull(
  { command }: HullMethod,
  path: string,
  edgeLength: number,
  limitMs: number,
): Promise<HullRun | null> {
  const [program, ...words] = [...command, path, String(edgeLength)];
  try {
    const options = { timeout: limitMs, killSignal: 'SIGKILL', maxBuffer: 2 ** 28 } as const;
    const { stdout } = await run(program, words, options);
    return JSON.parse(stdout);
  } catch (error) {
    if ((error as { killed?: boolean }).killed) return null;
    throw error;
  }
}

function cargoWords(...words: string[]): string[] {
  return [...words, '--manifest-path', manifest, '--target-dir', rustTarget];
}
