import { vertexCount } from '../../src/core/geometry/rings.ts';
import type { Options } from '../../src/core/params.ts';
import type { StageResults } from '../../src/core/stage-results.ts';
import type { Polygon } from '../../src/core/types.ts';
import { intersectionOverUnion } from '../accuracy/regions.ts';
import { filledRegion, type PaperSet, runSet, trueRegions } from './paper-sets.ts';

/** The paper's α and its ε for the α-shape, 150 and 10 px, at 100 px a metre. */
export const PAPER_ALPHA = 1.5;
export const ALPHA_EPSILON = 0.1;
/** The same 150 as a squared radius, as CGAL counts α: √150 px. */
export const SQUARED_ALPHA = Math.sqrt(150) / 100;

/** One way to a primary boundary, for the comparison. */
interface OutlineMethod {
  readonly label: string;
  readonly given: Partial<Options>;
  readonly result: 'boundary' | 'regularise';
}

export const OUTLINE_METHODS: readonly OutlineMethod[] = [
  { label: 'convex hull', given: { boundary: 'convex' }, result: 'boundary' },
  { label: 'gift opening', given: {}, result: 'boundary' },
  { label: "gift opening and the paper's three passes", given: {}, result: 'regularise' },
  {
    label: 'α-shape, α 150 px',
    given: { boundary: 'alpha-shape', alpha: PAPER_ALPHA },
    result: 'boundary',
  },
  {
    label: 'α-shape, regularised, ε 10 px',
    given: { boundary: 'alpha-shape', alpha: PAPER_ALPHA, epsilon: ALPHA_EPSILON },
    result: 'regularise',
  },
  { label: 'concaveman', given: { boundary: 'concaveman' }, result: 'boundary' },
  { label: 'ours: preset building', given: { preset: 'building' }, result: 'regularise' },
];

/** Vertices of an outline and how well it covers the true room. */
export interface OutlineScore {
  readonly vertices: number;
  readonly iou: number;
}

/** Every method on one set, in the order of {@link OUTLINE_METHODS}. */
export async function scoreOutlines(set: PaperSet): Promise<readonly OutlineScore[]> {
  const scores: OutlineScore[] = [];
  for (const { given, result } of OUTLINE_METHODS) {
    const results = await runSet(set, { ...given, secondaryCount: 0 });
    scores.push(scoreOf(set, results[result].polygons, results));
  }
  return scores;
}

/** What lies inside the outer rings against the true room; holes count as filled. */
export function scoreOf(
  { name }: PaperSet,
  polygons: readonly Polygon[],
  { frame: { frame } }: StageResults,
): OutlineScore {
  const found = filledRegion(polygons, frame);
  return {
    vertices: vertexCount(polygons),
    iou: intersectionOverUnion(found, trueRegions(name).primary),
  };
}
