/**
 * Advances of Helvetica in thousandths of the type size, by WinAnsi code from 32 on; 0 where the code has no letter.
 * Adobe's font metrics, as ISO 32000-1 §9.6.2.2 takes them for granted.
 */
// biome-ignore format: a row each for 16 codes.
const ADVANCES: readonly number[] = [
  278, 278, 355, 556, 556, 889, 667, 191, 333, 333, 389, 584, 278, 333, 278, 278,
  556, 556, 556, 556, 556, 556, 556, 556, 556, 556, 278, 278, 584, 584, 584, 556,
  1015, 667, 667, 722, 722, 667, 611, 778, 722, 278, 500, 667, 556, 833, 722, 778,
  667, 778, 722, 667, 611, 722, 667, 944, 667, 667, 611, 278, 278, 278, 469, 556,
  333, 556, 556, 500, 556, 556, 278, 556, 556, 222, 222, 500, 222, 833, 556, 556,
  556, 556, 333, 500, 278, 556, 500, 722, 500, 500, 500, 334, 260, 334, 584, 0,
  556, 0, 222, 556, 333, 1000, 556, 556, 333, 1000, 667, 333, 1000, 0, 611, 0,
  0, 222, 222, 333, 333, 350, 556, 1000, 333, 1000, 500, 333, 944, 0, 500, 667,
  278, 333, 556, 556, 556, 556, 260, 556, 333, 737, 370, 556, 584, 333, 737, 333,
  400, 584, 333, 333, 333, 556, 537, 278, 333, 333, 365, 556, 834, 834, 834, 611,
  667, 667, 667, 667, 667, 667, 1000, 722, 667, 667, 667, 667, 278, 278, 278, 278,
  722, 722, 778, 778, 778, 778, 778, 584, 778, 722, 722, 722, 722, 667, 667, 611,
  556, 556, 556, 556, 556, 556, 889, 500, 556, 556, 556, 556, 278, 278, 278, 278,
  556, 556, 556, 556, 556, 556, 556, 584, 611, 556, 556, 556, 556, 500, 556, 500,
];
const FIRST = 32;

/** The letters that WinAnsi has between 128 and 159, by Unicode. */
const BETWEEN = '€\0‚ƒ„…†‡ˆ‰Š‹Œ\0Ž\0\0‘’“”•–—˜™š›œ\0žŸ';

/** The WinAnsi codes of a text; null where a letter has none. */
export function winAnsi(text: string): number[] | null {
  const codes: number[] = [];
  for (const letter of text) {
    const point = letter.codePointAt(0)!;
    const between = letter === '\0' ? -1 : BETWEEN.indexOf(letter);
    const code = between >= 0 ? 128 + between : point < 128 || (point >= 160 && point < 256) ? point : 0;
    if (code < FIRST || ADVANCES[code - FIRST] === 0) return null;
    codes.push(code);
  }
  return codes;
}

/** How wide codes are set, in the unit of the size. */
export function advanceOf(codes: readonly number[], size: number): number {
  return (codes.reduce((sum, code) => sum + ADVANCES[code - FIRST], 0) * size) / 1000;
}
