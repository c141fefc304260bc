import { orientation } from './predicates.ts';

/**
 * Whether the closed segments ab and cd share a point, exactly: crossing, touching and overlapping all count.
 */
export function segmentsTouch(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  cx: number,
  cy: number,
  dx: number,
  dy: number,
): boolean {
  if (Math.max(ax, bx) < Math.min(cx, dx) || Math.max(cx, dx) < Math.min(ax, bx)) return false;
  if (Math.max(ay, by) < Math.min(cy, dy) || Math.max(cy, dy) < Math.min(ay, by)) return false;
  const c = orientation(ax, ay, bx, by, cx, cy);
  const d = orientation(ax, ay, bx, by, dx, dy);
  if ((c > 0 && d > 0) || (c < 0 && d < 0)) return false;
  const a = orientation(cx, cy, dx, dy, ax, ay);
  const b = orientation(cx, cy, dx, dy, bx, by);
  // All four on one line: the boxes overlap, so the segments do.
  return !((a > 0 && b > 0) || (a < 0 && b < 0));
}

/** Where the lines ab and cd meet, up to rounding; null when they are parallel. */
export function lineIntersection(
  ax: number,
  ay: number,
  bx: number,
  by: number,
  cx: number,
  cy: number,
  dx: number,
  dy: number,
): readonly [x: number, y: number] | null {
  const ux = bx - ax;
  const uy = by - ay;
  const vx = dx - cx;
  const vy = dy - cy;
  const cross = ux * vy - uy * vx;
  if (cross === 0) return null;
  const share = ((cx - ax) * vy - (cy - ay) * vx) / cross;
  return [ax + share * ux, ay + share * uy];
}

/** Squared distance from p to the closed segment ab. */
export function squaredDistanceToSegment(
  px: number,
  py: number,
  ax: number,
  ay: number,
  bx: number,
  by: number,
): number {
  const ux = bx - ax;
  const uy = by - ay;
  const squaredLength = ux * ux + uy * uy;
  const along = squaredLength === 0 ? 0 : ((px - ax) * ux + (py - ay) * uy) / squaredLength;
  const share = Math.max(0, Math.min(1, along));
  const dx = px - ax - share * ux;
  const dy = py - ay - share * uy;
  return dx * dx + dy * dy;
}
