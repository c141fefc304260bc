import { FloorPlanError } from '../../core/errors.ts';
import { cutOff } from '../cut-off.ts';
import { FIELDS } from '../point-buffer.ts';
import { BLANK, COMMA, isBlankOrEnd, isLineEnd, lineEnd, nextLine, skipBlanks } from './characters.ts';
import { NumberScanner, parseNumber } from './scan-number.ts';

const QUOTE = 34;
const HASH = 35;
const PERCENT = 37;
const SLASH = 47;

/** A column that is not read. */
export const SKIP = -1;
/** A count and that many values. */
export const LIST = -2;

/** Longest piece of a file shown in a message. */
const SHOWN_CHARACTERS = 40;

export interface RowLayout {
  /** A blank: any run of blanks and tabs. */
  readonly separator: number;
  /** For each column up to the last one needed: a field's number, {@link SKIP} or {@link LIST}. */
  readonly targets: Int8Array;
}

/** Where rows stand, for messages. */
export interface RowPlace {
  readonly name: string;
  /** Line of the first row, counted from 1. */
  readonly line: number;
}

/** Reads rows of numbers, one a line; a comma may be the decimal mark wherever it does not separate fields. */
export class RowParser {
  /** Values of the last row by field number; fields without a column stay 0. */
  readonly values = new Float64Array(FIELDS.length);
  /** Line of the next row, counted from 1. */
  line: number;
  readonly #name: string;
  readonly #separator: number;
  readonly #targets: Int8Array;
  readonly #hasComma: boolean;
  readonly #scanner = new NumberScanner();

  constructor({ separator, targets }: RowLayout, { name, line }: RowPlace) {
    this.line = line;
    this.#name = name;
    this.#separator = separator;
    this.#targets = targets;
    this.#hasComma = separator !== COMMA;
  }

  /** Moves past empty lines and comments (#, %, //) to the next row; the end of `bytes` where there is none. */
  seek(bytes: Uint8Array, begin: number): number {
    let at = begin;
    while (at < bytes.length) {
      const start = skipBlanks(bytes, at);
      const byte = bytes[start];
      const isComment = byte === HASH || byte === PERCENT || (byte === SLASH && bytes[start + 1] === SLASH);
      if (!isComment && !isLineEnd(byte)) return at;
      at = this.skipLine(bytes, start);
    }
    return at;
  }

  /** Moves past the end of the line. */
  skipLine(bytes: Uint8Array, begin: number): number {
    this.line++;
    return nextLine(bytes, lineEnd(bytes, begin));
  }

  /**
   * Reads the row at `begin` into {@link values} and returns where the next line begins.
   *
   * @param bytes whole lines
   * @param isCut whether the file ends in this row without an end of line
   * @throws input/malformed, input/truncated
   */
  read(bytes: Uint8Array, begin: number, isCut: boolean): number {
    const targets = this.#targets;
    let at = begin;
    for (let column = 0; column < targets.length; column++) {
      at = skipBlanks(bytes, at, this.#separator);
      // Nothing after a separator is a missing value; nothing at all is a missing column.
      if (
        isLineEnd(bytes[at]) &&
        (at === begin || this.#separator === BLANK || bytes[at - 1] !== this.#separator || isCut)
      ) {
        throw this.#tooShort(column, isCut);
      }
      const target = targets[column];
      if (target >= 0) at = this.#readField(bytes, at, column);
      else if (target === LIST) at = this.#skipList(bytes, at, column);
      else at = this.#fieldEnd(bytes, at);
      if (bytes[at] === this.#separator) at++;
    }
    return this.skipLine(bytes, at);
  }

  #readField(bytes: Uint8Array, begin: number, column: number): number {
    const value = this.#scanner.scan(bytes, begin, this.#hasComma);
    if (value !== undefined) {
      const at = skipBlanks(bytes, this.#scanner.position, this.#separator);
      const isOver =
        this.#separator === BLANK ? isBlankOrEnd(bytes[this.#scanner.position]) : this.#isEnd(bytes[at]);
      if (isOver) {
        this.values[this.#targets[column]] = value;
        return at;
      }
    }
    const end = this.#fieldEnd(bytes, begin);
    this.values[this.#targets[column]] = this.#parse(bytes.subarray(begin, end), column);
    return end;
  }

  #parse(field: Uint8Array, column: number): number {
    const text = new TextDecoder().decode(field);
    const value = parseNumber(text, this.#hasComma);
    if (value !== undefined) return value;
    const shown = text.trim().slice(0, SHOWN_CHARACTERS);
    throw new FloorPlanError(
      'input/malformed',
      `${this.#name}: expected a number in line ${this.line}, column ${column + 1}, found "${shown}"`,
      {
        hint: 'Check that every row has the same columns.',
        detail: { line: this.line, column: column + 1, text: shown },
      },
    );
  }

  #skipList(bytes: Uint8Array, begin: number, column: number): number {
    let at = this.#fieldEnd(bytes, begin);
    const items = this.#parse(bytes.subarray(begin, at), column);
    for (let item = 0; item < items; item++) {
      at = skipBlanks(bytes, at);
      if (isLineEnd(bytes[at])) break;
      at = this.#fieldEnd(bytes, at);
    }
    return at;
  }

  #fieldEnd(bytes: Uint8Array, begin: number): number {
    let at = begin;
    if (bytes[at] === QUOTE) {
      do at++;
      while (bytes[at] !== QUOTE && !isLineEnd(bytes[at]));
    }
    if (this.#separator === BLANK) while (!isBlankOrEnd(bytes[at])) at++;
    else while (!this.#isEnd(bytes[at])) at++;
    return at;
  }

  #isEnd(byte: number): boolean {
    return byte === this.#separator || isLineEnd(byte);
  }

  #tooShort(column: number, isCut: boolean): FloorPlanError {
    const expected = `${this.#targets.length} columns in line ${this.line}`;
    const detail = { line: this.line, column };
    if (isCut) return cutOff(this.#name, expected, `${column}`, detail);
    const message = `${this.#name}: expected ${expected}, found ${column}`;
    return new FloorPlanError('input/malformed', message, {
      hint: 'Check that every row has the same columns.',
      detail,
    });
  }
}
