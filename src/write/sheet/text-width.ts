import { advanceOf, winAnsi } from '../helvetica.ts';
import { printable } from '../printable.ts';

/** Mean advances as shares of the text size: of letters beyond Helvetica's, of capitals and of CJK letters among them. */
const LETTER = 0.56;
const LARGE_LETTER = 0.72;
const WIDE_LETTER = 1;
/** Marks over and under letters, joiners and other signs that nothing is drawn for. */
const WITHOUT_WIDTH = /^[\p{M}\p{Cf}]$/u;
const CAPITAL_LETTER = /^\p{Lu}$/u;
/** Height of capitals and figures as a share of the text size. */
export const CAPITAL = 0.72;
/** Code points from here on are mostly as wide as high. */
const FIRST_WIDE = 0x2e80;

/** About how wide a text is, in the unit of its size: as in Helvetica; exact widths are known to the viewer's font only. */
export function textWidth(text: string, size: number): number {
  let width = 0;
  for (const letter of text) width += letterWidth(letter);
  return size * width;
}

function letterWidth(letter: string): number {
  const codes = winAnsi(letter);
  if (codes !== null) return advanceOf(codes, 1);
  if (WITHOUT_WIDTH.test(letter)) return 0;
  if (letter.codePointAt(0)! >= FIRST_WIDE) return WIDE_LETTER;
  return CAPITAL_LETTER.test(letter) ? LARGE_LETTER : LETTER;
}

/** The same for text of which the height of its capitals is known, as in CAD. */
export function widthByCapitals(text: string, height: number): number {
  return textWidth(text, height / CAPITAL);
}

/** The text on one line, or as much of it as fits and an ellipsis. */
export function shorten(text: string, size: number, width: number): string {
  const line = printable(text);
  if (textWidth(line, size) <= width) return line;
  let [kept, taken] = ['', textWidth('…', size)];
  for (const letter of line) {
    taken += textWidth(letter, size);
    if (taken > width) break;
    kept += letter;
  }
  return `${kept.trimEnd()}…`;
}
