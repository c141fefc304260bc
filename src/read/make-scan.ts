import { countOf } from '../core/count-words.ts';
import type { PointAttributes, Scan, Vec3, Warning } from '../core/types.ts';
import type { OpenCloud } from './cloud-reader.ts';
import { orderByCell } from './thin/cell-order.ts';
import { diagonalOf, FARTHEST, powerOfTwoBelow, type Thinning } from './thin/thinning.ts';

/** Cell that orders a slice, which has none, as a share of its extent. */
const ORDER_SHARE = 2 ** -15;
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

/** The points that thinning kept, in an order that does not depend on the file's. Complexity: O(n). */
export function makeScan(
  thinning: Thinning,
  { name, format, bytes, cloud, target, warnings }: ScanFacts,
): Scan {
  const { xyz, count, bounds } = thinning;
  const origin = thinning.sample.middle();
  const cell = thinning.cell || powerOfTwoBelow(diagonalOf(bounds) * ORDER_SHARE);
  const indices = orderByCell({ xyz, count, cell, centre: origin, bounds });
  return {
    facts: {
      name,
      format,
      bytes,
      pointsRead: thinning.read,
      pointsDropped: thinning.dropped,
      pointsKept: count,
    },
    positions: positionsOf(thinning, indices, origin),
    origin,
    bounds: { min: [...bounds.min], max: [...bounds.max] },
    attributes: withoutBlanks(thinning.attributesOf(indices)),
    cellSize: thinning.cell,
    isSlice: cloud.isSlice,
    ...(cloud.unit && { unit: cloud.unit }),
    ...(cloud.up && { up: cloud.up }),
    ...(cloud.crs && { crs: cloud.crs }),
    stations: cloud.stations ?? [],
    warnings: [
      ...cloud.warnings,
      ...warnings,
      ...warningsOf(thinning, cloud, target),
      ...coarseFloats(thinning, origin, target),
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

/** x, y, z of the points at `indices`, source units, relative to `origin`. */
function positionsOf({ xyz }: Thinning, indices: Uint32Array, origin: Vec3): Float32Array {
  const [x, y, z] = origin;
  const positions = new Float32Array(3 * indices.length);
  for (let i = 0; i < indices.length; i++) {
    const at = 3 * indices[i];
    positions[3 * i] = xyz[at] - x;
    positions[3 * i + 1] = xyz[at + 1] - y;
    positions[3 * i + 2] = xyz[at + 2] - z;
  }
  return positions;
}

function warningsOf({ dropped, read, cell, count }: Thinning, cloud: OpenCloud, target: number): Warning[] {
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
function coarseFloats({ xyz, count }: Thinning, origin: Vec3, target: number): Warning[] {
  const step = FLOAT_STEP * powerOfTwoBelow(Math.max(1, ...origin.map(Math.abs)));
  if (target === 0 || step <= target) return [];
  for (let i = 0; i < 3 * count; i++) if (xyz[i] !== Math.fround(xyz[i])) return [];
  return [
    {
      code: 'read/coarse-coordinates',
      message: `The coordinates were saved as 32-bit floats and are rounded to steps of ${step} source units.`,
      hint: 'Save the cloud in double precision, or move it near the origin before it is saved.',
    },
  ];
}
