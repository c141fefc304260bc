import { heightColumns } from '../../../../src/core/building/columns/height-columns.ts';
import type { FreeColumns } from '../../../../src/core/building/faces/free-columns.ts';
import { makeCloud } from '../made-scan.ts';

/** Columns of upright rows of points at places x, y, m. */
export function columnsAt(places: readonly (readonly [number, number])[]) {
  const xyz = places.flatMap(([x, y]) => Array.from({ length: 50 }, (_, k) => [x, y, 0.1 + 0.05 * k]).flat());
  const cloud = makeCloud(xyz);
  const kept = Uint32Array.from({ length: cloud.positions.length / 3 }, (_, i) => i);
  return heightColumns(cloud, kept, { floor: 0, ceiling: 2.7 });
}

/** All columns free, none with a direction of its own. */
export function allFree(columns: ReturnType<typeof columnsAt>): FreeColumns {
  return {
    columns,
    angle: new Float64Array(columns.count).fill(Number.NaN),
    isFree: new Uint8Array(columns.count).fill(1),
  };
}
