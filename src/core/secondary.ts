import type { StageContext } from './context.ts';
import type { Options } from './params.ts';
import { findDetachedGroups } from './secondary/detached-groups.ts';
import { findByClusters } from './secondary/paper-clusters.ts';
import type { FoundStructure, StructureSearch } from './secondary/structure.ts';
import type { Operation, RegularisedBoundary, SecondaryBoundary, SecondaryResult, Slice } from './types.ts';

/**
 * Secondary boundaries: columns, shafts and cubicles inside the primary boundary ([Stojanovic19] §3.1).
 *
 * `paper` is the paper's clustering with the stroke filter, which keeps the innermost points, so its ring is
 * smaller than the structure by the thickness of the structure's walls; `robust` outlines groups of points
 * detached from the walls by their outer face, as the room sees it. Both look for `secondaryCount`, and say
 * so when they find fewer.
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
  const count = options.secondaryCount;
  if (count === 0 || regularised.polygons.length === 0)
    return { clusters: new Uint8Array(0), searches: [], boundaries: [] };
  const search = options.secondaryMethod === 'paper' ? findByClusters : findDetachedGroups;
  const {
    clusters,
    found,
    searches = [],
  }: StructureSearch = search(slice, regularised.polygons, options, context);
  if (found.length < count) {
    context.warn({
      code: 'secondary/fewer-found',
      message: `${count} secondary boundaries were asked for, ${found.length} found.`,
      hint:
        options.secondaryMethod === 'paper'
          ? 'Try the robust method, another seed or a thinner stroke.'
          : 'Try a level without furniture, or the paper method.',
    });
  }
  return { clusters, searches, boundaries: found.map((structure, k) => asBoundary(structure, k, options)) };
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
