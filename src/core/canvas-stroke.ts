import type { StrokeTest } from './context.ts';

/** The part of a 2D canvas context that the question needs; core knows no DOM. */
export interface StrokeContext {
  lineWidth: number;
  lineCap: string;
  beginPath(): void;
  moveTo(x: number, y: number): void;
  lineTo(x: number, y: number): void;
  isPointInStroke(x: number, y: number): boolean;
}

/**
 * The stroke question of [Stojanovic19] Algorithm 2, asked of a real canvas: one short path a segment, since a call
 * costs in proportion to the path.
 *
 * @param openContext called at the first question; what it throws, the question throws
 */
export function canvasStrokeTest(openContext: () => StrokeContext): StrokeTest {
  let canvas: StrokeContext | undefined;
  return ([ax, ay, bx, by], lineWidth, xy) => {
    canvas ??= openContext();
    canvas.lineWidth = lineWidth;
    canvas.lineCap = 'butt';
    canvas.beginPath();
    canvas.moveTo(ax, ay);
    canvas.lineTo(bx, by);
    const isIn = new Uint8Array(xy.length / 2);
    for (let i = 0; i < isIn.length; i++) isIn[i] = canvas.isPointInStroke(xy[2 * i], xy[2 * i + 1]) ? 1 : 0;
    return isIn;
  };
}
