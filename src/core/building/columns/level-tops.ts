import { highestBin, lowestBin } from './bin-masks.ts';
import { levelSurfaces } from './connected-columns.ts';
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
  const bins = Float32Array.from(overhead, (above, c) => {
    const highest = highestBin(masks, c);
    const isLevel = highest >= 0 && highest - lowestBin(masks, c) <= 1;
    return planes[c] === 0 && Number.isNaN(above) && isLevel ? highest : Number.NaN;
  });
  const isTop = new Uint8Array(bins.length);
  for (const top of levelSurfaces({ table }, bins, 1)) {
    if (top.length * size * size >= SMALLEST_TOP) for (const c of top) isTop[c] = 1;
  }
  return isTop;
}
