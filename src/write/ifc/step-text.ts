import { cutText } from '../../core/cut-text.ts';

/** What a STEP file holds as a value, ready to be written: `'text'`, `1.5`, `#7`, `(#7,#8)`. */
export type StepValue = string;

export const OMITTED: StepValue = '$';
export const DERIVED: StepValue = '*';
export const TRUE: StepValue = '.T.';
export const FALSE: StepValue = '.F.';

/** IfcLabel and IfcIdentifier hold no more characters. */
const LONGEST_LABEL = 255;

/** What stands for itself: printable ASCII but the quote and the backslash, which are doubled. */
const PLAIN = /^[ -&(-[\]-~]*$/;
const CONTROL = /\p{Cc}/u;
const LONE_SURROGATE = /\p{Cs}/u;

/**
 * Text as ISO 10303-21 §6.4.3 writes it: other than ASCII as `\X2\…\X0\`, beyond the basic plane as `\X4\…\X0\`. Control
 * characters become spaces, halves of surrogate pairs U+FFFD: no reader has a use for them, and some choke.
 */
export function text(value: string): StepValue {
  if (PLAIN.test(value)) return `'${value}'`;
  let written = '';
  let wide: '' | 'X2' | 'X4' = '';
  for (const character of value) {
    const safe = CONTROL.test(character) ? ' ' : LONE_SURROGATE.test(character) ? '\ufffd' : character;
    const code = safe.codePointAt(0)!;
    const width = code < 0x7f ? '' : code < 0x10000 ? 'X2' : 'X4';
    if (width !== wide && wide !== '') written += '\\X0\\';
    if (width !== wide && width !== '') written += `\\${width}\\`;
    wide = width;
    if (width === '') written += safe === "'" || safe === '\\' ? safe + safe : safe;
    else
      written += code
        .toString(16)
        .toUpperCase()
        .padStart(width === 'X2' ? 4 : 8, '0');
  }
  return `'${written}${wide === '' ? '' : '\\X0\\'}'`;
}

/** Text as an IfcLabel can hold it: cut where it is longer. */
export function label(value: string): StepValue {
  return text(cutText(value, LONGEST_LABEL));
}

/** Text in full where {@link label} had to cut it, else omitted: for the description beside a name. */
export function cutLabel(value: string): StepValue {
  return cutText(value, LONGEST_LABEL) === value ? OMITTED : text(value);
}

/** A real number with all its digits; a STEP real has a point even where nothing follows it. */
export function real(value: number): StepValue {
  const [mantissa, exponent] = String(value === 0 ? 0 : value).split('e');
  const pointed = mantissa.includes('.') ? mantissa : `${mantissa}.`;
  return exponent === undefined ? pointed : `${pointed}E${exponent}`;
}

/** A real number rounded to so many decimals. */
export const fixed = (value: number, digits: number): StepValue => real(Number(value.toFixed(digits)));

export const list = (values: readonly StepValue[]): StepValue => `(${values.join(',')})`;
