import { BLUE, INTENSITY, RED, X, Z } from '../point-buffer.ts';
import { BLANK } from '../text/characters.ts';
import { splitLines, wholeLines } from '../text/line-blocks.ts';
import type { RowLayout } from '../text/row-parser.ts';
import { parseNumber } from '../text/scan-number.ts';

/** Rows looked at to tell the columns; later rows must keep to them. */
const SAMPLE_ROWS = 50;
const PLACE = [X, X + 1, Z];
const COLOURS = [RED, RED + 1, BLUE];

/** The columns of a PTS file, whose first line is a lone number of points; null where the head is no such file. */
export function layOutPts(head: Uint8Array): RowLayout | null {
  const decoder = new TextDecoder();
  const rows: string[][] = [];
  let isFirst = true;
  for (const [begin, end] of splitLines(wholeLines(head))) {
    const text = decoder.decode(head.subarray(begin, end)).trim();
    if (text === '') continue;
    const isCount = /^\d+$/.test(text);
    if (isFirst && !isCount) return null;
    if (!isCount && rows.push(text.split(/[ \t]+/)) === SAMPLE_ROWS) break;
    isFirst = false;
  }
  const targets = rows.length > 0 ? targetsOf(rows) : null;
  return targets && { separator: BLANK, targets: Int8Array.from(targets) };
}

function targetsOf(rows: readonly string[][]): number[] | null {
  const width = rows[0].length;
  const isTable = rows.every(
    (row) => row.length === width && row.every((field) => parseNumber(field, true) !== undefined),
  );
  if (!isTable) return null;
  if (width === 3) return PLACE;
  if (width === 4) return [...PLACE, INTENSITY];
  if (width === 6) return [...PLACE, ...COLOURS];
  if (width !== 7) return null;
  // Some programs write the intensity last.
  const isLast = hasBytes(rows, 3) && !hasBytes(rows, 4);
  return isLast ? [...PLACE, ...COLOURS, INTENSITY] : [...PLACE, INTENSITY, ...COLOURS];
}

/** Whether three columns from `first` on hold nothing but 0 … 255. */
function hasBytes(rows: readonly string[][], first: number): boolean {
  return rows.every((row) =>
    row.slice(first, first + 3).every((field) => /^\d{1,3}$/.test(field) && +field <= 255),
  );
}
