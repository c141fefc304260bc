import type { Path64 } from 'clipper2-ts';
import type { Polygon, Ring } from '../types.ts';
import { type Bounds, boundsOf, pointInRing, signedArea } from './rings.ts';

/** A path of a clipper2 result in metres, turned as asked; null for what rounding left over. */
type ToRing = (path: Path64, turn: 'counter-clockwise' | 'clockwise') => Ring | null;

interface Outer {
  readonly ring: Ring;
  readonly bounds: Bounds;
  readonly area: number;
  readonly holes: Ring[];
}

/**
 * The areas of a clipper2 result: paths that turn left are outer rings, those that turn right holes of the smallest outer
 * ring around them.
 *
 * clipper2's own tree takes an island that touches the rim of its hole for one more hole. O(rings²) boxes.
 */
export function nestPaths(paths: readonly Path64[], toRing: ToRing): Polygon[] {
  const outers: Outer[] = [];
  const holes: Ring[] = [];
  for (const path of paths) {
    const isOuter = turnsLeft(path);
    const ring = toRing(path, isOuter ? 'counter-clockwise' : 'clockwise');
    if (ring === null) continue;
    if (isOuter) outers.push({ ring, bounds: boundsOf(ring), area: signedArea(ring), holes: [] });
    else holes.push(ring);
  }
  for (const hole of holes) {
    const [x, y] = placeInside(hole);
    const area = -signedArea(hole);
    let around: Outer | null = null;
    for (const outer of outers) {
      // An island in the hole is smaller than it.
      if (outer.area < area || (around !== null && outer.area >= around.area)) continue;
      if (isWithin(outer.bounds, x, y) && pointInRing(x, y, outer.ring) > 0) around = outer;
    }
    around?.holes.push(hole);
  }
  return outers.map(({ ring, holes: own }) => ({ outer: ring, holes: own }));
}

function turnsLeft(path: Path64): boolean {
  let area = 0;
  const [{ x: x0, y: y0 }] = path;
  for (let i = 0; i < path.length; i++) {
    const [a, b] = [path[i], path[(i + 1) % path.length]];
    area += (a.x - x0) * (b.y - y0) - (b.x - x0) * (a.y - y0);
  }
  return area > 0;
}

function isWithin({ minX, minY, maxX, maxY }: Bounds, x: number, y: number): boolean {
  return x >= minX && x <= maxX && y >= minY && y <= maxY;
}

/**
 * A place well inside a ring: rounding leaves a hole that touches its rim a hair outside of it, so that vertices tell nothing.
 *
 * The middle of the widest stretch at the height between the two vertices that lie farthest apart in height.
 */
function placeInside(ring: Ring): readonly [x: number, y: number] {
  const heights = ring.filter((_, i) => i % 2 === 1).sort();
  let [y, gap] = [heights[0], 0];
  for (let k = 1; k < heights.length; k++) {
    if (heights[k] - heights[k - 1] <= gap) continue;
    gap = heights[k] - heights[k - 1];
    y = (heights[k] + heights[k - 1]) / 2;
  }
  const crossings: number[] = [];
  for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
    if (ring[i + 1] > y === ring[j + 1] > y) continue;
    crossings.push(ring[j] + ((y - ring[j + 1]) / (ring[i + 1] - ring[j + 1])) * (ring[i] - ring[j]));
  }
  crossings.sort((a, b) => a - b);
  let [x, width] = [ring[0], -1];
  for (let k = 0; k + 1 < crossings.length; k += 2) {
    if (crossings[k + 1] - crossings[k] <= width) continue;
    width = crossings[k + 1] - crossings[k];
    x = (crossings[k] + crossings[k + 1]) / 2;
  }
  return [x, y];
}
