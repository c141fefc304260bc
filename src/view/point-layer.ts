import type { Placement } from './pan-zoom.ts';
import type { SheetTransform } from './parse-drawing.ts';
import { blankPixels, dot, inkWord, showPixels } from './pixels.ts';

/** More points than this look the same and cost frames. */
const MOST_POINTS = 250_000;
/** Share of ink a point is drawn with. */
const INK = 0.36;
/** Below this many px between neighbours a point is one pixel, above it two. */
const CLOSE = 3;

/** Points of a slice under the drawing, set pixel by pixel: no call per point reaches the canvas. */
export class PointLayer {
  readonly node = document.createElement('canvas');
  #xy: Float64Array = new Float64Array();
  #spacing = 0;

  /** @param classes of its canvas, whose colour is the points' */
  constructor(classes: string) {
    this.node.className = classes;
    this.node.setAttribute('aria-hidden', 'true');
  }

  get xy(): Float64Array {
    return this.#xy;
  }

  /** @param spacing mean distance between neighbours, m */
  set(xy: Float64Array, spacing: number): void {
    this.#xy = xy;
    this.#spacing = spacing;
  }

  /** Draws the points where `planToSheet` and `placement` put them. O(points shown). */
  draw(planToSheet: SheetTransform, { zoom, x, y }: Placement): Promise<void> {
    const { node } = this;
    const ratio = globalThis.devicePixelRatio || 1;
    const pixels = blankPixels(Math.round(node.clientWidth * ratio), Math.round(node.clientHeight * ratio));
    const k = zoom * ratio;
    const [a, b, c, d, e, f] = planToSheet;
    const m = [a * k, b * k, c * k, d * k, e * k + x * ratio, f * k + y * ratio] as const;
    const apart = this.#spacing * Math.hypot(a, b) * k;
    const size = Math.round(ratio) * (apart > CLOSE * ratio ? 2 : 1);
    const ink = inkWord(getComputedStyle(node).color, INK);
    const xy = this.#xy;
    const count = xy.length / 2;
    const step = Math.max(1, Math.ceil(count / MOST_POINTS));
    for (let i = 0; i < count; i += step) {
      const px = Math.floor(m[0] * xy[2 * i] + m[2] * xy[2 * i + 1] + m[4]);
      const py = Math.floor(m[1] * xy[2 * i] + m[3] * xy[2 * i + 1] + m[5]);
      dot(pixels, px, py, size, ink);
    }
    return showPixels(node, pixels);
  }
}
