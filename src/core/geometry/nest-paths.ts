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
    const bounds = boundsOf(hole);
    let around: Outer | null = null;
    for (const outer of outers) {
      if (around !== null && outer.area >= around.area) continue;
      if (contains(outer.bounds, bounds) && liesIn(hole, outer.ring)) around = outer;
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

function contains(a: Bounds, b: Bounds): boolean {
  return a.minX <= b.minX && a.minY <= b.minY && a.maxX >= b.maxX && a.maxY >= b.maxY;
}

/** By the first vertex, or middle of an edge, that is not on the outer ring: rings may touch. */
function liesIn(inner: Ring, outer: Ring): boolean {
  for (let i = 0; i < inner.length; i += 2) {
    const place = pointInRing(inner[i], inner[i + 1], outer);
    if (place !== 0) return place > 0;
  }
  for (let i = 0; i < inner.length; i += 2) {
    const j = (i + 2) % inner.length;
    const place = pointInRing((inner[i] + inner[j]) / 2, (inner[i + 1] + inner[j + 1]) / 2, outer);
    if (place !== 0) return place > 0;
  }
  return true;
}
