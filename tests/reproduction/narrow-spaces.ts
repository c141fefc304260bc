/** Spaces 0.3 to 1 m wide, where [Stojanovic19] §5 found α-shapes better than gift opening. */
import { areaPathsD, FillRule, intersectD, type PathsD, unionD } from 'clipper2-ts';
import { findBoundary } from '../../src/core/boundary.ts';
import type { Options } from '../../src/core/params.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import type { Polygon, Ring, Slice } from '../../src/core/types.ts';
import { ringOf } from '../unit/core/boundary/measures.ts';
import {
  asSlice,
  closed,
  listeningContext,
  optionsWith,
  randomNumbers,
  scanWalls,
} from '../unit/core/boundary/wall-slices.ts';
import type { NarrowSpaces } from './experiments.ts';
import { NARROW_SPACES, rotated } from './room-cases.ts';

const WIDTHS = [0.3, 0.4, 0.5, 0.6, 0.8, 1] as const;
const NOISES = [0, 0.005, 0.02] as const;
const PER_METRE = [25, 50, 100] as const;
const SEEDS = [1, 2] as const;
/** The paper has no pass that restores corners. */
const PAPER_PASSES = optionsWith({ boundary: 'alpha-shape', cornerPass: false });

/** α tried on each case, m; the paper's is 1.5. */
const ALPHAS = ['auto', 0.3, 0.5, 1, 1.5, 2, 3, 5] as const;

/**
 * Mean IoU by the width of the narrow part; every space, noise, density and seed, turned at random.
 *
 * Gift opening runs at its default options. The α-shape counts with its holes filled and all its parts together, at
 * the α that fits the truth of the case best: a hall's walls alone hold together only at an α of half its width.
 */
export function narrowSpaces(): readonly NarrowSpaces[] {
  return WIDTHS.map((width) => {
    const sums = { giftOpening: 0, alphaShape: 0, alphaShapeRegularised: 0 };
    const cases = narrowCases(width);
    for (const { slice, truth } of cases) {
      const rivals = ALPHAS.map((alpha) => alphaShares(slice, truth, alpha));
      sums.giftOpening += share(outline(slice, { boundary: 'gift-opening' }).polygons, truth);
      sums.alphaShape += Math.max(...rivals.map(({ raw }) => raw));
      sums.alphaShapeRegularised += Math.max(...rivals.map(({ regularised }) => regularised));
    }
    return {
      width,
      giftOpening: sums.giftOpening / cases.length,
      alphaShape: sums.alphaShape / cases.length,
      alphaShapeRegularised: sums.alphaShapeRegularised / cases.length,
    };
  });
}

function alphaShares(slice: Slice, truth: Ring, alpha: Options['alpha']) {
  const shape = outline(slice, { boundary: 'alpha-shape', alpha });
  const { polygons } = regulariseBoundary(shape, slice, PAPER_PASSES, listeningContext());
  return { raw: share(shape.polygons, truth), regularised: share(polygons, truth) };
}

function narrowCases(width: number): { readonly slice: Slice; readonly truth: Ring }[] {
  const random = randomNumbers(Math.round(1000 * width));
  return Object.values(NARROW_SPACES).flatMap((shape) =>
    NOISES.flatMap((noise) =>
      PER_METRE.flatMap((perMetre) =>
        SEEDS.map((seed) => {
          const path = rotated(shape(width), 2 * Math.PI * random());
          const slice = asSlice(scanWalls({ walls: [closed(path)], perMetre, noise, seed }));
          return { slice, truth: ringOf(path) };
        }),
      ),
    ),
  );
}

function outline(slice: Slice, given: Partial<Options>) {
  return findBoundary(slice, optionsWith(given), listeningContext());
}

/** IoU of the outer rings, filled and joined, with a ring. */
function share(polygons: readonly Polygon[], truth: Ring): number {
  const found = unionD(
    polygons.map(({ outer }) => pathOf(outer)),
    [],
    FillRule.NonZero,
    6,
  );
  const common = areaOf(intersectD(found, [pathOf(truth)], FillRule.NonZero, 6));
  return common / (areaOf(found) + areaOf([pathOf(truth)]) - common);
}

function pathOf(ring: Ring): { x: number; y: number }[] {
  return Array.from({ length: ring.length / 2 }, (_, k) => ({ x: ring[2 * k], y: ring[2 * k + 1] }));
}

function areaOf(paths: PathsD): number {
  return Math.abs(areaPathsD(paths));
}
