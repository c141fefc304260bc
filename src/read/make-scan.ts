import type { Scan, Vec3, Warning } from '../core/types.ts';
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
}

/** The points that thinning kept, in an order that does not depend on the file's. Complexity: O(n). */
export function makeScan(thinning: Thinning, { name, format, bytes, cloud, target }: ScanFacts): Scan {
  const { xyz, count, bounds } = thinning;
  const origin = thinning.sample.middle();
  const cell = thinning.cell || powerOfTwoBelow(diagonalOf(bounds) * ORDER_SHARE);
  const indices = orderByCell({ xyz, count, cell, centre: origin });
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
    attributes: thinning.attributesOf(indices),
    cellSize: thinning.cell,
    isSlice: cloud.isSlice,
    ...(cloud.unit && { unit: cloud.unit }),
    ...(cloud.crs && { crs: cloud.crs }),
    stations: cloud.stations ?? [],
    warnings: [
      ...cloud.warnings,
      ...warningsOf(thinning, cloud, target),
      ...coarseFloats(thinning, origin, target),
    ],
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
      message: `${dropped} of ${read} points have no place, or one beyond ±${FARTHEST.toExponential(0)}, and were left out.`,
    });
  }
  if (cell > target) {
    warnings.push({
      code: 'read/thinned-to-budget',
      message: `To stay within the point budget the cloud was thinned to ${count} points, one a cell of ${cell} source units.`,
      hint: 'Raise the point budget where memory allows.',
    });
  }
  return warnings;
}

/** 32-bit floats far from zero are too few: at a UTM northing they lie half a metre apart, and walls with them. */
function coarseFloats({ bounds }: Thinning, origin: Vec3, target: number): Warning[] {
  const step = FLOAT_STEP * powerOfTwoBelow(Math.max(1, ...origin.map(Math.abs)));
  const isFloat = [...bounds.min, ...bounds.max].every((value) => value === Math.fround(value));
  if (target === 0 || step <= target || !isFloat) return [];
  return [
    {
      code: 'read/coarse-coordinates',
      message: `The coordinates were saved as 32-bit floats and are rounded to steps of ${step} source units.`,
      hint: 'Save the cloud in double precision, or move it near the origin before it is saved.',
    },
  ];
}
