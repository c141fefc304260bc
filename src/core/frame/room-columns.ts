import { CellTable } from '../cell-table.ts';
import type { Vec3 } from '../types.ts';
import { multiply, type Rotation, rotate, rotationToZ } from './rotation.ts';
import type { SurfacePatches } from './surface-patches.ts';

/** Columns a patch edge: with 32 points a patch, a column through a table top holds three or four. */
const COLUMNS_A_PATCH = 3;

/** The space between two neighbouring planes, along the up vector from the positions' origin. */
export interface RoomGap {
  readonly low: number;
  readonly high: number;
}

/** A cloud cut into upright columns: what is below, above and beside what. */
export interface RoomColumns {
  /** Their places, in edges. */
  readonly table: CellTable;
  /** Of a column's square base, source units. */
  readonly edge: number;
  /** The column of each point looked at. */
  readonly columns: Int32Array;
  /** Of each point looked at, along the up vector from the positions' origin. */
  readonly heights: Float64Array;
}

/**
 * Sorts points into columns along an estimate of up. O(n), at most a million points are looked at.
 *
 * @param rotation source axes → plan axes, and the estimate in source axes
 */
export function roomColumns(
  positions: Float32Array,
  { size, stride }: SurfacePatches,
  { upright, up }: { readonly upright: Rotation; readonly up: Vec3 },
): RoomColumns {
  const r = multiply(rotationToZ(rotate(upright, up)), upright);
  const edge = size / COLUMNS_A_PATCH;
  const count = Math.ceil(positions.length / (3 * stride));
  const table = new CellTable();
  const columns = new Int32Array(count);
  const heights = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    const p = 3 * i * stride;
    const [x, y, z] = [positions[p], positions[p + 1], positions[p + 2]];
    heights[i] = r[6] * x + r[7] * y + r[8] * z;
    const u = Math.floor((r[0] * x + r[1] * y + r[2] * z) / edge);
    columns[i] = table.add(u, Math.floor((r[3] * x + r[4] * y + r[5] * z) / edge), 0);
  }
  return { table, edge, columns, heights };
}
