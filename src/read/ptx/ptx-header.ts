import type { Pose } from '../pose.ts';
import { parseNumber } from '../text/scan-number.ts';

/** Columns, rows, the scanner's place and axes, and four rows of a matrix. */
export const HEADER_LINES = 10;
/** How many numbers each line holds. */
const WIDTHS = [1, 1, 3, 3, 3, 3, 4, 4, 4, 4];
const COUNT_LINES = 2;
const COUNT = 'a whole number of columns or rows';
const MATRIX_LINE = 6;
/** Last column of a matrix that rotates, scales and moves rows of x, y, z, 1. */
const LAST_COLUMN = [0, 0, 0, 1];

export interface PtxHeader {
  /** Rows of the scan, those without a return included. */
  readonly count: number;
  readonly pose: Pose;
}

/** What the first wrong line should have been. */
export class PtxFault {
  /** Counted from 0. */
  readonly line: number;
  readonly expected: string;

  constructor(line: number, expected: string) {
    this.line = line;
    this.expected = expected;
  }
}

/** The numbers of a header, line by line, where each line has as many as it should. @param lines at least ten */
export function headerNumbers(lines: readonly string[]): number[][] | PtxFault {
  const numbers: number[][] = [];
  for (const [line, width] of WIDTHS.entries()) {
    const words = lines[line].trim().split(/\s+/);
    const values = words.map((word) => parseNumber(word, true) ?? Number.NaN);
    if (values.length !== width || !values.every(Number.isFinite)) {
      return new PtxFault(line, line < COUNT_LINES ? COUNT : `${width} numbers`);
    }
    numbers.push(values);
  }
  return numbers;
}

/**
 * Reads the header of one scan.
 *
 * The matrix places the points; its last row is where the scanner stood. The lines before it tell the scanner's place
 * before a change of coordinates at export, and are not used.
 *
 * @param lines at least ten
 */
export function parsePtxHeader(lines: readonly string[]): PtxHeader | PtxFault {
  const numbers = headerNumbers(lines);
  if (numbers instanceof PtxFault) return numbers;
  const [[columns], [rows]] = numbers;
  const wrong = [columns, rows].findIndex((value) => !Number.isInteger(value) || value < 0);
  if (wrong >= 0) return new PtxFault(wrong, COUNT);
  const matrix = numbers.slice(MATRIX_LINE);
  const bent = matrix.findIndex((row, index) => row[3] !== LAST_COLUMN[index]);
  if (bent >= 0)
    return new PtxFault(MATRIX_LINE + bent, `a row of a matrix that ends in ${LAST_COLUMN[bent]}`);
  const [x, y, z] = matrix[3];
  const rotation = [0, 1, 2].flatMap((column) => matrix.slice(0, 3).map((row) => row[column]));
  return { count: columns * rows, pose: { rotation, translation: [x, y, z] } };
}
