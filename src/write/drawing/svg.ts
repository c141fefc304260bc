import {
  LINE_STYLES,
  type LineStyle,
  SHEET_DIGITS,
  type Sheet,
  type SheetItem,
  type SheetLayer,
  type SheetPath,
  type SheetText,
  TEXT_SIZES,
} from '../../core/sheet.ts';
import type { FloorPlan, RingArc } from '../../core/types.ts';
import { arcStrokes } from '../arc-strokes.ts';
import { decimal } from '../decimals.ts';
import type { Product } from '../plan-writer.ts';
import { attributes, escapeXml } from '../xml.ts';
import { frameFacts } from './frame-json.ts';
import { SHEET_FONT } from './raster.ts';
import { INK, PAPER, POINT_INK, POINT_SIZE } from './sheet-ink.ts';

/**
 * Writes plan.svg: a sheet in millimetres with named layers, whose root and metadata say how to get from a place on
 * the sheet back to the scan. No styles and no scripts, so it shows under any content policy; ink is `currentColor`.
 */
export function writeSvg({ plan, sheet }: Product, storey: number): string {
  return sheetToSvg(sheet[storey], plan);
}

/** A sheet as SVG, with the georeference of its plan. */
export function sheetToSvg(sheet: Sheet, plan: FloorPlan): string {
  const frame = JSON.stringify(frameFacts(plan, sheet));
  const { width, height } = sheet.paper;
  const root = attributes({
    xmlns: 'http://www.w3.org/2000/svg',
    width: `${width}mm`,
    height: `${height}mm`,
    viewBox: `0 0 ${width} ${height}`,
    color: INK,
    'font-family': SHEET_FONT,
    'data-plan-to-sheet': sheet.planToSheet.join(' '),
    'data-scale': sheet.scale,
    'data-storey': sheet.storey,
  });
  const lines = [
    '<?xml version="1.0" encoding="UTF-8"?>',
    `<svg${root}>`,
    `<title>${escapeXml(sheet.title)}</title>`,
    `<desc>${escapeXml(sheet.description)}</desc>`,
    `<metadata id="frame">${escapeXml(frame)}</metadata>`,
    `<rect${attributes({ id: 'paper', width, height, fill: PAPER })}/>`,
    ...sheet.layers.flatMap(layerLines),
    '</svg>',
  ];
  return `${lines.join('\n')}\n`;
}

function layerLines({ name, isVisible, items }: SheetLayer): string[] {
  const group = attributes({ id: name, 'data-layer': name, display: isVisible ? undefined : 'none' });
  return [`<g${group}>`, ...items.map(itemLine), '</g>'];
}

function itemLine(item: SheetItem): string {
  if (item.kind === 'text') return textLine(item);
  if (item.kind === 'path') return pathLine(item);
  const dots: string[] = [];
  for (let i = 0; i < item.xy.length; i += 2) dots.push(`M${mm(item.xy[i])} ${mm(item.xy[i + 1])}h0`);
  const look = {
    'stroke-width': POINT_SIZE,
    'stroke-linecap': 'round',
    stroke: 'currentColor',
    'stroke-opacity': POINT_INK,
  };
  return `<path${attributes({ d: dots.join(''), fill: 'none', ...look })}/>`;
}

function pathLine({ style, lines, arcs = [], isClosed, id, data = {} }: SheetPath): string {
  const look: LineStyle = LINE_STYLES[style];
  const facts = Object.fromEntries(Object.entries(data).map(([key, value]) => [`data-${key}`, value]));
  return `<path${attributes({
    id,
    ...facts,
    d: lines
      .map((line, k) =>
        pathData(
          line,
          arcs.filter(({ ring }) => ring === k),
          isClosed,
        ),
      )
      .join(''),
    fill: look.isFilled ? 'currentColor' : 'none',
    'fill-rule': look.isFilled ? 'evenodd' : undefined,
    stroke: 'currentColor',
    'stroke-width': look.width,
    'stroke-opacity': look.ink,
    'stroke-dasharray': look.dash?.join(' '),
    'stroke-linejoin': isClosed ? 'miter' : undefined,
  })}/>`;
}

function textLine({ size, x, y, text, anchor, isUpright, id }: SheetText): string {
  return `<text${attributes({
    id,
    x: mm(x),
    y: mm(y),
    'font-size': TEXT_SIZES[size],
    'text-anchor': anchor === 'start' ? undefined : anchor,
    transform: isUpright ? `rotate(-90 ${mm(x)} ${mm(y)})` : undefined,
    fill: 'currentColor',
  })}>${escapeXml(text)}</text>`;
}

function pathData(line: Float64Array, arcs: readonly RingArc[], isClosed: boolean): string {
  if (arcs.length > 0) return roundPathData(line, arcs);
  let d = '';
  for (let i = 0; i < line.length; i += 2) d += `${i === 0 ? 'M' : 'L'}${mm(line[i])} ${mm(line[i + 1])}`;
  return isClosed ? `${d}Z` : d;
}

/** A closed line with its arcs as arcs: radii, no turn of the ellipse, the shorter way, clockwise or not. */
function roundPathData(line: Float64Array, arcs: readonly RingArc[]): string {
  const strokes = arcStrokes(line, arcs);
  const ways = strokes.map(({ turn, radius }, i) => {
    const { x, y } = strokes[(i + 1) % strokes.length];
    const to = `${mm(x)} ${mm(y)}`;
    return turn === 0 ? `L${to}` : `A${mm(radius)} ${mm(radius)} 0 0 ${turn > 0 ? 1 : 0} ${to}`;
  });
  return `M${mm(strokes[0].x)} ${mm(strokes[0].y)}${ways.join('')}Z`;
}

const mm = (value: number): string => decimal(value, SHEET_DIGITS);
