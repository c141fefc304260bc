import { findBoundary } from '../../src/core/boundary.ts';
import { FloorPlanError } from '../../src/core/errors.ts';
import { meanSpacing } from '../../src/core/geometry/spacing.ts';
import { resolveOptions } from '../../src/core/options.ts';
import type { Options } from '../../src/core/params.ts';
import type { Polygon } from '../../src/core/types.ts';
import { polygonProblems } from '../invariants.ts';
import type { HostilePoints } from './hostile-points.ts';

const ALLOWED = ['input/degenerate', 'result/no-boundary'];
const context = {
  warn: () => {},
  progress: () => {},
  strokeTest: () => {
    throw new Error('The primary boundary needs no canvas.');
  },
};

/** The outline of a hostile set, or null where the stage says by name that there is none; any other error is thrown. */
export function hostileOutline(
  { xy, openingLength, bridgeGap, alpha }: HostilePoints,
  boundary: Options['boundary'],
): readonly Polygon[] | null {
  // Sizes beyond what a person may give.
  const options = { ...resolveOptions({ boundary }), openingLength, bridgeGap, alpha };
  const slice = { xy, band: [0, 1] as const, spacing: meanSpacing(xy) };
  try {
    return findBoundary(slice, options, context).polygons;
  } catch (error) {
    if (error instanceof FloorPlanError && ALLOWED.includes(error.code)) return null;
    throw error;
  }
}

/** What is wrong with the outline of a hostile set, each with the set's name; empty when nothing is. */
export function hostileProblems(points: HostilePoints, boundary: Options['boundary']): string[] {
  try {
    const problems = hostileOutline(points, boundary)?.flatMap((polygon) => polygonProblems(polygon));
    return (problems ?? []).map((problem) => `${points.name}: ${problem}`);
  } catch (error) {
    return [`${points.name}: ${error instanceof Error ? error.message : error}`];
  }
}
