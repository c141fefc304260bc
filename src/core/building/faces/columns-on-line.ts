import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import { standsHigh } from '../columns/wall-columns.ts';
import { asideOf, type Face, pointOn } from './face.ts';
import { reachOf } from './fit-line.ts';
import type { FreeColumns } from './free-columns.ts';

/** Columns whose points lie on average so near a line, m, lie on it. */
export const ON_LINE = 0.015;

/** The column at a place along a face and `across` off it, m, if more than furniture or a beam is in it; else −1. */
export function highColumnAt(columns: HeightColumns, face: Face, along: number, across: number): number {
  const c = columnAt(columns, ...pointOn(face, along, across));
  return c >= 0 && standsHigh(columns, c) ? c : -1;
}

/** The columns at a place along a face that lie on its line, within `onLine` m, and that no face has taken. */
export function freeOnLine(
  { columns, isFree }: FreeColumns,
  face: Face,
  along: number,
  onLine: number,
): number[] {
  const { centres } = columns;
  const found = [-onLine, 0, onLine].map((across) => highColumnAt(columns, face, along, across));
  return [...new Set(found)].filter(
    (c) => c >= 0 && isFree[c] === 1 && Math.abs(asideOf(face, centres[2 * c], centres[2 * c + 1])) <= onLine,
  );
}

/** A face with more columns on its line, which it takes. */
export function withMembers({ columns, isFree }: FreeColumns, face: Face, more: readonly number[]): Face {
  if (more.length === 0) return face;
  for (const c of more) isFree[c] = 0;
  const members = [...face.members, ...more];
  return { ...face, members, ...reachOf(columns, members, face) };
}
