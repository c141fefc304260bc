import { createCanvas, loadImage } from '@napi-rs/canvas';
import { indexedPng } from './indexed-png.ts';

/** Pixels of the picture a pixel of the drawing. */
const SHARPNESS = 1.5;

/** Width and height a standalone SVG gives itself, px. */
export function sizeOf(svg: string): readonly [width: number, height: number] {
  const size = /<svg[^>]* width="(\d+)" height="(\d+)"/.exec(svg);
  if (!size) throw new Error('expected an SVG with a width and a height in whole pixels');
  return [Number(size[1]), Number(size[2])];
}

/** Renders a standalone SVG as PNG; its texts come in the fonts of the machine. */
export async function rasterise(svg: string): Promise<Uint8Array> {
  const [width, height] = sizeOf(svg).map((length) => Math.round(length * SHARPNESS));
  // The picture is drawn at the size the file gives itself, so it is told the larger one: scaling after would blur.
  const large = svg.replace(/ width="\d+" height="\d+"/, ` width="${width}" height="${height}"`);
  const canvas = createCanvas(width, height);
  const context = canvas.getContext('2d');
  context.drawImage(await loadImage(Buffer.from(large)), 0, 0);
  return indexedPng(context.getImageData(0, 0, width, height).data, width, height);
}
