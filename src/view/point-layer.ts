import type { Placement } from './pan-zoom.ts';
import type { SheetTransform } from './parse-drawing.ts';

/** More points than this look the same and cost frames. */
const MOST_POINTS = 250_000;
/** Share of ink a point is drawn with. */
const INK = 0.36;
/** Below this many px between neighbours a point is one pixel, above it two. */
const CLOSE = 3;

/** Points of a slice under the drawing, drawn pixel by pixel: no call per point reaches the canvas. */
export class PointLayer {
  readonly node = document.createElement('canvas');
  #xy: Float64Array = new Float64Array();
  #spacing = 0;

  constructor() {
    this.node.className = 'points';
    this.node.setAttribute('aria-hidden', 'true');
  }

  /** @param spacing mean distance between neighbours, m */
  set(xy: Float64Array, spacing: number): void {
    this.#xy = xy;
    this.#spacing = spacing;
  }

  /** Draws the points where `planToSheet` and `placement` put them. O(points shown). */
  draw(planToSheet: SheetTransform, { zoom, x, y }: Placement): void {
    const ratio = globalThis.devicePixelRatio || 1;
    const { node } = this;
    const width = Math.round(node.clientWidth * ratio);
    const height = Math.round(node.clientHeight * ratio);
    if (node.width !== width || node.height !== height) Object.assign(node, { width, height });
    const context = node.getContext('2d');
    if (!context || width === 0 || height === 0) return;
    const k = zoom * ratio;
    const [a, b, c, d, e, f] = planToSheet;
    const affine = [a * k, b * k, c * k, d * k, e * k + x * ratio, f * k + y * ratio] as const;
    const image = context.createImageData(width, height);
    const apart = this.#spacing * Math.hypot(a, b) * k;
    const size = Math.round(ratio) * (apart > CLOSE * ratio ? 2 : 1);
    plot(new Uint32Array(image.data.buffer), { width, height, size, ink: inkOf(node) }, this.#xy, affine);
    context.putImageData(image, 0, 0);
  }
}

interface Raster {
  readonly width: number;
  readonly height: number;
  readonly size: number;
  readonly ink: number;
}

function plot(
  pixels: Uint32Array,
  { width, height, size, ink }: Raster,
  xy: Float64Array,
  m: SheetTransform,
): void {
  const count = xy.length / 2;
  const step = Math.max(1, Math.ceil(count / MOST_POINTS));
  for (let i = 0; i < count; i += step) {
    const px = Math.floor(m[0] * xy[2 * i] + m[2] * xy[2 * i + 1] + m[4]);
    const py = Math.floor(m[1] * xy[2 * i] + m[3] * xy[2 * i + 1] + m[5]);
    if (px < 0 || py < 0 || px + size > width || py + size > height) continue;
    for (let row = py; row < py + size; row++) pixels.fill(ink, row * width + px, row * width + px + size);
  }
}

/** The canvas's own `color` as one little-endian RGBA word. */
function inkOf(node: Element): number {
  const [r, g, b] = (getComputedStyle(node).color.match(/[\d.]+/g) ?? ['0', '0', '0']).map(Number);
  return ((Math.round(255 * INK) << 24) | (b << 16) | (g << 8) | r) >>> 0;
}
