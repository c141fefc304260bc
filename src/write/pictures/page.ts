import { greatestRound } from '../decimals.ts';
import { shorten, textWidth } from '../sheet/text-width.ts';
import { escapeXml } from '../xml.ts';
import { element, path, pixels, text } from './marks.ts';
import { INK, MUTED, PAPER } from './palette.ts';

/** All pictures are as wide, so that their texts are equally large side by side, px. */
const WIDTH = 640;
export const MARGIN = 24;
export const CONTENT_WIDTH = WIDTH - 2 * MARGIN;
const TEXT_SIZE = 12;
/** Height of the legend's first line, of its next ones, of the caption and of its lines, px. */
const LEGEND_HEIGHT = 24;
const LEGEND_LINE = 18;
const CAPTION_HEIGHT = 62;
const CAPTION_LINE = 17;
/** Space for a legend's swatch, px. */
const SWATCH = 13;
/** Longest scale bar, and half the height of its ends, px. */
const LONGEST_BAR = 110;
const BAR_END = 3.5;

/** A colour and what it means. */
export interface LegendEntry {
  readonly colour: string;
  readonly label: string;
}

/** What a picture shows, before it gets its page. */
export interface Drawing {
  /** Of the page above legend and caption, px. */
  readonly height: number;
  /** SVG elements, bottom to top. */
  readonly items: readonly string[];
  /** Figures for the caption: "1,799 points". */
  readonly counts: readonly string[];
  /** For the scale bar; absent where one scale does not hold all over. */
  readonly pixelsPerMetre?: number;
  readonly legend?: readonly LegendEntry[];
}

export interface PageWords {
  /** Unique among the pictures of a run. */
  readonly name: string;
  readonly label: string;
  readonly doc: string;
}

/** A drawing on its page: paper, legend, caption, scale bar. Standalone SVG without styles, scripts or links. */
export function pageOf(drawing: Drawing, { name, label, doc }: PageWords): string {
  const { items, counts, legend = [], pixelsPerMetre } = drawing;
  const key = legendBlock(legend, drawing.height);
  const height = Math.ceil(drawing.height + key.height + CAPTION_HEIGHT);
  const base = height - CAPTION_LINE - 16;
  const content = [
    `<title>${escapeXml(label)}</title>`,
    `<desc>${escapeXml([doc, counts.join(', ')].filter((words) => words !== '').join(' '))}</desc>`,
    element('rect', { id: 'paper', width: WIDTH, height, fill: PAPER }),
    element('g', { id: name }, items),
    ...key.marks,
    caption(label, counts.join(' · '), base),
    ...(pixelsPerMetre === undefined ? [] : [scaleBar(pixelsPerMetre, base)]),
  ];
  const root = {
    xmlns: 'http://www.w3.org/2000/svg',
    width: WIDTH,
    height,
    viewBox: `0 0 ${WIDTH} ${height}`,
    'font-family': 'Helvetica Neue, Helvetica, Arial, sans-serif',
    'data-picture': name,
    'data-pixels-per-metre': pixelsPerMetre === undefined ? undefined : pixelsPerMetre.toFixed(4),
  };
  return `<?xml version="1.0" encoding="UTF-8"?>\n${element('svg', root, ['', ...content, ''])}\n`;
}

/** The picture's name beside the scale bar, its figures on the line beneath. */
function caption(label: string, counts: string, y: number): string {
  const words = shorten(counts, TEXT_SIZE, CONTENT_WIDTH);
  const title = element('tspan', { 'font-weight': 600 }, escapeXml(label));
  const figures = element('tspan', { x: MARGIN, dy: CAPTION_LINE, fill: MUTED }, escapeXml(words));
  const place = { x: MARGIN, y: pixels(y), 'font-size': TEXT_SIZE, fill: INK };
  return element('text', { id: 'caption', ...place }, words === '' ? title : title + figures);
}

/** Entries side by side, on as many lines as they need. @param top of the first line, px */
function legendBlock(
  legend: readonly LegendEntry[],
  top: number,
): { readonly marks: readonly string[]; readonly height: number } {
  const marks: string[] = [];
  let [x, y] = [MARGIN, top + LEGEND_HEIGHT - 4];
  for (const { colour, label } of legend) {
    const width = SWATCH + textWidth(label, TEXT_SIZE);
    if (x > MARGIN && x + width > MARGIN + CONTENT_WIDTH) [x, y] = [MARGIN, y + LEGEND_LINE];
    marks.push(element('circle', { cx: pixels(x + 4), cy: pixels(y - 4), r: 4, fill: colour }));
    marks.push(text(label, x + SWATCH, y, { size: TEXT_SIZE }));
    x += width + 18;
  }
  return { marks, height: legend.length === 0 ? 0 : y - top + 4 };
}

function scaleBar(pixelsPerMetre: number, base: number): string {
  const metres = greatestRound(LONGEST_BAR / pixelsPerMetre);
  const length = metres * pixelsPerMetre;
  const label = lengthWords(metres);
  const [right, y] = [WIDTH - MARGIN, base - 4];
  const left = right - length;
  const line = path(
    [
      Float64Array.of(left, y - BAR_END, left, y + BAR_END),
      Float64Array.of(left, y, right, y),
      Float64Array.of(right, y - BAR_END, right, y + BAR_END),
    ],
    false,
    { fill: 'none', stroke: INK, 'stroke-width': 1 },
  );
  const words = text(label, left - 8, base, { size: TEXT_SIZE, anchor: 'end' });
  return element('g', { id: 'scale-bar' }, [line, words]);
}

/** A length to three digits, in the unit that reads best. */
export function lengthWords(metres: number): string {
  if (!Number.isFinite(metres)) return '∞';
  const [value, unit] =
    metres >= 1 ? [metres, 'm'] : metres >= 0.1 ? [100 * metres, 'cm'] : [1000 * metres, 'mm'];
  return `${Number(value.toPrecision(3))} ${unit}`;
}
