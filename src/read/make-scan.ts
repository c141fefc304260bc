import { countOf } from '../core/count-words.ts';
import type { PointAttributes, Scan, Vec3, Warning } from '../core/types.ts';
import type { OpenCloud } from './cloud-reader.ts';
import { FARTHEST } from './is-place.ts';
import type { ThinnedPoints } from './thin/thinned-points.ts';
import { powerOfTwoBelow, type Thinning } from './thin/thinning.ts';

/** Step between 32-bit floats, as a share of the power of two below them. */
const FLOAT_STEP = 2 ** -23;

export interface ScanFacts {
  readonly name: string;
  readonly format: string;
  readonly bytes: number;
  readonly cloud: OpenCloud;
  /** Cell that was asked for, source units. */
  readonly target: number;
  /** Told while reading, beside the cloud's own. */
  readonly warnings: readonly Warning[];
}

/** The points that thinning kept, in an order that does not depend on the file's; step by step. Complexity: O(n). */
export function* makeScan(
  thinning: Thinning,
  { name, format, bytes, cloud, target, warnings }: ScanFacts,
): Generator<void, Scan> {
  const { bounds } = thinning;
  const origin = thinning.sample.middle();
  const points = yield* thinning.ordering(origin, (length) => new Float32Array(length));
  const { count } = points;
  return {
    facts: {
      name,
      format,
      bytes,
      pointsRead: thinning.read,
      pointsDropped: thinning.dropped,
      pointsKept: count,
    },
    positions: points.positions,
    origin,
    bounds: { min: [...bounds.min], max: [...bounds.max] },
    attributes: withoutBlanks(points.attributes),
    cellSize: thinning.cell,
    isSlice: cloud.isSlice,
    ...(cloud.unit && { unit: cloud.unit }),
    ...(cloud.up && { up: cloud.up }),
    ...(cloud.crs && { crs: cloud.crs }),
    stations: cloud.stations ?? [],
    warnings: [
      ...cloud.warnings,
      ...warnings,
      ...warningsOf(thinning, cloud, { count, target }),
      ...coarseFloats(points, origin, target),
    ],
  };
}

/** A format may have room for colour and intensity that nothing was written to: black without exception is none. */
function withoutBlanks({ colour, intensity, ...others }: PointAttributes): PointAttributes {
  return {
    ...(colour?.some((value) => value !== 0) && { colour }),
    ...(intensity?.some((value) => value !== 0) && { intensity }),
    ...others,
  };
}

function warningsOf(
  { dropped, read, cell }: Thinning,
  cloud: OpenCloud,
  { count, target }: { count: number; target: number },
): Warning[] {
  const warnings: Warning[] = [];
  if (dropped > 0 && !cloud.hasEmptyPlaces) {
    warnings.push({
      code: 'read/points-dropped',
      message: `${dropped.toLocaleString('en-GB')} of ${countOf(read, 'point')} left out: without a place, or beyond ±${FARTHEST.toExponential(0)}.`,
      hint: 'If points are missing in the plan, export the cloud again without invalid points.',
    });
  }
  if (cell > target) {
    warnings.push({
      code: 'read/thinned-to-budget',
      message: `To stay within the point budget the cloud was thinned to ${countOf(count, 'point')}, one a cell of ${cell} source units.`,
      hint: 'Raise the point budget where memory allows.',
    });
  }
  return warnings;
}

/** 32-bit floats far from zero are too few: at a UTM northing they lie half a metre apart, and walls with them. */
function coarseFloats({ areSingle }: ThinnedPoints<Float32Array>, origin: Vec3, target: number): Warning[] {
  const step = FLOAT_STEP * powerOfTwoBelow(Math.max(1, ...origin.map(Math.abs)));
  if (target === 0 || step <= target || !areSingle) return [];
  return [
    {
      code: 'read/coarse-coordinates',
      message: `The coordinates were saved as 32-bit floats and are rounded to steps of ${step} source units.`,
      hint: 'Save the cloud in double precision, or move it near the origin before it is saved.',
    },
  ];
}
