import { circleRing, circleThrough, offCircle } from '../geometry/circle.ts';
import { convexHull } from '../geometry/convex-hull.ts';
import type { Ring } from '../types.ts';
import { type Box, boxesAround } from './hull-boxes.ts';

/** Points are this share of a shape's size off it at most (root mean square) when the shape explains them. */
const LOOSENESS = 0.05;
/** Share of a circle's circumference that points must see: less bends too little to tell its radius. */
const LEAST_ARC = 0.3;

/**
 * The whole of a column whose far side no scanner saw: the circle or rectangle its points lie on.
 *
 * Ours. A half circle gives its circle, two faces give their rectangle. Circle by algebraic least squares
 * ([Kåsa76]), rectangle by the box around the convex hull, with a side on one of the hull's, that runs
 * nearest to the points.
 *
 * @param xy x, y a point, m; not all on one line
 * @returns simple, counter-clockwise; null when neither explains the points
 */
export function completeShell(xy: Float64Array): Ring | null {
  const hull = convexHull(xy);
  return wholeCircle(xy) ?? wholeRectangle(xy, hull);
}

function wholeCircle(xy: Float64Array): Ring | null {
  const circle = circleThrough(xy);
  if (!circle) return null;
  const { rms, arc } = offCircle(xy, circle);
  return arc < LEAST_ARC || rms > LOOSENESS * circle.radius ? null : circleRing(circle);
}

function wholeRectangle(xy: Float64Array, hull: Ring): Ring | null {
  let best: Box | null = null;
  let least = Infinity;
  for (const box of boxesAround(hull)) {
    const distance = distanceToSides(xy, box) / Math.min(box.maxA - box.minA, box.maxB - box.minB);
    if (distance >= least) continue;
    least = distance;
    best = box;
  }
  if (!best || least > LOOSENESS) return null;
  const { ux, uy, minA, maxA, minB, maxB } = best;
  const corners = [
    [minA, minB],
    [maxA, minB],
    [maxA, maxB],
    [minA, maxB],
  ];
  return Float64Array.from(corners.flatMap(([a, b]) => [a * ux - b * uy, a * uy + b * ux]));
}

/** Root mean square distance of points in a box to its nearest side. */
function distanceToSides(xy: Float64Array, { ux, uy, minA, maxA, minB, maxB }: Box): number {
  let squares = 0;
  for (let i = 0; i < xy.length; i += 2) {
    const along = xy[i] * ux + xy[i + 1] * uy;
    const across = xy[i + 1] * ux - xy[i] * uy;
    squares += Math.min(along - minA, maxA - along, across - minB, maxB - across) ** 2;
  }
  return Math.sqrt((2 * squares) / xy.length);
}
