import { boundsOf } from '../core/geometry/rings.ts';
import { OKABE_ITO } from '../write/pictures/palette.ts';
import { blankPixels, dot, hexWord, inkWord, showPixels } from './pixels.ts';

/** More points than this look the same in a small picture. */
const MOST_POINTS = 20_000;
const MARGIN = 4;
const GROUP_INKS = OKABE_ITO.map(hexWord);

/**
 * A small picture of a slice seen from above, in ink or with each group in its colour.
 *
 * @param xy x, y a point, m
 * @param groups group of every point
 */
export function drawSlice(canvas: HTMLCanvasElement, xy: Float64Array, groups?: Uint8Array): Promise<void> {
  const ratio = globalThis.devicePixelRatio || 1;
  const pixels = blankPixels(Math.round(canvas.clientWidth * ratio), Math.round(canvas.clientHeight * ratio));
  const { width, height } = pixels;
  const { minX, minY, maxX, maxY } = boundsOf(xy);
  const margin = MARGIN * ratio;
  const scale = Math.min(
    (width - 2 * margin) / Math.max(maxX - minX, Number.EPSILON),
    (height - 2 * margin) / Math.max(maxY - minY, Number.EPSILON),
  );
  const ink = inkWord(getComputedStyle(canvas).color, 1);
  const step = Math.max(1, Math.ceil(xy.length / 2 / MOST_POINTS));
  for (let i = 0; i < xy.length / 2; i += step) {
    const x = Math.floor(width / 2 + scale * (xy[2 * i] - (minX + maxX) / 2));
    const y = Math.floor(height / 2 - scale * (xy[2 * i + 1] - (minY + maxY) / 2));
    dot(pixels, x, y, Math.round(ratio), groups ? GROUP_INKS[groups[i] % GROUP_INKS.length] : ink);
  }
  return showPixels(canvas, pixels);
}
