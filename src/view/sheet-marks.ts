import type { Placement } from './pan-zoom.ts';
import type { SheetTransform } from './parse-drawing.ts';

/** A stretch of wall marked on the drawing; the kind is a class for the styles. */
export interface SheetMark {
  readonly kind: 'candidate' | 'cut' | 'remove';
  /** Plan metres. */
  readonly from: readonly [x: number, y: number];
  readonly to: readonly [x: number, y: number];
  /** Of the wall, m. */
  readonly thickness: number;
}

const SVG = 'http://www.w3.org/2000/svg';
/** A mark is larger than the wall it stands on by this all around, px: it shows around solid ink. */
const RIM = 3;

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
    const place = ([px, py]: SheetMark['from']) =>
      [zoom * (a * px + c * py + e) + x, zoom * (b * px + d * py + f) + y] as const;
    const pixelsPerMetre = zoom * Math.hypot(a, b);
    const shapes = this.#marks.map(({ kind, from, to, thickness }) => {
      const shape = document.createElementNS(SVG, 'polygon');
      shape.setAttribute('class', `mark mark-${kind}`);
      shape.setAttribute('points', boxAround(place(from), place(to), (thickness * pixelsPerMetre) / 2));
      return shape;
    });
    this.node.replaceChildren(...shapes);
  }
}

/** The box along a stretch, `half` px and the rim to both sides. */
function boxAround(
  [fromX, fromY]: readonly [number, number],
  [toX, toY]: readonly [number, number],
  half: number,
): string {
  const length = Math.hypot(toX - fromX, toY - fromY) || 1;
  const [ux, uy] = [(toX - fromX) / length, (toY - fromY) / length];
  const [alongX, alongY, asideX, asideY] = [ux * RIM, uy * RIM, -uy * (half + RIM), ux * (half + RIM)];
  return [
    [fromX - alongX - asideX, fromY - alongY - asideY],
    [toX + alongX - asideX, toY + alongY - asideY],
    [toX + alongX + asideX, toY + alongY + asideY],
    [fromX - alongX + asideX, fromY - alongY + asideY],
  ]
    .map((corner) => corner.map((value) => value.toFixed(1)).join(','))
    .join(' ');
}
