import { type HeightColumns, topShare } from './height-columns.ts';
import type { LocalCeiling } from './local-ceiling.ts';
import { isClearColumn } from './seen-space.ts';

/** Columns with hits in fewer of their bins are no wall … */
const LEAST_HITS = 0.3;
/** … unless so many of those below a ceiling beside them are hit. */
const LEAST_TOP_HITS = 0.5;
/** Distance at which a column's ceilings are looked up, m: past the wall. */
const BESIDE = 0.4;
const SIDES = [
  [BESIDE, 0],
  [-BESIDE, 0],
  [0, BESIDE],
  [0, -BESIDE],
] as const;

/**
 * Marks the columns of a storey that may belong to walls: they are filled over much of its height, or below the ceiling.
 *
 * Not taken: to look at 25 cm below the ceiling only, as for the support of a face. Walls above cupboards come out (hard rooms
 * F1 .926 → .935), but lines are drawn off by what else is up there (hard corners at 5 cm .62 → .53).
 */
export function wallColumns(columns: HeightColumns, ceiling: LocalCeiling): Uint8Array {
  const { count, hits, overhead } = columns;
  return Uint8Array.from({ length: count }, (_, c) => {
    const isCeiling = !Number.isNaN(overhead[c]) && isClearColumn(columns, c);
    if (hits[c] === 0 || isCeiling) return 0;
    return standsHigh(columns, c) || reachesCeiling(columns, ceiling, c) ? 1 : 0;
  });
}

/** Whether a column is filled over much of the storey's height: furniture and what hangs below the ceiling only is not. */
export function standsHigh({ hits, bins }: HeightColumns, c: number): boolean {
  return hits[c] >= LEAST_HITS * bins;
}

function reachesCeiling(columns: HeightColumns, ceiling: LocalCeiling, c: number): boolean {
  const { centres, masks } = columns;
  return SIDES.some(([dx, dy]) => {
    const z = ceiling.at(centres[2 * c] + dx, centres[2 * c + 1] + dy);
    return topShare(columns, masks, c, z) >= LEAST_TOP_HITS;
  });
}
