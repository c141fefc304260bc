import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import { type Face, pointOn } from './face.ts';

/** Bits of a face. */
export interface FaceBits {
  /** Place along the face where the first begins, m. */
  readonly from: number;
  readonly step: number;
  readonly count: number;
}

/** The columns that lie along bits of a face, up to `reach` (m) on either side of it, each once. O(columns there). */
export function columnsAlong(
  columns: HeightColumns,
  face: Face,
  { from, step, count }: FaceBits,
  reach: number,
): Iterable<number> {
  const found = new Set<number>();
  for (let k = 0; k < count; k++) {
    for (let across = -reach; across <= reach; across += columns.size / 2) {
      const c = columnAt(columns, ...pointOn(face, from + (k + 0.5) * step, across));
      if (c >= 0) found.add(c);
    }
  }
  return found;
}
