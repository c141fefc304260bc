import { type Paper, type SheetItem, TEXT_SIZES } from '../../core/sheet.ts';
import type { Opening } from '../../core/types.ts';
import { greatestRound } from '../decimals.ts';
import { printable } from '../printable.ts';
import { hatch } from './hatch.ts';
import { type DisplayUnit, METRES_PER_FOOT } from './measure-words.ts';
import { HATCHES } from './secondary-hatch.ts';
import { MARGIN, STRIP } from './sheet-page.ts';
import { shorten, textWidth } from './text-width.ts';

/** A sample in the legend. */
export type LegendEntry = 'wall' | 'inferred' | 'furniture' | Opening['type'] | keyof typeof HATCHES;

export interface TitleFacts {
  readonly title: string;
  /** Small lines under the title, top to bottom. */
  readonly lines: readonly string[];
  readonly legend: readonly LegendEntry[];
  /** Where the arrow points, radians counter-clockwise from up, and what is there. */
  readonly heading: number;
  readonly headingName: string;
  readonly unit: DisplayUnit;
}

/** Width of the title's column at the right, mm. */
const TITLE_WIDTH = 96;
/** The arrow: its column at the right edge, and half its length, mm. */
const ARROW = { column: 14, reach: 4.5, head: 2.6, half: 1 } as const;
const LINE_HEIGHT = 4.2;
/** Between the rows of a long title, mm. */
const ROW_GAP = 0.7;
/** Segments of the scale bar, and what one may be long, mm. */
const SEGMENTS = 4;
const LONGEST_SEGMENT = 20;
const BAR_HEIGHT = 1.6;
/** Length of the wall at either side of the legend's openings, mm. */
const WALL_STUMP = 1.6;
const SWATCH = { width: 8, height: 3.6, column: 40, row: 6 } as const;

const LEGEND: Record<LegendEntry, string> = {
  wall: 'Wall',
  inferred: 'Inferred: no points',
  door: 'Door, hinge unknown',
  window: 'Window',
  passage: 'Passage',
  furniture: 'Furniture',
  subtract: 'Structure, subtracted',
  add: 'Structure, added',
  independent: 'Structure, independent',
};

/** The strip along the lower edge: scale bar and legend at the left, title and facts at the right. */
export function drawTitleBlock(facts: TitleFacts, paper: Paper, scale: number): SheetItem[] {
  const top = paper.height - MARGIN - STRIP + LINE_HEIGHT;
  const rule = Float64Array.of(MARGIN, top, paper.width - MARGIN, top);
  return [
    { kind: 'path', style: 'rule', lines: [rule], isClosed: false },
    ...drawTitle(facts, paper.width - MARGIN - TITLE_WIDTH, top),
    ...drawHeading(facts, paper.width - MARGIN - ARROW.column / 2, top + 3 + ARROW.column / 2),
    ...drawScaleBar(scale, facts.unit, MARGIN, top + 6),
    ...drawLegend(facts.legend, MARGIN, top + 15),
  ];
}

function drawTitle({ title, lines }: TitleFacts, x: number, top: number): SheetItem[] {
  let y = top + 4;
  const items: SheetItem[] = [];
  const { size, rows } = titleRows(title);
  rows.forEach((text, i) => {
    y += TEXT_SIZES[size] + (i > 0 ? ROW_GAP : 0);
    const id = i === 0 ? { id: 'sheet-title' } : {};
    items.push({ kind: 'text', size, x, y, text, anchor: 'start', ...id });
  });
  y += 1.5;
  for (const line of lines) {
    y += LINE_HEIGHT;
    const short = shorten(line, TEXT_SIZES.label, TITLE_WIDTH - ARROW.column);
    items.push({ kind: 'text', size: 'label', x, y, text: short, anchor: 'start' });
  }
  return items;
}

/** A long title takes two smaller rows; what does not fit them is cut. */
export function titleRows(title: string): { size: 'title' | 'room'; rows: readonly string[] } {
  const width = TITLE_WIDTH - ARROW.column;
  const whole = printable(title);
  if (textWidth(whole, TEXT_SIZES.title) <= width) return { size: 'title', rows: [whole] };
  const words = whole.split(' ');
  let first = words.shift() ?? '';
  while (words.length > 0 && textWidth(`${first} ${words[0]}`, TEXT_SIZES.room) <= width)
    first += ` ${words.shift()}`;
  const rows = [first, words.join(' ')].filter((row) => row !== '');
  return { size: 'room', rows: rows.map((row) => shorten(row, TEXT_SIZES.room, width)) };
}

/** The arrow to north, or along the scan's y axis. */
function drawHeading({ heading, headingName }: TitleFacts, x: number, y: number): SheetItem[] {
  const [right, up] = [-Math.sin(heading), Math.cos(heading)];
  const at = (along: number, aside: number) => [
    x + along * right + aside * up,
    y - along * up + aside * right,
  ];
  const { reach, head, half } = ARROW;
  const tip = at(reach, 0);
  const shaft = Float64Array.of(...at(-reach, 0), ...tip);
  const point = Float64Array.of(...tip, ...at(reach - head, half), ...at(reach - head, -half));
  const [labelX, labelY] = at(reach + TEXT_SIZES.label / 2 + 0.8, 0);
  return [
    { kind: 'path', style: 'rule', lines: [shaft], isClosed: false, id: 'heading' },
    { kind: 'path', style: 'scaleBar', lines: [point], isClosed: true },
    {
      kind: 'text',
      size: 'label',
      x: labelX,
      y: labelY + TEXT_SIZES.label / 3,
      text: headingName,
      anchor: 'middle',
    },
  ];
}

function drawScaleBar(scale: number, unit: DisplayUnit, left: number, top: number): SheetItem[] {
  const unitLength = unit === 'm' ? 1 : METRES_PER_FOOT;
  const segment = greatestRound((LONGEST_SEGMENT * scale) / 1000 / unitLength);
  const width = (segment * unitLength * 1000) / scale;
  const box = (i: number) => {
    const [x, y] = [left + i * width, top + BAR_HEIGHT];
    return Float64Array.of(x, top, x + width, top, x + width, y, x, y);
  };
  const outline = Float64Array.of(
    ...[left, top, left + SEGMENTS * width, top],
    ...[left + SEGMENTS * width, top + BAR_HEIGHT, left, top + BAR_HEIGHT],
  );
  const filled = Array.from({ length: SEGMENTS }, (_, i) => i).filter((i) => i % 2 === 0);
  const items: SheetItem[] = [
    { kind: 'path', style: 'scaleBar', lines: filled.map(box), isClosed: true },
    { kind: 'path', style: 'rule', lines: [outline], isClosed: true },
  ];
  for (let i = 0; i <= SEGMENTS; i++) {
    const figure = String(Number((i * segment).toPrecision(3)));
    const text = i === SEGMENTS ? `${figure} ${unit}` : figure;
    const y = top + BAR_HEIGHT + LINE_HEIGHT - 0.8;
    items.push({
      kind: 'text',
      size: 'label',
      x: left + i * width,
      y,
      text,
      anchor: i === 0 ? 'start' : 'middle',
    });
  }
  return items;
}

function drawLegend(entries: readonly LegendEntry[], left: number, top: number): SheetItem[] {
  return entries.flatMap((entry, i) => {
    const x = left + (i % 2) * SWATCH.column;
    const y = top + Math.floor(i / 2) * SWATCH.row;
    const [right, bottom] = [x + SWATCH.width, y + SWATCH.height];
    const box = Float64Array.of(x, y, right, y, right, bottom, x, bottom);
    return [
      ...drawSwatch(entry, box),
      {
        kind: 'text',
        size: 'label',
        x: right + 2,
        y: bottom - 0.9,
        text: LEGEND[entry],
        anchor: 'start',
      } satisfies SheetItem,
    ];
  });
}

function drawSwatch(entry: LegendEntry, box: Float64Array): SheetItem[] {
  const outline = (style: 'scaleBar' | 'inferred' | 'swatch' | 'furniture'): SheetItem => ({
    kind: 'path',
    style,
    lines: [box],
    isClosed: true,
  });
  if (entry === 'wall') return [outline('scaleBar')];
  if (entry === 'inferred' || entry === 'furniture') return [outline(entry)];
  if (entry === 'door' || entry === 'window' || entry === 'passage') return drawOpening(entry, box);
  const lines = HATCHES[entry].flatMap(({ angle, spacing }) => hatch([box], angle, spacing));
  return [{ kind: 'path', style: 'hatch', lines, isClosed: false }, outline('swatch')];
}

/** Two stumps of wall and the lines between them, as in the plan. */
function drawOpening(type: Opening['type'], box: Float64Array): SheetItem[] {
  const [left, top, right, , , bottom] = box;
  const stump = (from: number, to: number) => Float64Array.of(from, top, to, top, to, bottom, from, bottom);
  const [from, to] = [left + WALL_STUMP, right - WALL_STUMP];
  const middle = (top + bottom) / 2;
  const heights = { door: [middle], window: [top, middle, bottom], passage: [top, bottom] }[type];
  return [
    { kind: 'path', style: 'scaleBar', lines: [stump(left, from), stump(to, right)], isClosed: true },
    {
      kind: 'path',
      style: type === 'passage' ? 'passage' : 'opening',
      lines: heights.map((y) => Float64Array.of(from, y, to, y)),
      isClosed: false,
    },
  ];
}
