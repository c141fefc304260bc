import type { StageContext } from './context.ts';
import { polygonArea, signedArea } from './geometry/rings.ts';
import type { Options } from './params.ts';
import { findDetachedGroups } from './secondary/detached-groups.ts';
import { findByClusters } from './secondary/paper-clusters.ts';
import { type FoundStructure, isWallPiece, type StructureSearch } from './secondary/structure.ts';
import type {
  Operation,
  Polygon,
  RegularisedBoundary,
  SecondaryBoundary,
  SecondaryResult,
  Slice,
} from './types.ts';

/** What covers more than this share of the primary boundary is no structure in the plan but the plan itself. */
const LARGEST_SHARE = 0.5;

/**
 * Secondary boundaries: columns, shafts and cubicles inside the primary boundary ([Stojanovic19] §3.1).
 *
 * `paper` is the paper's clustering with the stroke filter, which keeps the innermost points, so its ring is
 * smaller than the structure by the thickness of the structure's walls; `robust` outlines groups of points
 * detached from the walls by their outer face, as the room sees it. Both look for `secondaryCount`, or propose a
 * number, and warn of what they could not find and of slivers; what would eat the plan is left out.
 *
 * @param slice metres, plan frame
 * @param regularised primary boundary
 * @throws environment/canvas, only with `paper`
 */
export function findSecondary(
  slice: Slice,
  regularised: RegularisedBoundary,
  options: Options,
  context: StageContext,
): SecondaryResult {
  const { polygons } = regularised;
  if (options.secondaryCount === 0 || polygons.length === 0)
    return { clusters: new Uint8Array(0), searches: [], boundaries: [] };
  const search = options.secondaryMethod === 'paper' ? findByClusters : findDetachedGroups;
  const {
    clusters,
    wanted,
    found,
    searches = [],
  }: StructureSearch = search(slice, polygons, options, context);
  const kept = withoutPlanCovers(found, polygons, options, context);
  warnOfSlivers(kept, options, context);
  if (kept.length < wanted) warnOfFewer(kept.length, wanted, options, context);
  return { clusters, searches, boundaries: kept.map((structure, k) => asBoundary(structure, k, options)) };
}

function withoutPlanCovers(
  found: readonly FoundStructure[],
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): readonly FoundStructure[] {
  const area = primary.reduce((sum, polygon) => sum + polygonArea(polygon), 0);
  return found.filter(({ outline }) => {
    const share = signedArea(outline) / area;
    if (share <= LARGEST_SHARE) return true;
    context.warn({
      code: 'secondary/covers-plan',
      message: `A secondary boundary would cover ${(100 * share).toFixed(0)} % of the plan; it is left out.`,
      hint:
        options.secondaryMethod === 'paper'
          ? 'Ask for another number of secondary boundaries, pick another cluster, or take the robust method.'
          : 'Take a level without what stands along the walls, or ask for another number of secondary boundaries.',
    });
    return false;
  });
}

function warnOfSlivers(
  found: readonly FoundStructure[],
  { secondaryMethod }: Options,
  context: StageContext,
): void {
  const slivers = [...found.keys()].filter((k) => isWallPiece(found[k].outline));
  if (slivers.length === 0) return;
  const numbers = slivers.map((k) => k + 1).join(', ');
  context.warn({
    code: 'secondary/sliver',
    message: `Secondary ${slivers.length === 1 ? `boundary ${numbers} is` : `boundaries ${numbers} are`} as long and thin, or as ragged, as a piece of a wall.`,
    hint:
      secondaryMethod === 'paper'
        ? 'Ask for fewer secondary boundaries, or take the robust method.'
        : 'Ask for fewer secondary boundaries, or let their number be auto.',
  });
}

function warnOfFewer(found: number, wanted: number, options: Options, context: StageContext): void {
  const isProposal = options.secondaryCount === 'auto';
  context.warn({
    code: 'secondary/fewer-found',
    message: `${wanted} secondary ${wanted === 1 ? 'boundary was' : 'boundaries were'} ${isProposal ? 'proposed' : 'asked for'}, ${found} found.`,
    hint:
      options.secondaryMethod === 'paper'
        ? 'Try the robust method, another seed or a thinner stroke.'
        : 'Try a level without furniture, or the paper method.',
  });
}

function asBoundary(
  { outline, type, points }: FoundStructure,
  k: number,
  options: Options,
): SecondaryBoundary {
  const operations: readonly Operation[] = options.secondaryOperation;
  const operation = operations[Math.min(k, operations.length - 1)];
  return { outline: { outer: outline, holes: [] }, operation, type, points };
}
