import { orient2d } from 'robust-predicates';

/**
 * Which side of the line a → b the point c lies on, exactly [Shewchuk97].
 *
 * Twice the signed area of abc up to rounding; the sign is exact unless products underflow (below 1e-150). The library assumes y down, so its sign is turned.
 *
 * @returns > 0 when a, b, c turn counter-clockwise (c lies left, y up), < 0 clockwise, 0 on one line
 */
export function orientation(ax: number, ay: number, bx: number, by: number, cx: number, cy: number): number {
  return -orient2d(ax, ay, bx, by, cx, cy);
}
