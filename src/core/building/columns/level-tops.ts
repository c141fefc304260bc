import { highestBin, lowestBin } from './bin-masks.ts';
import { connectedColumns } from './connected-columns.ts';
import type { HeightColumns } from './height-columns.ts';

/** A smaller level surface may be a sill, m²: tables, beds and chests are larger. */
const SMALLEST_TOP = 0.25;

/**
 * 1 for the columns in which nothing was seen but the level top of furniture: no wall stands there, whatever of the floor
 * it hides. O(columns).
 */
export function levelTops(
  columns: Pick<HeightColumns, 'table' | 'size' | 'masks' | 'planes' | 'overhead'>,
): Uint8Array {
  const { table, size, masks, planes, overhead } = columns;
  // Noise spreads a surface over two bins.
  const heights = Int32Array.from(overhead, (above, c) => {
    const highest = highestBin(masks, c);
    const isTop = planes[c] === 0 && Number.isNaN(above) && highest - lowestBin(masks, c) <= 1;
    return isTop ? highest : -1;
  });
  const isTop = new Uint8Array(heights.length);
  const isVisited = Uint8Array.from(heights, (height) => (height < 0 ? 1 : 0));
  for (let seed = 0; seed < heights.length; seed++) {
    if (isVisited[seed] === 1) continue;
    isVisited[seed] = 1;
    const top = connectedColumns({ table }, seed, 1, (c, from) => {
      if (isVisited[c] === 1 || Math.abs(heights[c] - heights[from]) > 1) return false;
      isVisited[c] = 1;
      return true;
    });
    if (top.length * size * size >= SMALLEST_TOP) for (const c of top) isTop[c] = 1;
  }
  return isTop;
}
