import { FloorPlanError } from '../../core/errors.ts';
import {
  LINE_STYLES,
  type LineStyle,
  type Sheet,
  type SheetItem,
  type SheetPath,
  type SheetText,
  TEXT_SIZES,
} from '../../core/sheet.ts';
import { arcCentre, arcStrokes } from '../arc-strokes.ts';
import type { Product } from '../plan-writer.ts';
import { withResolution } from './png-resolution.ts';
import { type RasterContext, SHEET_FONT, type WriteTools } from './raster.ts';
import { INK, PAPER, POINT_INK, POINT_SIZE } from './sheet-ink.ts';

const MM_PER_INCH = 25.4;
/** Fine enough to print, small enough to send, dots an inch. */
const RESOLUTION = 200;
/** Larger pictures many programs refuse: A1 at the full resolution. */
const MOST_PIXELS = 40e6;

/**
 * Writes plan.png: a storey's sheet as a picture of 200 dots an inch, coarser for the largest papers, that prints at
 * true scale.
 *
 * @throws environment/canvas where nothing can paint
 */
export async function writePng(
  { sheet }: Product,
  storey: number,
  { makeCanvas }: WriteTools = {},
): Promise<Uint8Array<ArrayBuffer>> {
  const drawn = sheet[storey];
  const { width, height } = drawn.paper;
  const pixelsPerMm = Math.min(RESOLUTION / MM_PER_INCH, Math.sqrt(MOST_PIXELS / (width * height)));
  const canvas = makeCanvas?.(Math.round(width * pixelsPerMm), Math.round(height * pixelsPerMm));
  if (!canvas) {
    throw new FloorPlanError('environment/canvas', 'PNG: expected a canvas to paint on, found none', {
      hint: 'In Node install @napi-rs/canvas; else take SVG or PDF.',
    });
  }
  paintSheet(drawn, canvas.context, pixelsPerMm);
  return withResolution(await canvas.toPng(), pixelsPerMm * 1000);
}

/** Paints a sheet's display list, lowest layer first. */
export function paintSheet(sheet: Sheet, context: RasterContext, pixelsPerMm: number): void {
  context.setTransform(pixelsPerMm, 0, 0, pixelsPerMm, 0, 0);
  context.fillStyle = PAPER;
  context.fillRect(0, 0, sheet.paper.width, sheet.paper.height);
  for (const { isVisible, items } of sheet.layers) {
    if (isVisible) for (const item of items) paintItem(item, context);
  }
}

function paintItem(item: SheetItem, context: RasterContext): void {
  context.save();
  context.fillStyle = INK;
  context.strokeStyle = INK;
  if (item.kind === 'text') paintText(item, context);
  else if (item.kind === 'path') paintPath(item, context);
  else paintPoints(item.xy, context);
  context.restore();
}

function paintPath(path: SheetPath, context: RasterContext): void {
  const look: LineStyle = LINE_STYLES[path.style];
  context.globalAlpha = look.ink ?? 1;
  context.lineWidth = look.width;
  context.lineJoin = 'miter';
  context.setLineDash([...(look.dash ?? [])]);
  context.beginPath();
  path.lines.forEach((line, ring) => {
    trace(path, line, ring, context);
  });
  if (look.isFilled) context.fill('evenodd');
  if (look.width > 0) context.stroke();
}

function trace(
  { arcs = [], isClosed }: SheetPath,
  line: Float64Array,
  ring: number,
  context: RasterContext,
): void {
  const strokes = arcStrokes(
    line,
    arcs.filter((arc) => arc.ring === ring),
  );
  strokes.forEach(({ x, y, turn, radius }, i) => {
    if (i === 0) context.moveTo(x, y);
    const next = strokes[i + 1] ?? strokes[0];
    if (turn === 0) {
      if (i + 1 < strokes.length) context.lineTo(next.x, next.y);
      return;
    }
    const [cx, cy] = arcCentre({ x, y }, next, turn);
    const start = Math.atan2(y - cy, x - cx);
    context.arc(cx, cy, radius, start, start + turn, turn < 0);
  });
  if (isClosed) context.closePath();
}

function paintPoints(xy: Float64Array, context: RasterContext): void {
  context.globalAlpha = POINT_INK;
  const half = POINT_SIZE / 2;
  for (let i = 0; i < xy.length; i += 2)
    context.fillRect(xy[i] - half, xy[i + 1] - half, POINT_SIZE, POINT_SIZE);
}

function paintText({ x, y, text, size, anchor, isUpright }: SheetText, context: RasterContext): void {
  context.font = `${TEXT_SIZES[size]}px ${SHEET_FONT}`;
  context.textAlign = anchor === 'middle' ? 'center' : anchor === 'start' ? 'left' : 'right';
  context.translate(x, y);
  if (isUpright) context.rotate(-Math.PI / 2);
  context.fillText(text, 0, 0);
}
