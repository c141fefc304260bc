import type { AutoNumberRow, NumberRow } from '../core/param-rows.ts';

/** Ranges of more steps than this are too fine for an even slider: theirs grows with the cube of its travel. */
const EVEN_STEPS = 200;
/** Ranges past this many steps (seeds, budgets) are typed, not slid. */
const MOST_STEPS = 1e6;

type Row = NumberRow | AutoNumberRow;

export function hasSlider({ min, max, step }: Row): boolean {
  return (max - min) / step <= MOST_STEPS;
}

/** Value → travel from 0 to 1. */
export function toTravel(value: number, row: Row): number {
  const share = (value - row.min) / (row.max - row.min);
  return Math.min(1, Math.max(0, share)) ** (1 / power(row));
}

/** Travel from 0 to 1 → a value on the row's steps, within its range. */
export function fromTravel(travel: number, row: Row): number {
  const value = row.min + (row.max - row.min) * travel ** power(row);
  const stepped = row.min + Math.round((value - row.min) / row.step) * row.step;
  return clean(Math.min(row.max, Math.max(row.min, stepped)));
}

function power({ min, max, step }: Row): number {
  return (max - min) / step > EVEN_STEPS ? 3 : 1;
}

/** 0.30000000000000004 → 0.3. */
function clean(value: number): number {
  return Number(value.toPrecision(12));
}
