import { type Paper, type SheetText, TEXT_SIZES } from '../../core/sheet.ts';
import { MARGIN, STRIP } from './sheet-page.ts';
import { textWidth } from './text-width.ts';

/** From one line to the next, and blank over the first, mm. */
const LINE_HEIGHT = 4.2;
const ABOVE = 2;
/** Blank between columns, and between a number and its words, mm. */
const GAP = 6;
const AFTER_NUMBER = 1.5;

/** A room too small for its name: its number stands in it, and what it is stands below the plan. */
export interface KeyEntry {
  readonly number: string;
  readonly words: string;
}

/** Height of the band that a key takes above the title's strip, mm. */
export function keyHeight(entries: readonly KeyEntry[], paper: Paper): number {
  return entries.length === 0 ? 0 : ABOVE + gridOf(entries, paper).rows * LINE_HEIGHT;
}

/** The key in columns above the title's strip, numbers first. */
export function drawKey(entries: readonly KeyEntry[], paper: Paper): SheetText[] {
  const { rows, columnWidth, numberWidth } = gridOf(entries, paper);
  const bottom = paper.height - MARGIN - STRIP;
  return entries.flatMap(({ number, words }, i) => {
    const x = MARGIN + Math.floor(i / rows) * columnWidth;
    const y = bottom - (rows - 1 - (i % rows)) * LINE_HEIGHT;
    return [
      { kind: 'text', size: 'label', x: x + numberWidth, y, text: number, anchor: 'end' },
      { kind: 'text', size: 'label', x: x + numberWidth + AFTER_NUMBER, y, text: words, anchor: 'start' },
    ] satisfies SheetText[];
  });
}

function gridOf(entries: readonly KeyEntry[], { width }: Paper) {
  const widest = (texts: readonly string[]) =>
    texts.reduce((most, text) => Math.max(most, textWidth(text, TEXT_SIZES.label)), 0);
  const numberWidth = widest(entries.map(({ number }) => number));
  const columnWidth = numberWidth + AFTER_NUMBER + widest(entries.map(({ words }) => words)) + GAP;
  const columns = Math.max(1, Math.floor((width - 2 * MARGIN + GAP) / columnWidth));
  return { rows: Math.ceil(entries.length / columns), columnWidth, numberWidth };
}
