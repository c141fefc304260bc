import { printable } from '../printable.ts';

/** Mean advance of a letter in the usual sans-serif faces, and of a CJK letter, as shares of the text size. */
const LETTER = 0.55;
const WIDE_LETTER = 1;
/** Height of capitals and figures as a share of the text size. */
export const CAPITAL = 0.72;
/** Code points from here on are mostly as wide as high. */
const FIRST_WIDE = 0x2e80;

/** About how wide a text is, in the unit of its size; exact widths are known to the viewer's font only. */
export function textWidth(text: string, size: number): number {
  let width = 0;
  for (const letter of text) width += size * (letter.codePointAt(0)! >= FIRST_WIDE ? WIDE_LETTER : LETTER);
  return width;
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
