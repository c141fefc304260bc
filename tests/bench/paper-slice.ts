import { hallwaySlice } from '../../fixtures/simulator/slices.ts';
import { findBoundary } from '../../src/core/boundary.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import type { Slice } from '../../src/core/types.ts';
import type { Figure } from './run.ts';

const WARM_UP = 200;
const RUNS = 500;

/** The paper's own measure: a slice of 1,799 points to its regularised primary boundary (paper: 10.25 ms mean). */
export async function benchPaperSlice(): Promise<readonly Figure[]> {
  const options = resolveOptions({}, { isSlice: true });
  const slice: Slice = hallwaySlice();
  const context = {
    warn: () => {},
    progress: () => {},
    strokeTest: () => {
      throw new Error('The primary boundary needs no canvas.');
    },
  };
  const once = () => regulariseBoundary(findBoundary(slice, options, context), slice, options, context);
  for (let i = 0; i < WARM_UP; i++) once();
  const start = performance.now();
  for (let i = 0; i < RUNS; i++) once();
  const mean = (performance.now() - start) / RUNS;
  return [
    {
      name: `primary boundary, ${slice.xy.length / 2} points`,
      value: mean,
      unit: 'ms',
      note: 'mean of 500; paper 10.25 ms',
    },
  ];
}
