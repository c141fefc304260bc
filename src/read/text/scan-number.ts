import { latin1 } from '../signatures.ts';

const ZERO = 48;
const DOT = 46;
const COMMA = 44;
const PLUS = 43;
const MINUS = 45;
const SMALL_E = 101;
const CASE_BIT = 32;

/** Below this every integer is a float64. */
const MAX_EXACT = 2 ** 53;
/** Powers of ten that are exact in float64. */
const POWERS = Float64Array.from({ length: 23 }, (_, power) => Number(`1e${power}`));
/** Past this an exponent's digits no longer matter; stops them from overflowing. */
const MAX_EXPONENT = 100_000;

/**
 * Reads decimal numbers from bytes, correctly rounded.
 *
 * Digits become an integer below 2⁵³ that is multiplied or divided once by an exact power of ten, so there is one
 * rounding [Clinger90] §3. Longer numbers go through `Number()`, several times slower.
 */
export class NumberScanner {
  /** Where the last number ended. */
  position = 0;

  /**
   * The number at `begin`, or undefined where there is none.
   *
   * @param hasComma whether a comma may stand for the decimal point
   */
  scan(bytes: Uint8Array, begin: number, hasComma: boolean): number | undefined {
    let at = begin;
    const sign = bytes[at];
    if (sign === MINUS || sign === PLUS) at++;
    let mantissa = 0;
    const first = at;
    let digit = bytes[at] - ZERO;
    while (digit >= 0 && digit <= 9) {
      mantissa = mantissa * 10 + digit;
      digit = bytes[++at] - ZERO;
    }
    let digits = at - first;
    let power = 0;
    const mark = bytes[at];
    if (mark === DOT || (hasComma && mark === COMMA)) {
      const decimals = ++at;
      digit = bytes[at] - ZERO;
      while (digit >= 0 && digit <= 9) {
        mantissa = mantissa * 10 + digit;
        digit = bytes[++at] - ZERO;
      }
      power = decimals - at;
      digits -= power;
    }
    this.position = at;
    if ((bytes[at] | CASE_BIT) === SMALL_E) power += this.#exponent(bytes, at + 1);
    if (digits === 0) return undefined;
    if (mantissa >= MAX_EXACT || power > 22 || power < -22) return spelledNumber(bytes, begin, this.position);
    const size = power < 0 ? mantissa / POWERS[-power] : mantissa * POWERS[power];
    return sign === MINUS ? -size : size;
  }

  /** Moves past an exponent; without digits it is none, and the e stays as text. */
  #exponent(bytes: Uint8Array, begin: number): number {
    let at = begin;
    const sign = bytes[at];
    if (sign === MINUS || sign === PLUS) at++;
    const first = at;
    let exponent = 0;
    let digit = bytes[at] - ZERO;
    while (digit >= 0 && digit <= 9) {
      if (exponent < MAX_EXPONENT) exponent = exponent * 10 + digit;
      digit = bytes[++at] - ZERO;
    }
    if (at === first) return 0;
    this.position = at;
    return sign === MINUS ? -exponent : exponent;
  }
}

function spelledNumber(bytes: Uint8Array, begin: number, end: number): number {
  return Number(latin1(bytes.subarray(begin, end)).replace(',', '.'));
}

const NUMBER = /^[+-]?(\d+([.,]\d*)?|[.,]\d+)(e[+-]?\d+)?$/i;
/** Spellings of C, Python, Matlab, spreadsheets and Microsoft's C library; an empty field is a missing value. */
const NOT_FINITE = /^([+-]?(nan(\(\w*\))?|inf(inity)?|1[.,]#\w+)|null|none|n\/?a|)$/i;

/**
 * The number a whole field spells: quotes and blanks around it are dropped, NaN stands for every spelling of a number
 * that is not finite or is missing, undefined for any other text.
 *
 * @param hasComma whether a comma may stand for the decimal point; in quotes it always may, for it separates nothing there
 */
export function parseNumber(field: string, hasComma: boolean): number | undefined {
  const text = unquote(field);
  const mayComma = hasComma || /^\s*["']/.test(field);
  if (NUMBER.test(text) && (mayComma || !text.includes(','))) return Number(text.replace(',', '.'));
  return NOT_FINITE.test(text) ? Number.NaN : undefined;
}

/** The text of a field without blanks and quotes around it. */
function unquote(field: string): string {
  const text = field.trim();
  const quoted = /^(["'])(.*)\1$/s.exec(text);
  return quoted ? quoted[2].trim() : text;
}
