import type { XY } from '../../fixtures/simulator/ring.ts';
import { STRUCTURE_SHAPES, type VariedSlice, variedSlice } from '../../fixtures/simulator/varied-slices.ts';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import type { Options } from '../../src/core/params.ts';
import type { SecondaryResult } from '../../src/core/types.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import { Session } from '../../src/session/session.ts';
import { intersectionOverUnion, type Region, regionOf } from '../accuracy/regions.ts';

/** A structure counts as found when its outline shares more than this with the truth. */
const FOUND_IOU = 0.8;
const CASES_A_HALF = 100;
/** Seeds of the cases the method was made with, and of those kept back from that work. */
const FIRST_SEED = { development: 1, keptBack: 1001 } as const;
const PIXELS_PER_METRE = 100;

/** IoU of what the two methods found in one case. */
export interface SecondaryCase {
  readonly slice: VariedSlice;
  readonly robust: number;
  readonly paper: number;
  /** Of the paper's method against the structure's inner face, which is what it looks for. */
  readonly paperInner: number;
}

/** Shares of cases with an IoU over {@link FOUND_IOU}. */
export interface SecondaryShares {
  readonly cases: number;
  readonly robust: number;
  readonly paper: number;
  readonly paperInner: number;
}

export interface SecondaryCases {
  readonly development: SecondaryShares;
  readonly keptBack: SecondaryShares;
  /** Of both halves, by distance to the wall, shape, density and noise. */
  readonly byDifficulty: Readonly<Record<string, SecondaryShares>>;
}

/**
 * How often each method finds the structure in seeded variations of the paper's six rooms: one structure 0.1 to 1.5 m
 * from the wall, any rotation, 0.5 to 3 px of noise, 200 to 5,000 points. The whole chain is run on each.
 *
 * @param casesAHalf the first so many of each half
 */
export async function secondaryCases(casesAHalf = CASES_A_HALF): Promise<SecondaryCases> {
  const development = await measureCases(FIRST_SEED.development, casesAHalf);
  const keptBack = await measureCases(FIRST_SEED.keptBack, casesAHalf);
  return {
    development: sharesOf(development),
    keptBack: sharesOf(keptBack),
    byDifficulty: byDifficulty([...development, ...keptBack]),
  };
}

async function measureCases(firstSeed: number, count: number): Promise<SecondaryCase[]> {
  const cases: SecondaryCase[] = [];
  for (let seed = firstSeed; seed < firstSeed + count; seed++)
    cases.push(await measureCase(variedSlice(seed)));
  return cases;
}

async function measureCase(slice: VariedSlice): Promise<SecondaryCase> {
  const session = new Session({ strokeTest: createStrokeTest() });
  const source = blobSource(new Blob([csvOf(slice)]), 'case.csv');
  const given: Partial<Options> = { preset: 'paper', secondaryCount: 1 };
  const robust = await session.load(source, { ...given, secondaryMethod: 'robust' });
  const paper = await session.update({ ...given, secondaryMethod: 'paper' });
  const [truth, innerFace] = [regionOf([slice.secondary[0]]), regionOf([slice.innerFace])];
  // One outline is wanted; the Frame puts the slice where its points are, to within float32.
  const iou = (found: SecondaryResult, wanted: Region): number =>
    found.boundaries.length === 0 ? 0 : intersectionOverUnion(regionInPixels(found, session), wanted);
  return {
    slice,
    robust: iou(robust.secondary!, truth),
    paper: iou(paper.secondary!, truth),
    paperInner: iou(paper.secondary!, innerFace),
  };
}

function csvOf({ xy }: VariedSlice): string {
  const rows = Array.from({ length: xy.length / 2 }, (_, i) => `${xy[2 * i]},${xy[2 * i + 1]}`);
  return `x,y\n${rows.join('\n')}\n`;
}

function regionInPixels({ boundaries: [{ outline }] }: SecondaryResult, session: Session): Region {
  const [x0, y0] = session.result!.plan.frame.planOrigin;
  const { outer } = outline;
  const ring = Array.from(
    { length: outer.length / 2 },
    (_, i): XY => [x0 + outer[2 * i] * PIXELS_PER_METRE, y0 + outer[2 * i + 1] * PIXELS_PER_METRE],
  );
  return regionOf([ring]);
}

function sharesOf(cases: readonly SecondaryCase[]): SecondaryShares {
  const share = (method: 'robust' | 'paper' | 'paperInner') =>
    cases.filter((each) => each[method] > FOUND_IOU).length / Math.max(1, cases.length);
  return {
    cases: cases.length,
    robust: share('robust'),
    paper: share('paper'),
    paperInner: share('paperInner'),
  };
}

function byDifficulty(cases: readonly SecondaryCase[]): Record<string, SecondaryShares> {
  const of = (isIn: (slice: VariedSlice) => boolean) => sharesOf(cases.filter(({ slice }) => isIn(slice)));
  const between = (low: number, high: number, value: number) => low <= value && value < high;
  return {
    'wall 0.1 to 0.2 m': of(({ clearance }) => between(0, 20, clearance)),
    'wall 0.2 to 0.5 m': of(({ clearance }) => between(20, 50, clearance)),
    'wall over 0.5 m': of(({ clearance }) => between(50, Infinity, clearance)),
    ...Object.fromEntries(STRUCTURE_SHAPES.map((shape) => [shape, of((slice) => slice.shape === shape)])),
    '200 to 500 points': of(({ points }) => between(0, 500, points)),
    '500 to 1,500 points': of(({ points }) => between(500, 1_500, points)),
    'over 1,500 points': of(({ points }) => between(1_500, Infinity, points)),
    'noise under 1.5 px': of(({ noise }) => between(0, 1.5, noise)),
    'noise over 1.5 px': of(({ noise }) => between(1.5, Infinity, noise)),
  };
}
