import { pointInPolygon } from '../../geometry/rings.ts';
import { medianOf } from '../../robust-scale.ts';
import type { PointCloud, Polygon } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';

/** Fewer columns with a ceiling tell nothing of a room's. */
const FEWEST = 20;
/** So many columns tell a room's height as well as all of them do. */
const MOST_COLUMNS = 20_000;

/** Heights of rooms, m: the median over their columns of a point that hangs over each; the storey's where there are few. O(columns · rooms). */
export function roomHeights(cloud: PointCloud, columns: HeightColumns, rooms: readonly Polygon[]): number[] {
  const { count, centres, overPoints, overStart, table, size, heights } = columns;
  const ofRoom: number[][] = rooms.map(() => []);
  for (let c = 0; c < count; c++) {
    if (overStart[c + 1] === overStart[c]) continue;
    const [ix, iy] = table.coordinatesOf(c);
    const [x, y] = Number.isNaN(centres[2 * c])
      ? [(ix + 0.5) * size, (iy + 0.5) * size]
      : [centres[2 * c], centres[2 * c + 1]];
    const room = rooms.findIndex((polygon) => pointInPolygon(x, y, polygon) > 0);
    if (room >= 0) ofRoom[room].push(c);
  }
  return ofRoom.map((own) => {
    if (own.length < FEWEST) return heights.ceiling - heights.floor;
    const zs: number[] = [];
    const step = Math.ceil(own.length / MOST_COLUMNS);
    for (let k = 0; k < own.length; k += step)
      zs.push(cloud.positions[3 * overPoints[overStart[own[k]]] + 2]);
    return medianOf(Float64Array.from(zs)) - heights.floor;
  });
}
