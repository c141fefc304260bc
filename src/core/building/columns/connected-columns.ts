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
