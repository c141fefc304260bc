import { pointInRing } from '../../geometry/rings.ts';
import type { Ring } from '../../types.ts';
import type { StandingPoints } from './standing-points.ts';

/** Share of a thing's columns that are no higher than its top is said to be: a lamp on a table is not the table. */
const TOP_RANK = 0.9;

/** Height of the top of the columns within an outline, m; NaN where none is. */
export function heightWithin(
  { columns, top }: StandingPoints,
  group: readonly number[],
  outline: Ring,
): number {
  const { table, size } = columns;
  const tops = group.filter((c) => {
    const [ix, iy] = table.coordinatesOf(c);
    return pointInRing((ix + 0.5) * size, (iy + 0.5) * size, outline) > 0;
  });
  const sorted = Float64Array.from(tops, (c) => top[c]).sort();
  return sorted[Math.floor(TOP_RANK * (sorted.length - 1))] ?? Number.NaN;
}

/** Share of an outline along which something was seen to stand, within a column's width. */
export function seenShare({ columns, room }: StandingPoints, outline: Ring): number {
  const { table, size } = columns;
  let [seen, count] = [0, 0];
  for (let i = 0; i < outline.length; i += 2) {
    const j = (i + 2) % outline.length;
    const [dx, dy] = [outline[j] - outline[i], outline[j + 1] - outline[i + 1]];
    const steps = Math.ceil(Math.hypot(dx, dy) / size);
    for (let k = 0; k < steps; k++) {
      const [ix, iy] = [outline[i] + (k / steps) * dx, outline[i + 1] + (k / steps) * dy].map((at) =>
        Math.floor(at / size),
      );
      count++;
      if (isNearStanding(table, room, ix, iy)) seen++;
    }
  }
  return seen / count;
}

function isNearStanding(
  table: StandingPoints['columns']['table'],
  room: Int32Array,
  ix: number,
  iy: number,
): boolean {
  for (let dy = -1; dy <= 1; dy++) {
    for (let dx = -1; dx <= 1; dx++) {
      const c = table.find(ix + dx, iy + dy, 0);
      if (c >= 0 && room[c] >= 0) return true;
    }
  }
  return false;
}
