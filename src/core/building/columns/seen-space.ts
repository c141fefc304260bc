import { countBins } from './bin-masks.ts';
import { binAt, columnAt, type HeightColumns, topShare } from './height-columns.ts';
import { levelTops } from './level-tops.ts';

/** A column with points in more of its bins is a wall's or furniture's: what is seen above or below it tells nothing. */
const CLEAR_SHARE = 0.3;
/** … and so does a column with points in more of its bins below the ceiling: a lintel hangs there. */
const LINTEL_SHARE = 0.4;

/** What is not seen between places that are, no farther apart than this, m, is solid: a thick inner wall. */
const THICKEST_SOLID = 0.45;
const FOUR_WAYS = [
  [1, 0],
  [0, 1],
  [1, 1],
  [1, -1],
] as const;

/** Along a hidden stretch, or between the faces of a wall, hardly any place shows a floor or a ceiling. */
export const OPEN_SHARE = 0.15;

/** Where a floor or a ceiling was seen and nothing stands. */
export interface SeenSpace {
  /** 1 for the columns that are clear, as their neighbours are, and seen. */
  readonly isSeen: Uint8Array;
  /** 1 for the columns that show no space themselves, but have such ones near on two opposite sides. */
  readonly isBetween: Uint8Array;
  /**
   * Whether the ceiling hangs free over a place, or where a storey has none the floor was seen there.
   *
   * @param reach how far from it, m, the ceiling's points in its column may lie in the mean: a column reaches past a thin wall
   */
  at(x: number, y: number, reach?: number): boolean;
  /** Whether a floor, a ceiling or the top of a table was seen at a place where nothing stands higher. */
  isOpen(x: number, y: number): boolean;
}

/**
 * A column beside a wall may reach into it, so it does not count; nor is it solid where space was seen in it. O(columns).
 *
 * Not taken: such columns as seen (hard corners at 5 cm .670 → .655, a wall of a coarse corridor goes); as solid unless their
 * neighbours are clear (.698 → .689: strips before walls are called solid).
 */
export function seenSpace(columns: HeightColumns): SeenSpace {
  const { table, count, planes, overhead, overCentres } = columns;
  const isSeen = new Uint8Array(count);
  const isClear = (c: number) => c < 0 || isClearColumn(columns, c);
  const isBare = new Uint8Array(count);
  for (let c = 0; c < count; c++) {
    if (planes[c] === 0 && Number.isNaN(overhead[c])) continue;
    isBare[c] = isClear(c) ? 1 : 0;
    const [ix, iy] = table.coordinatesOf(c);
    let clear = true;
    for (let dy = -1; dy <= 1 && clear; dy++) {
      for (let dx = -1; dx <= 1 && clear; dx++) clear = isClear(table.find(ix + dx, iy + dy, 0));
    }
    isSeen[c] = clear ? 1 : 0;
  }
  const hasCeiling = isCeiled(columns);
  const isTop = levelTops(columns);
  const clearAt = (x: number, y: number) => {
    const c = columnAt(columns, x, y);
    return c >= 0 && isClear(c) ? c : -1;
  };
  return {
    isSeen,
    isBetween: betweenSeen(columns, isSeen, isBare),
    at(x, y, reach = Infinity) {
      const c = clearAt(x, y);
      if (c < 0 || !hasCeiling) return c >= 0 && planes[c] !== 0;
      const way = Math.hypot(overCentres[2 * c] - x, overCentres[2 * c + 1] - y);
      return !Number.isNaN(overhead[c]) && !(way > reach);
    },
    isOpen(x, y) {
      const c = clearAt(x, y);
      return c >= 0 && (planes[c] !== 0 || !Number.isNaN(overhead[c]) || isTop[c] === 1);
    },
  };
}

/** Whether hardly anything is in a column below its ceiling, and no wall's top over it. */
export function isClearColumn(columns: HeightColumns, c: number): boolean {
  const { overhead, masks, heights, isWallTop } = columns;
  if (isWallTop[c] === 1) return false;
  const z = Number.isNaN(overhead[c]) ? heights.ceiling : overhead[c];
  const bins = binAt(columns, z);
  return countBins(masks, c, 0, bins) <= CLEAR_SHARE * bins && topShare(columns, masks, c, z) <= LINTEL_SHARE;
}

function betweenSeen(
  { table, size, count }: HeightColumns,
  isSeen: Uint8Array,
  isBare: Uint8Array,
): Uint8Array {
  const reach = Math.round(THICKEST_SOLID / size);
  const wayToSeen = (ix: number, iy: number, dx: number, dy: number) => {
    for (let k = 1; k <= reach; k++) {
      const c = table.find(ix + k * dx, iy + k * dy, 0);
      if (c >= 0 && isSeen[c] === 1) return k;
    }
    return Infinity;
  };
  return Uint8Array.from({ length: count }, (_, c) => {
    if (isSeen[c] === 1 || isBare[c] === 1) return 0;
    const [ix, iy] = table.coordinatesOf(c);
    const isBetween = FOUR_WAYS.some(
      ([dx, dy]) => wayToSeen(ix, iy, dx, dy) + wayToSeen(ix, iy, -dx, -dy) <= reach + 2,
    );
    return isBetween ? 1 : 0;
  });
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
