import { boundsOf, pointInRing } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';
import { distanceToRing } from './structure.ts';

/** Places across the longer side of an outline at which its depth is looked at. */
const PLACES = 24;
/** The core of an outline lies at least so deep, by its greatest depth: behind both faces of a hollow wall. */
const CORE_DEPTH = 0.75;
/** A core as full of points as this share of the whole is no hollow. */
const FILLED_SHARE = 0.5;

/** Whether points fill an outline to its core, by their density there and over all. O(points · vertices). */
export function isFilled(outline: Ring, xy: Float64Array): boolean {
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  const step = Math.max(maxX - minX, maxY - minY) / PLACES;
  const places: number[] = [];
  for (let x = minX + step / 2; x < maxX; x += step) {
    for (let y = minY + step / 2; y < maxY; y += step) places.push(x, y);
  }
  const placeDepths = depthsIn(outline, places);
  const core = CORE_DEPTH * placeDepths.reduce((most, depth) => Math.max(most, depth), 0);
  const share = (depths: readonly number[]) => depths.filter((depth) => depth >= core).length / depths.length;
  return share(depthsIn(outline, xy)) > FILLED_SHARE * share(placeDepths);
}

/** Distances to the outline of what lies in it. */
function depthsIn(outline: Ring, xy: ArrayLike<number>): number[] {
  const depths: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    if (pointInRing(xy[i], xy[i + 1], outline) > 0) depths.push(distanceToRing(xy[i], xy[i + 1], outline));
  }
  return depths;
}
