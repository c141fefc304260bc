import type { PointCloud } from '../../types.ts';
import { columnAt, type HeightColumns } from '../columns/height-columns.ts';

/** A stretch of wall to look into. */
export interface WallStretch {
  /** Where it starts on the face the room sees, and the direction along it; the room is on the left. */
  readonly x: number;
  readonly y: number;
  readonly ux: number;
  readonly uy: number;
  readonly length: number;
  /** How deep to look, m. */
  readonly depth: number;
}

/** The points in and on a wall: place along it, depth behind its face and height above the floor, m each. */
export interface WallStrip {
  readonly count: number;
  readonly along: Float64Array;
  readonly deep: Float64Array;
  readonly high: Float64Array;
}

/** How far before the face, m, points may lie that noise put there. */
const BEFORE = 0.06;

/** The points of a storey in a stretch of wall. O(columns of the stretch + points). */
export function wallStrip(cloud: PointCloud, columns: HeightColumns, stretch: WallStretch): WallStrip {
  const { size, start, points, heights } = columns;
  const { positions } = cloud;
  const { x, y, ux, uy, length, depth } = stretch;
  const seen = new Set<number>();
  for (let s = -size; s <= length + size; s += size / 2) {
    for (let d = -BEFORE - size; d <= depth + size; d += size / 2) {
      const [px, py] = [x + s * ux + d * uy, y + s * uy - d * ux];
      const c = columnAt(columns, px, py);
      if (c >= 0) seen.add(c);
    }
  }
  let most = 0;
  for (const c of seen) most += start[c + 1] - start[c];
  const [along, deep, high] = [new Float64Array(most), new Float64Array(most), new Float64Array(most)];
  let count = 0;
  for (const c of seen) {
    for (let k = start[c]; k < start[c + 1]; k++) {
      const i = 3 * points[k];
      const [dx, dy] = [positions[i] - x, positions[i + 1] - y];
      const s = dx * ux + dy * uy;
      const d = dx * uy - dy * ux;
      if (s < 0 || s > length || d < -BEFORE || d > depth + BEFORE) continue;
      along[count] = s;
      deep[count] = d;
      high[count++] = positions[i + 2] - heights.floor;
    }
  }
  return {
    count,
    along: along.subarray(0, count),
    deep: deep.subarray(0, count),
    high: high.subarray(0, count),
  };
}
