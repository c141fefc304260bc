import type { StrokeTest } from '../context.ts';
import { boundsOfAll } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';

/** Points nearer than this to a stroke's edge are decided by the canvas, px. */
const UNCERTAIN = 0.5;
/** Canvas pixels kept free around the drawing: coordinates near 0 are exact in a canvas' single precision. */
const MARGIN = 16;

interface Stroke {
  /** Stroke width, m. */
  readonly width: number;
  readonly pixelsPerMetre: number;
  readonly strokeTest: StrokeTest;
}

/**
 * Which points a stroke along a ring covers ([Stojanovic19] Algorithm 2): each edge a segment of its own,
 * butt caps.
 *
 * Distances decide what lies clear of a stroke's edge; the canvas decides all within half a pixel of it, as
 * the paper's `isPointInStroke` would. O(edges · points).
 *
 * @param xy x, y a point, m
 * @returns one entry a point: 1 in the stroke of any edge
 */
export function pointsInStroke(
  xy: Float64Array,
  ring: Ring,
  { width, pixelsPerMetre, strokeTest }: Stroke,
): Uint8Array {
  const { minX, minY } = boundsOfAll([xy, ring]);
  const toCanvas = (value: number, at: number) =>
    (value - (at % 2 === 0 ? minX : minY)) * pixelsPerMetre + MARGIN;
  const points = xy.map(toCanvas);
  const corners = ring.map(toCanvas);
  const lineWidth = width * pixelsPerMetre;
  const isIn = new Uint8Array(points.length / 2);
  let j = corners.length - 2;
  for (let i = 0; i < corners.length; j = i, i += 2) {
    const segment = [corners[j], corners[j + 1], corners[i], corners[i + 1]] as const;
    const open = markClear(points, segment, lineWidth, isIn);
    if (open.length === 0) continue;
    const asked = Float64Array.from(open.flatMap((k) => [points[2 * k], points[2 * k + 1]]));
    const answers = strokeTest(segment, lineWidth, asked);
    for (let k = 0; k < open.length; k++) isIn[open[k]] |= answers[k];
  }
  return isIn;
}

/** Marks what is clearly in the stroke; returns the points too near its edge to tell. */
function markClear(
  points: Float64Array,
  [ax, ay, bx, by]: readonly [number, number, number, number],
  lineWidth: number,
  isIn: Uint8Array,
): number[] {
  const length = Math.hypot(bx - ax, by - ay);
  const open: number[] = [];
  if (length === 0) return open;
  const [ux, uy] = [(bx - ax) / length, (by - ay) / length];
  for (let k = 0; k < isIn.length; k++) {
    if (isIn[k] === 1) continue;
    const [dx, dy] = [points[2 * k] - ax, points[2 * k + 1] - ay];
    const along = dx * ux + dy * uy;
    // How far inside the stroke's rectangle; negative outside.
    const depth = Math.min(along, length - along, lineWidth / 2 - Math.abs(dx * uy - dy * ux));
    if (depth > UNCERTAIN) isIn[k] = 1;
    else if (depth >= -UNCERTAIN) open.push(k);
  }
  return open;
}
