import { SHEET_FONT, type WriteTools } from '../drawing/raster.ts';

/** A text as a picture of one bit a pixel, most significant first, rows padded to bytes; sizes in mm. */
export interface TextImage {
  readonly bits: Uint8Array;
  readonly columns: number;
  readonly rows: number;
  readonly width: number;
  readonly height: number;
  /** From the base line to its lower edge. */
  readonly below: number;
}

/** 600 dots an inch: as fine as printers are. */
const PIXELS_PER_MM = 600 / 25.4;
/** Room for what stands above and below letters, in type sizes. */
const ABOVE = 1.2;
const BELOW = 0.5;
/** Longer texts are not set in one picture, in type sizes: memory is bounded. */
const WIDEST = 400;

/** Draws a text with the environment's fonts; null where there is no canvas. */
export function drawTextImage(text: string, size: number, { makeCanvas }: WriteTools): TextImage | null {
  const font = `${size * PIXELS_PER_MM}px ${SHEET_FONT}`;
  const ruler = makeCanvas?.(1, 1);
  if (!ruler) return null;
  ruler.context.font = font;
  const wide = Math.min(ruler.context.measureText(text).width, WIDEST * size * PIXELS_PER_MM);
  const columns = Math.max(1, Math.ceil(wide));
  const rows = Math.ceil((ABOVE + BELOW) * size * PIXELS_PER_MM);
  const canvas = makeCanvas?.(columns, rows);
  if (!canvas) return null;
  const { context } = canvas;
  context.font = font;
  context.fillStyle = '#000';
  const base = ABOVE * size * PIXELS_PER_MM;
  context.fillText(text, 0, base);
  const { data } = context.getImageData(0, 0, columns, rows);
  const stride = Math.ceil(columns / 8);
  const bits = new Uint8Array(stride * rows);
  for (let i = 0; i < columns * rows; i++) {
    const column = i % columns;
    if (data[4 * i + 3] > 127) bits[stride * Math.floor(i / columns) + (column >> 3)] |= 0x80 >> (column & 7);
  }
  const [width, height] = [columns / PIXELS_PER_MM, rows / PIXELS_PER_MM];
  return { bits, columns, rows, width, height, below: height - base / PIXELS_PER_MM };
}
