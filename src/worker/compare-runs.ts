import type { StageResults } from '../core/stage-results.ts';
import type { StageName } from '../core/stages.ts';
import type { Polygon } from '../core/types.ts';
import type { ScanResult } from '../session/result.ts';
import { comparePolygons } from '../write/pictures/compare-polygons.ts';
import { drawComparison } from '../write/pictures/comparison.ts';
import type { Comparison } from './protocol.ts';

export interface ComparedRuns {
  /** What the plan shown and the other are called. */
  readonly labels: readonly [here: string, there: string];
  readonly here: StageResults;
  readonly there: ScanResult;
  /** What each stage took when it last ran for the plan shown, ms. */
  readonly times: ReadonlyMap<StageName, number>;
}

/**
 * Two runs of one scan side by side. Measured is what differs: the primary boundaries, or where those are the same
 * result the secondary boundaries.
 */
export function compareRuns({ labels, here, there, times }: ComparedRuns): Comparison {
  const isOutlineSame = here.regularise === there.regularise;
  const subject = isOutlineSame && here.secondary !== there.secondary ? 'secondary' : 'primary';
  const { vertices, areaM2, iou, distance95 } = comparePolygons(
    polygonsOf(here, subject),
    polygonsOf(there, subject),
  );
  const ran = there.stages.filter(({ isCached }) => !isCached);
  const sides = [
    { label: labels[0], results: here },
    { label: labels[1], results: there },
  ] as const;
  // Both runs came to their end, so both have an outline to draw.
  const draw = (layout: 'overlaid' | 'beside') => drawComparison(...sides, { layout, subject })!;
  const planOf = ({ solid }: StageResults, side: 0 | 1, ms: number) => ({
    vertices: vertices[side],
    areaM2: areaM2[side],
    triangles: solid.indices.length / 3,
    ms,
  });
  return {
    overlaid: draw('overlaid'),
    beside: draw('beside'),
    subject,
    here: planOf(here, 0, sum(ran.map(({ name }) => times.get(name) ?? 0))),
    there: planOf(there, 1, sum(ran.map(({ ms }) => ms))),
    iou,
    distance: distance95,
  };
}

function polygonsOf(
  { regularise, secondary }: StageResults,
  subject: Comparison['subject'],
): readonly Polygon[] {
  return subject === 'primary' ? regularise.polygons : secondary.boundaries.map(({ outline }) => outline);
}

function sum(values: readonly number[]): number {
  return values.reduce((total, value) => total + value, 0);
}
