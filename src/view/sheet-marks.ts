import type { Ring, Vec2 } from '../core/types.ts';
import type { Placement } from './pan-zoom.ts';
import type { SheetTransform } from './parse-drawing.ts';

/** A stretch of wall; the kind is a class for the styles. */
export interface StretchMark {
  readonly kind: 'candidate' | 'cut' | 'remove';
  readonly from: Vec2;
  readonly to: Vec2;
  /** Of the wall, m. */
  readonly thickness: number;
}

/** A distance between two places, in words. */
export interface LengthMark {
  readonly kind: 'length';
  readonly from: Vec2;
  readonly to: Vec2;
  readonly words: string;
}

/** A place; caught where it is a corner or an edge of the plan. */
export interface SpotMark {
  readonly kind: 'spot';
  readonly at: Vec2;
  readonly isCaught: boolean;
}

/** A box; what lies outside is veiled. */
export interface BoxMark {
  readonly kind: 'box';
  /** All the way round. */
  readonly corners: readonly Vec2[];
  /** Places a hand takes it by. */
  readonly handles: readonly Vec2[];
}

/** An area; a chosen one stands out of those a pointer passes. */
export interface AreaMark {
  readonly kind: 'area';
  readonly rings: readonly Ring[];
  readonly isChosen: boolean;
}

/** Something marked on the drawing; plan metres. */
export type SheetMark = StretchMark | LengthMark | SpotMark | BoxMark | AreaMark;

/** A place on the screen, px. */
type Pixel = Vec2;

const SVG = 'http://www.w3.org/2000/svg';
/** A mark is larger than the wall it stands on by this all around, px: it shows around solid ink. */
const RIM = 3;
/** Half an end stroke of a length, radius of a spot, half a handle, px. */
const TICK = 6;
const SPOT = 4.5;
const HANDLE = 5;
/** From a length's line to the middle of its words, px. */
const WORDS_ASIDE = 14;
/** Beside a line as steep as this words stand, over a flatter one they lie; sine of its angle. */
const STEEP = 0.5;
/** The veil reaches this far beyond the screen, px. */
const FAR = 1e5;

/** Marks over the drawing, always as thick as the eye needs them. */
export class SheetMarks {
  readonly node = document.createElementNS(SVG, 'svg');
  #marks: readonly SheetMark[] = [];

  constructor() {
    this.node.classList.add('marks');
    this.node.setAttribute('aria-hidden', 'true');
  }

  set(marks: readonly SheetMark[]): void {
    this.#marks = marks;
  }

  /** Draws the marks where `planToSheet` and `placement` put them. */
  draw(planToSheet: SheetTransform, { zoom, x, y }: Placement): void {
    const [a, b, c, d, e, f] = planToSheet;
    const place = ([px, py]: Vec2): Pixel => [
      zoom * (a * px + c * py + e) + x,
      zoom * (b * px + d * py + f) + y,
    ];
    const pixelsPerMetre = zoom * Math.hypot(a, b);
    this.node.replaceChildren(...this.#marks.flatMap((mark) => shapesOf(mark, place, pixelsPerMetre)));
  }
}

function shapesOf(mark: SheetMark, place: (at: Vec2) => Pixel, pixelsPerMetre: number): SVGElement[] {
  switch (mark.kind) {
    case 'length':
      return lengthShapes(place(mark.from), place(mark.to), mark.words);
    case 'spot': {
      const [cx, cy] = place(mark.at);
      const kind = mark.isCaught ? 'mark mark-spot is-caught' : 'mark mark-spot';
      return [shape('circle', { class: kind, cx, cy, r: SPOT })];
    }
    case 'box':
      return boxShapes(mark, place);
    case 'area': {
      const kind = mark.isChosen ? 'mark mark-area is-chosen' : 'mark mark-area';
      const d = mark.rings.map((ring) => closedPath(cornersOf(ring), place)).join('');
      return [shape('path', { class: kind, d, 'fill-rule': 'evenodd' })];
    }
    default: {
      const half = (mark.thickness * pixelsPerMetre) / 2;
      const points = boxAround(place(mark.from), place(mark.to), half);
      return [shape('polygon', { class: `mark mark-${mark.kind}`, points })];
    }
  }
}

/** A line with a stroke across either end, and its words beside the middle, upright, and clear of a steep line. */
function lengthShapes(from: Pixel, to: Pixel, words: string): SVGElement[] {
  const [ux, uy] = directionOf(from, to);
  const across = ([x, y]: Pixel) => {
    const [dx, dy] = [-uy * TICK, ux * TICK];
    return `M${pair(x - dx, y - dy)}L${pair(x + dx, y + dy)}`;
  };
  const line = `M${pair(...from)}L${pair(...to)}${across(from)}${across(to)}`;
  const side = ux >= 0 ? -1 : 1;
  const [x, y] = [
    (from[0] + to[0]) / 2 - side * uy * WORDS_ASIDE,
    (from[1] + to[1]) / 2 + side * ux * WORDS_ASIDE,
  ];
  const aside = -side * uy;
  const anchor = Math.abs(aside) < STEEP ? 'middle' : aside > 0 ? 'start' : 'end';
  const text = shape('text', { class: 'mark-words', x, y, 'text-anchor': anchor });
  text.textContent = words;
  return [
    shape('path', { class: 'mark mark-length-rim', d: line }),
    shape('path', { class: 'mark mark-length', d: line }),
    text,
  ];
}

function boxShapes({ corners, handles }: BoxMark, place: (at: Vec2) => Pixel): SVGElement[] {
  const ring = closedPath(corners, place);
  const veil = `M${-FAR},${-FAR}H${FAR}V${FAR}H${-FAR}Z${ring}`;
  return [
    shape('path', { class: 'mark-veil', d: veil, 'fill-rule': 'evenodd' }),
    shape('path', { class: 'mark mark-box', d: ring }),
    ...handles.map((at) => {
      const [x, y] = place(at);
      const size = 2 * HANDLE;
      return shape('rect', {
        class: 'mark mark-handle',
        x: x - HANDLE,
        y: y - HANDLE,
        width: size,
        height: size,
      });
    }),
  ];
}

function closedPath(corners: readonly Vec2[], place: (at: Vec2) => Pixel): string {
  return `M${corners.map((corner) => pair(...place(corner))).join('L')}Z`;
}

function cornersOf(ring: Ring): Vec2[] {
  return Array.from({ length: ring.length / 2 }, (_, i) => [ring[2 * i], ring[2 * i + 1]]);
}

/** The box along a stretch, `half` px and the rim to both sides. */
function boxAround(from: Pixel, to: Pixel, half: number): string {
  const [ux, uy] = directionOf(from, to);
  const [alongX, alongY, asideX, asideY] = [ux * RIM, uy * RIM, -uy * (half + RIM), ux * (half + RIM)];
  return [
    [from[0] - alongX - asideX, from[1] - alongY - asideY],
    [to[0] + alongX - asideX, to[1] + alongY - asideY],
    [to[0] + alongX + asideX, to[1] + alongY + asideY],
    [from[0] - alongX + asideX, from[1] - alongY + asideY],
  ]
    .map(([x, y]) => pair(x, y))
    .join(' ');
}

function directionOf([fromX, fromY]: Pixel, [toX, toY]: Pixel): Pixel {
  const length = Math.hypot(toX - fromX, toY - fromY) || 1;
  return [(toX - fromX) / length, (toY - fromY) / length];
}

function pair(x: number, y: number): string {
  return `${x.toFixed(1)},${y.toFixed(1)}`;
}

function shape(name: string, attributes: Readonly<Record<string, string | number>>): SVGElement {
  const node = document.createElementNS(SVG, name);
  for (const [key, value] of Object.entries(attributes)) {
    node.setAttribute(key, typeof value === 'number' ? value.toFixed(1) : value);
  }
  return node;
}
