import { cpus } from 'node:os';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { findBoundary } from '../../src/core/boundary.ts';
import type { StageContext } from '../../src/core/context.ts';
import { resolveOptions } from '../../src/core/options.ts';
import type { Options } from '../../src/core/params.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import { findSecondary } from '../../src/core/secondary.ts';
import { HALLWAYS, type PaperSet, ROOMS, runSet } from './paper-sets.ts';
import { PASS_COMBINATIONS } from './passes.ts';

const WARM_UP = 100;
const RUNS = 300;

/** Milliseconds over many runs of warmed code. */
export interface Time {
  readonly mean: number;
  /** What a run takes when nothing else holds the machine up. */
  readonly median: number;
  readonly min: number;
  readonly max: number;
}

/** Everything about a run that the next run will not repeat; kept in a file of its own. */
export interface Times {
  readonly machine: string;
  readonly runs: number;
  /** Slice to regularised outline, by set. */
  readonly primary: Readonly<Record<string, Time>>;
  /** Slice and outline to structure, by set. */
  readonly secondary: Readonly<Record<string, { readonly paper: Time; readonly robust: Time }>>;
  /** Median ms of the passes alone, mean over the six sets, in the order of the combinations. */
  readonly passes: readonly number[];
}

export async function measureTimes(sets: readonly PaperSet[]): Promise<Times> {
  const primary: Record<string, Time> = {};
  for (const set of HALLWAYS) primary[set.name] = await timePrimary(set);
  const secondary: Record<string, { paper: Time; robust: Time }> = {};
  for (const set of ROOMS) {
    secondary[set.name] = {
      paper: await timeSecondary(set, 'paper'),
      robust: await timeSecondary(set, 'robust'),
    };
  }
  const passes: number[] = [];
  for (const { given } of PASS_COMBINATIONS) {
    let sum = 0;
    for (const set of sets) sum += (await timePasses(set, given)).median;
    passes.push(sum / sets.length);
  }
  const machine = `${cpus().length} cores, Node ${process.versions.node.split('.')[0]}`;
  return { machine, runs: RUNS, primary, secondary, passes };
}

async function timePrimary(set: PaperSet): Promise<Time> {
  const { slice } = await runSet(set);
  const options = optionsFor({});
  return time(() => regulariseBoundary(findBoundary(slice, options, CONTEXT), slice, options, CONTEXT));
}

async function timeSecondary(set: PaperSet, secondaryMethod: 'paper' | 'robust'): Promise<Time> {
  const { slice, regularise } = await runSet(set);
  const options = optionsFor({ secondaryMethod, secondaryCount: 1 });
  return time(() => findSecondary(slice, regularise, options, CONTEXT));
}

async function timePasses(set: PaperSet, given: Partial<Options>): Promise<Time> {
  const { slice, boundary } = await runSet(set);
  const options = optionsFor(given);
  return time(() => regulariseBoundary(boundary, slice, options, CONTEXT));
}

const CONTEXT: StageContext = { warn: () => {}, progress: () => {}, strokeTest: createStrokeTest() };

function optionsFor(given: Partial<Options>): Options {
  return resolveOptions({ preset: 'paper', ...given });
}

function time(work: () => unknown): Time {
  for (let i = 0; i < WARM_UP; i++) work();
  const all = Array.from({ length: RUNS }, () => {
    const start = performance.now();
    work();
    return performance.now() - start;
  }).sort((a, b) => a - b);
  return {
    mean: all.reduce((sum, ms) => sum + ms, 0) / all.length,
    median: all[all.length >> 1],
    min: all[0],
    max: all[all.length - 1],
  };
}
