import { PAPER_SLICES, type PaperSliceName, paperSlice } from '../../fixtures/simulator/slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import { findBoundary } from '../../src/core/boundary.ts';
import { meanSpacing } from '../../src/core/geometry/spacing.ts';
import { resolveOptions } from '../../src/core/options.ts';
import type { Options } from '../../src/core/params.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import { findSecondary } from '../../src/core/secondary.ts';
import type { Slice } from '../../src/core/types.ts';
import type { Figure } from './run.ts';

const WARM_UP = 100;
const RUNS = 300;
const PIXELS_PER_METRE = 100;

const context = { warn: () => {}, progress: () => {}, strokeTest: createStrokeTest() };

/**
 * The paper's own measure ([Stojanovic19] §4): its six slices to the regularised primary boundary (10.25 ms mean), and on to
 * the secondary boundaries of those that have one, k = 2 (169 ms mean).
 */
export async function benchPaperSlice(): Promise<readonly Figure[]> {
  const figures: Figure[] = [];
  const primary: number[] = [];
  const paper: number[] = [];
  const robust: number[] = [];
  for (const name of Object.keys(PAPER_SLICES) as PaperSliceName[]) {
    const { xy, secondary } = paperSlice(name);
    const slice = asSlice(xy);
    const given: Partial<Options> = { secondaryCount: secondary.length };
    const options = resolveOptions(given, { isSlice: true });
    const outline = () => regulariseBoundary(findBoundary(slice, options, context), slice, options, context);
    const regularised = outline();
    primary.push(mean(outline));
    figures.push(figure(`primary boundary, ${name}, ${xy.length / 2} points`, [primary.at(-1)!]));
    if (secondary.length === 0) continue;
    const ours = resolveOptions({ ...given, secondaryMethod: 'robust' }, { isSlice: true });
    paper.push(mean(() => findSecondary(slice, regularised, options, context)));
    robust.push(mean(() => findSecondary(slice, regularised, ours, context)));
    figures.push(figure(`secondary boundary, ${name}`, [paper.at(-1)!]));
    figures.push(figure(`secondary boundary, robust, ${name}`, [robust.at(-1)!]));
  }
  return [
    ...figures,
    figure('primary boundary, mean', primary, 'paper 10.25 ms'),
    figure('secondary boundary, mean', paper, 'paper 169 ms'),
    figure('secondary boundary, robust, mean', robust),
  ];
}

function asSlice(pixels: Float64Array): Slice {
  const xy = pixels.map((value) => value / PIXELS_PER_METRE);
  return { xy, band: [0, 0], spacing: meanSpacing(xy) };
}

function mean(once: () => unknown): number {
  for (let i = 0; i < WARM_UP; i++) once();
  const start = performance.now();
  for (let i = 0; i < RUNS; i++) once();
  return (performance.now() - start) / RUNS;
}

function figure(name: string, values: readonly number[], note = `mean of ${RUNS}`): Figure {
  return { name, value: values.reduce((sum, value) => sum + value, 0) / values.length, unit: 'ms', note };
}
