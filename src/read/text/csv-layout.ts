import { columnsOfFields } from '../field-names.ts';
import { BLUE, INTENSITY, RED, Z } from '../point-buffer.ts';
import { BLANK, COMMA, TAB } from './characters.ts';
import { splitLines } from './line-blocks.ts';
import { type RowLayout, SKIP } from './row-parser.ts';
import { parseNumber } from './scan-number.ts';

const SEMICOLON = 59;
/** Tried in this order; the first of the best wins. */
const SEPARATORS = [SEMICOLON, TAB, COMMA, BLANK];
/** Rows looked at to tell separator and columns; later rows must keep to them. */
const SAMPLE_ROWS = 50;

/** What a table of points looks like and where its rows begin. */
export interface CsvLayout extends RowLayout {
  /** Byte offset of the first row of numbers. */
  readonly begin: number;
  /** Its number, counted from 1. */
  readonly line: number;
  /** Two coordinates a point. */
  readonly isSlice: boolean;
  /** Most rows have numbers for coordinates: a table of points, whatever its name. */
  readonly isSure: boolean;
}

interface Line {
  readonly text: string;
  readonly begin: number;
  readonly number: number;
}

/**
 * Finds separator, header and columns from the first bytes of a file; null where they hold no two columns of numbers.
 *
 * The separator is the one that makes the most numbers. A header may take several lines: a title, names, units, the
 * number of points. Columns are found by name where one of them, or a comment in their place, names two coordinates,
 * else by position. Two columns are a slice, whatever their names.
 */
export function layOutCsv(head: Uint8Array): CsvLayout | null {
  const { lines, comment } = linesOf(head);
  const sample = lines.slice(lines.length > 1 ? 1 : 0);
  const separator = bestSeparator(sample);
  if (separator === null) return null;
  const table = lines.map(({ text }) => splitRow(text, separator));
  const width = usualWidth(table);
  const headerLines = lines.length > 1 ? table.findIndex((row) => !isHeader(row)) : 0;
  const rows = table.slice(headerLines);
  const names = [comment.split(/[\s,;]+/), ...table.slice(0, headerLines)];
  const targets =
    firstFound(names, (header) => columnsByName(header, width)) ?? columnsByPosition(rows, width);
  const used = targets.map((field, column) => (field > Z && !isNumeric(rows, column) ? SKIP : field));
  const start = lines[headerLines];
  const good = rows.filter((row) => used.every((field, column) => field < 0 || isNumber(row[column])));
  return {
    separator,
    targets: Int8Array.from(used.slice(0, used.findLastIndex((field) => field !== SKIP) + 1)),
    begin: start.begin,
    line: start.number,
    isSlice: !used.includes(Z),
    isSure: 2 * good.length >= sample.length,
  };
}

/** Lines that are neither empty nor comments, and the last comment before the first of them. */
function linesOf(head: Uint8Array): { lines: Line[]; comment: string } {
  const decoder = new TextDecoder();
  const lines: Line[] = [];
  let comment = '';
  let number = 0;
  for (const [begin, end] of splitLines(head)) {
    number++;
    const text = decoder.decode(head.subarray(begin, end)).trim();
    const isComment = /^(#|%|\/\/)/.test(text);
    if (isComment && lines.length === 0) comment = text.replace(/^[#%/]+\s*/, '');
    if (!isComment && text !== '') lines.push({ text, begin, number });
    if (lines.length > SAMPLE_ROWS) break;
  }
  return { lines, comment };
}

function bestSeparator(sample: readonly Line[]): number | null {
  let best: number | null = null;
  let most = 0;
  for (const separator of SEPARATORS) {
    let numbers = 0;
    for (const { text } of sample) {
      const found = splitRow(text, separator).filter((field) => isNumber(field, separator !== COMMA)).length;
      if (found >= 2) numbers += found;
    }
    if (numbers > most) {
      most = numbers;
      best = separator;
    }
  }
  return best;
}

function splitRow(text: string, separator: number): string[] {
  if (separator === BLANK) return text.trim().split(/[ \t]+/);
  const mark = String.fromCharCode(separator);
  // Each match is a mark and the field after it, quoted or not; one mark is put before the first.
  const pattern = new RegExp(`${mark}( *"[^"]*"[^${mark}]*|[^${mark}]*)`, 'g');
  return Array.from(`${mark}${text}`.matchAll(pattern), (match) => match[1]);
}

/** The number of fields that most rows have; of two, the larger. */
function usualWidth(rows: readonly string[][]): number {
  const votes: number[] = [];
  for (const { length } of rows) votes[length] = (votes[length] ?? 0) + 1;
  return votes.reduce((best, count, width) => (count >= (votes[best] ?? 0) ? width : best), 0);
}

function firstFound<T, R>(values: readonly T[], find: (value: T) => R | null): R | null {
  for (const value of values) {
    const found = find(value);
    if (found !== null) return found;
  }
  return null;
}

/** Text, names of coordinates, or the lone number of points that some tables begin with. */
function isHeader(fields: readonly string[]): boolean {
  const numbers = fields.filter((field) => isNumber(field)).length;
  return numbers < 2 && !(numbers === 1 && fields.length > 2);
}

function isNumber(field: string | undefined, hasComma = true): boolean {
  return field !== undefined && field.trim() !== '' && parseNumber(field, hasComma) !== undefined;
}

function isNumeric(rows: readonly string[][], column: number): boolean {
  return rows.every((row) => isNumber(row[column]));
}

/** Field of each column, or null where fewer than two coordinates are named. */
function columnsByName(names: readonly string[], width: number): number[] | null {
  if (width === 2 || names.length > width) return null;
  const targets = new Array<number>(width).fill(SKIP);
  columnsOfFields(names).forEach((column, field) => {
    if (column >= 0) targets[column] = field;
  });
  const coordinates = targets.filter((field) => field >= 0 && field <= Z);
  if (coordinates.length < 2) return null;
  if (coordinates.length === 3) return targets;
  let next = 0;
  return targets.map((field) => (field >= 0 && field <= Z ? next++ : field));
}

/** [row number,] x y [z], then the usual orders: r g b [i], i r g b, or i alone. */
function columnsByPosition(rows: readonly string[][], usual: number): number[] {
  if (hasRowNumbers(rows)) {
    const others = rows.map((row) => row.slice(1));
    return [SKIP, ...columnsByPosition(others, usual - 1)];
  }
  const width = filledWidth(rows, usual);
  const isColour = (column: number) =>
    [0, 1, 2].every((channel) => rows.every((row) => isByte(row[column + channel])));
  const targets = new Array<number>(width).fill(SKIP);
  for (let column = 0; column < Math.min(width, 3); column++) targets[column] = column;
  const colourAt = [3, 4].find(isColour);
  if (colourAt !== undefined)
    for (let field = RED; field <= BLUE; field++) targets[colourAt + field - RED] = field;
  const intensityAt = colourAt === 3 ? 6 : 3;
  const isIntensity = width === 4 || colourAt !== undefined;
  if (isIntensity && intensityAt < width) targets[intensityAt] = INTENSITY;
  return targets;
}

/** A first column that counts up by one, before three that do not hold whole numbers: coordinates on a grid would. */
function hasRowNumbers(rows: readonly string[][]): boolean {
  const first = Number(rows[0][0]);
  const isWhole = (field: string | undefined) => /^\s*[+-]?\d+\s*$/.test(field ?? '');
  return (
    rows.length > 2 &&
    rows.every((row, index) => isWhole(row[0]) && Number(row[0]) === first + index) &&
    [1, 2, 3].every((column) => isNumeric(rows, column) && !rows.every((row) => isWhole(row[column])))
  );
}

/** Columns without the empty ones that separators after the last number make. */
function filledWidth(rows: readonly string[][], width: number): number {
  const isEmpty = (column: number) => rows.every((row) => (row[column] ?? '').trim() === '');
  let filled = width;
  while (filled > 2 && isEmpty(filled - 1)) filled--;
  return filled;
}

function isByte(field: string | undefined): boolean {
  return field !== undefined && /^\s*\d{1,3}\s*$/.test(field) && Number(field) <= 255;
}
