import type { HeightColumns } from './height-columns.ts';

/**
 * Columns that hang together with one, itself first, where neighbours are no more than `reach` columns apart either way.
 *
 * @param takes whether a column joins one of them; it must not take one twice, nor the first. O(columns found · reach²).
 */
export function connectedColumns(
  { table }: Pick<HeightColumns, 'table'>,
  first: number,
  reach: number,
  takes: (column: number, from: number) => boolean,
): number[] {
  const found = [first];
  for (let k = 0; k < found.length; k++) {
    const [ix, iy] = table.coordinatesOf(found[k]);
    for (let dy = -reach; dy <= reach; dy++) {
      for (let dx = -reach; dx <= reach; dx++) {
        const c = table.find(ix + dx, iy + dy, 0);
        if (c >= 0 && takes(c, found[k])) found.push(c);
      }
    }
  }
  return found;
}

/**
 * The level surfaces that columns make with their neighbours, where heights differ by no more than `step` from one to the
 * next; columns without a height, NaN, are of none. O(columns).
 */
export function levelSurfaces(
  columns: Pick<HeightColumns, 'table'>,
  heights: Float32Array,
  step: number,
): number[][] {
  const isVisited = Uint8Array.from(heights, (height) => (Number.isNaN(height) ? 1 : 0));
  const surfaces: number[][] = [];
  for (let seed = 0; seed < heights.length; seed++) {
    if (isVisited[seed] === 1) continue;
    isVisited[seed] = 1;
    const surface = connectedColumns(columns, seed, 1, (c, from) => {
      if (isVisited[c] === 1 || Math.abs(heights[c] - heights[from]) > step) return false;
      isVisited[c] = 1;
      return true;
    });
    surfaces.push(surface);
  }
  return surfaces;
}
