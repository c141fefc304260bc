import { PAPER_SLICES, type PaperSliceName, paperSlice } from '../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { findBoundary } from '../../src/core/boundary.ts';
import { meanSpacing } from '../../src/core/geometry/spacing.ts';
import { resolveOptions } from '../../src/core/options.ts';
import type { Options } from '../../src/core/params.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import { findSecondary } from '../../src/core/secondary.ts';
import type { Slice } from '../../src/core/types.ts';
import type { Figure } from './table.ts';

const WARM_UP = 100;
const RUNS = 300;
const PIXELS_PER_METRE = 100;

const context = { warn: () => {}, progress: () => {}, strokeTest: createStrokeTest() };

/**
 * The paper's own measure ([Stojanovic19] §4): its six slices to the regularised primary boundary (10.25 ms mean), and on to
 * the secondary boundaries of those that have one, k = 2 (169 ms mean).
 */
export async function benchPaperSlice(): Promise<readonly Figure[]> {
  const primary: Times[] = [];
  const paper: Times[] = [];
  const robust: Times[] = [];
  const proposed: Times[] = [];
  const figures: Figure[] = [];
  for (const name of Object.keys(PAPER_SLICES) as PaperSliceName[]) {
    const { xy, secondary } = paperSlice(name);
    const slice = asSlice(xy);
    const given: Partial<Options> = { secondaryCount: secondary.length };
    const options = resolveOptions(given, { isSlice: true });
    const outline = () => regulariseBoundary(findBoundary(slice, options, context), slice, options, context);
    const regularised = outline();
    primary.push(timesOf(outline));
    figures.push(...asFigures(`primary, ${name}, ${xy.length / 2} points`, primary.at(-1)!));
    if (secondary.length === 0) continue;
    const ours = resolveOptions({ ...given, secondaryMethod: 'robust' }, { isSlice: true });
    paper.push(timesOf(() => findSecondary(slice, regularised, options, context)));
    robust.push(timesOf(() => findSecondary(slice, regularised, ours, context)));
    const auto = resolveOptions({ secondaryCount: 'auto' }, { isSlice: true });
    proposed.push(timesOf(() => findSecondary(slice, regularised, auto, context)));
    figures.push(...asFigures(`secondary, ${name}`, paper.at(-1)!));
    figures.push(...asFigures(`secondary, number proposed, ${name}`, proposed.at(-1)!));
    figures.push(...asFigures(`secondary, robust, ${name}`, robust.at(-1)!));
  }
  return [
    ...figures,
    ...asFigures('primary, mean of all', meanOf(primary), 'paper 10.25'),
    ...asFigures('secondary, mean of all', meanOf(paper), 'paper 169'),
    ...asFigures('secondary, number proposed, mean of all', meanOf(proposed), 'paper 169'),
    ...asFigures('secondary, robust, mean of all', meanOf(robust)),
  ];
}

function asSlice(pixels: Float64Array): Slice {
  const xy = pixels.map((value) => value / PIXELS_PER_METRE);
  return { xy, band: [0, 0], spacing: meanSpacing(xy) };
}

/** Milliseconds: other work of the machine lengthens the mean, not the best run, and the processor's time but little. */
interface Times {
  readonly mean: number;
  readonly best: number;
  readonly cpu: number;
}

function timesOf(once: () => unknown): Times {
  for (let i = 0; i < WARM_UP; i++) once();
  let best = Number.POSITIVE_INFINITY;
  let sum = 0;
  const used = process.cpuUsage();
  for (let i = 0; i < RUNS; i++) {
    const start = performance.now();
    once();
    const ms = performance.now() - start;
    best = Math.min(best, ms);
    sum += ms;
  }
  const { user, system } = process.cpuUsage(used);
  return { mean: sum / RUNS, best, cpu: (user + system) / 1000 / RUNS };
}

function meanOf(times: readonly Times[]): Times {
  const mean = (pick: (one: Times) => number) =>
    times.reduce((sum, one) => sum + pick(one), 0) / times.length;
  return { mean: mean((one) => one.mean), best: mean((one) => one.best), cpu: mean((one) => one.cpu) };
}

function asFigures(name: string, { mean, best, cpu }: Times, note?: string): Figure[] {
  const unit = `ms, ${RUNS} runs`;
  return [
    { name, of: 'mean', value: mean, unit, ...(note ? { note } : {}) },
    { name, of: 'best', value: best, unit },
    { name, of: 'processor', value: cpu, unit },
  ];
}
