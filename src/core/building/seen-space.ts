import { columnAt, type HeightColumns } from './height-columns.ts';

/** A column with points in more of its bins is a wall's or furniture's: what is seen above or below it tells nothing. */
const CLEAR_SHARE = 0.3;
/** … and so does a column with points in more of its bins below the ceiling: a lintel hangs there. */
const LINTEL_SHARE = 0.4;

/** Where a floor or a ceiling was seen and nothing stands. */
export interface SeenSpace {
  /** 1 for the columns that are clear, as their neighbours are, and seen. */
  readonly isSeen: Uint8Array;
  /** Whether the ceiling hangs free over a place, or where a storey has none the floor was seen there. */
  at(x: number, y: number): boolean;
}

/** A column beside a wall may reach into it, so it does not count. O(columns). */
export function seenSpace(columns: HeightColumns): SeenSpace {
  const { table, count, hits, bins, topHits, topBins, planes, overhead } = columns;
  const isSeen = new Uint8Array(count);
  const isClear = (c: number) =>
    c < 0 || (hits[c] <= CLEAR_SHARE * bins && topHits[c] <= LINTEL_SHARE * topBins);
  for (let c = 0; c < count; c++) {
    if (planes[c] === 0 && Number.isNaN(overhead[c])) continue;
    const [ix, iy] = table.coordinatesOf(c);
    let clear = true;
    for (let dy = -1; dy <= 1 && clear; dy++) {
      for (let dx = -1; dx <= 1 && clear; dx++) clear = isClear(table.find(ix + dx, iy + dy, 0));
    }
    isSeen[c] = clear ? 1 : 0;
  }
  const hasCeiling = isCeiled(columns);
  return {
    isSeen,
    at(x, y) {
      const c = columnAt(columns, x, y);
      return c >= 0 && isClear(c) && (hasCeiling ? !Number.isNaN(overhead[c]) : planes[c] !== 0);
    },
  };
}

/** Whether most of the floor has a ceiling over it. */
function isCeiled({ planes, overhead }: HeightColumns): boolean {
  let [floored, ceiled] = [0, 0];
  for (let c = 0; c < planes.length; c++) {
    if (planes[c] & 1) floored++;
    if (!Number.isNaN(overhead[c])) ceiled++;
  }
  return ceiled > floored / 2;
}
