import type { Ring } from '../types.ts';

/** A box by its coordinates along and across a unit direction. */
export interface Box {
  readonly ux: number;
  readonly uy: number;
  readonly minA: number;
  readonly maxA: number;
  readonly minB: number;
  readonly maxB: number;
}

/** The boxes around a convex hull that have a side on one of the hull's; the narrowest of all is among them. O(vertices²). */
export function boxesAround(hull: Ring): Box[] {
  const boxes: Box[] = [];
  let j = hull.length - 2;
  for (let i = 0; i < hull.length; j = i, i += 2) {
    const length = Math.hypot(hull[i] - hull[j], hull[i + 1] - hull[j + 1]);
    boxes.push(boxAlong(hull, (hull[i] - hull[j]) / length, (hull[i + 1] - hull[j + 1]) / length));
  }
  return boxes;
}

/** Distance between the two nearest parallels that hold a convex hull. */
export function leastWidth(hull: Ring): number {
  return boxesAround(hull).reduce((least, { minB, maxB }) => Math.min(least, maxB - minB), Infinity);
}

function boxAlong(hull: Ring, ux: number, uy: number): Box {
  let [minA, maxA, minB, maxB] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let k = 0; k < hull.length; k += 2) {
    const along = hull[k] * ux + hull[k + 1] * uy;
    const across = hull[k + 1] * ux - hull[k] * uy;
    minA = Math.min(minA, along);
    maxA = Math.max(maxA, along);
    minB = Math.min(minB, across);
    maxB = Math.max(maxB, across);
  }
  return { ux, uy, minA, maxA, minB, maxB };
}
