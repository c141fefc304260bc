import type { Options } from '../../src/core/params.ts';
import type { StageResults } from '../../src/core/stage-results.ts';
import type { Polygon } from '../../src/core/types.ts';
import { intersectionOverUnion, type Region } from '../accuracy/regions.ts';
import { ALPHA_EPSILON, PAPER_ALPHA, SQUARED_ALPHA } from './outlines.ts';
import { filledRegion, type PaperSet, runSet, trueRegions } from './paper-sets.ts';

type Face = 'innerFace' | 'outerFace';

/** One way to the structure of a room, and the face of its hollow wall that the way is measured against. */
interface StructureMethod {
  readonly label: string;
  readonly face: Face;
  readonly given: Partial<Options>;
  readonly pieces: (results: StageResults) => readonly Polygon[];
}

const found = ({ secondary }: StageResults) => secondary.boundaries.map(({ outline }) => outline);
const alphaShape = (alpha: number): Partial<Options> => ({
  boundary: 'alpha-shape',
  alpha,
  epsilon: ALPHA_EPSILON,
  secondaryCount: 0,
});
/** The ends of the paper's range for ε, 5 and 10 px. */
const [FINE, COARSE] = [{ secondaryEpsilon: 0.05 }, { secondaryEpsilon: 0.1 }];

export const STRUCTURE_METHODS: readonly StructureMethod[] = [
  { label: "paper's method, ε 5 px", face: 'innerFace', given: FINE, pieces: found },
  { label: "paper's method, ε 10 px", face: 'innerFace', given: COARSE, pieces: found },
  { label: "paper's method, ε 5 px", face: 'outerFace', given: FINE, pieces: found },
  { label: "paper's method, ε 10 px", face: 'outerFace', given: COARSE, pieces: found },
  { label: 'ours: robust', face: 'outerFace', given: { secondaryMethod: 'robust' }, pieces: found },
  {
    label: 'α-shape, radius 150 px',
    face: 'outerFace',
    given: alphaShape(PAPER_ALPHA),
    pieces: ({ boundary }) => boundary.polygons,
  },
  {
    label: 'α-shape, radius 150 px, regularised, ε 10 px',
    face: 'outerFace',
    given: alphaShape(PAPER_ALPHA),
    pieces: ({ regularise }) => regularise.polygons,
  },
  {
    label: 'α-shape, radius √150 px',
    face: 'outerFace',
    given: alphaShape(SQUARED_ALPHA),
    pieces: ({ boundary }) => boundary.polygons,
  },
  {
    label: 'α-shape, radius √150 px, regularised, ε 10 px',
    face: 'outerFace',
    given: alphaShape(SQUARED_ALPHA),
    pieces: ({ regularise }) => regularise.polygons,
  },
];

/** IoU of the piece that fits a room's structure best, filled; 0 where there is none. In the methods' order. */
export async function scoreStructures(set: PaperSet): Promise<readonly number[]> {
  const truth = trueRegions(set.name);
  const scores: number[] = [];
  for (const { face, given, pieces } of STRUCTURE_METHODS) {
    const results = await runSet(set, given);
    scores.push(bestFit(pieces(results), results, truth[face]!));
  }
  return scores;
}

function bestFit(pieces: readonly Polygon[], { frame }: StageResults, truth: Region): number {
  const fits = pieces.map((piece) => intersectionOverUnion(filledRegion([piece], frame.frame), truth));
  return Math.max(0, ...fits);
}
