/**
 * Measures of open rings (x0, y0, x1, y1, …; the last vertex is not repeated), y up. All linear in the vertices.
 */
import type { Polygon, Ring } from '../types.ts';
import { orientation } from './predicates.ts';

export interface Bounds {
  readonly minX: number;
  readonly minY: number;
  readonly maxX: number;
  readonly maxY: number;
}

/** Area of a ring, positive when counter-clockwise; summed relative to its first vertex, so far origins cost nothing. */
export function signedArea(ring: Ring): number {
  const x0 = ring[0];
  const y0 = ring[1];
  let twice = 0;
  for (let i = 2; i + 3 < ring.length; i += 2) {
    twice += (ring[i] - x0) * (ring[i + 3] - y0) - (ring[i + 2] - x0) * (ring[i + 1] - y0);
  }
  return twice / 2;
}

/** Area of a polygon: its outer ring less its holes. */
export function polygonArea({ outer, holes }: Polygon): number {
  let area = Math.abs(signedArea(outer));
  for (const hole of holes) area -= Math.abs(signedArea(hole));
  return area;
}

/** Vertices of all rings. */
export function vertexCount(polygons: readonly Polygon[]): number {
  let vertices = 0;
  for (const { outer, holes } of polygons) {
    vertices += outer.length / 2;
    for (const hole of holes) vertices += hole.length / 2;
  }
  return vertices;
}

/** The ring walked the other way round; the first vertex stays first. */
export function reverseRing(ring: Ring): Ring {
  const reversed = new Float64Array(ring.length);
  for (let i = 0; i < ring.length; i += 2) {
    const from = i === 0 ? 0 : ring.length - i;
    reversed[i] = ring[from];
    reversed[i + 1] = ring[from + 1];
  }
  return reversed;
}

/** Number of the leftmost (lowest of equals) vertex. */
export function leastVertex(ring: Ring): number {
  let least = 0;
  for (let i = 2; i < ring.length; i += 2) {
    if (ring[i] < ring[least] || (ring[i] === ring[least] && ring[i + 1] < ring[least + 1])) least = i;
  }
  return least / 2;
}

/** Whether a simple ring turns counter-clockwise, exactly: its turn at the leftmost (lowest of equals) vertex. */
export function isCounterClockwise(ring: Ring): boolean {
  const n = ring.length;
  const least = 2 * leastVertex(ring);
  const before = (least + n - 2) % n;
  const after = (least + 2) % n;
  return (
    orientation(ring[before], ring[before + 1], ring[least], ring[least + 1], ring[after], ring[after + 1]) >
    0
  );
}

/** The simple ring itself when it already turns as asked, else reversed. */
export function orientRing(ring: Ring, turn: 'counter-clockwise' | 'clockwise'): Ring {
  return isCounterClockwise(ring) === (turn === 'counter-clockwise') ? ring : reverseRing(ring);
}

/** Every ring of the polygons, each outer one before its holes. */
export function ringsOf(polygons: readonly Polygon[]): Ring[] {
  return polygons.flatMap(({ outer, holes }) => [outer, ...holes]);
}

/** Axis-aligned box of x, y pairs; empty input gives an inverted, infinite box. */
export function boundsOf(xy: ArrayLike<number>): Bounds {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (let i = 0; i + 1 < xy.length; i += 2) {
    const x = xy[i];
    const y = xy[i + 1];
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
  }
  return { minX, minY, maxX, maxY };
}

/** Whether two boxes share a place, if only on their edges. */
export function boundsMeet(a: Bounds, b: Bounds): boolean {
  return a.minX <= b.maxX && b.minX <= a.maxX && a.minY <= b.maxY && b.minY <= a.maxY;
}

/** A polygon with the box around it, to be told from those far away at once. */
export interface BoundedArea {
  readonly area: Polygon;
  readonly bounds: Bounds;
}

export function inBounds(area: Polygon): BoundedArea {
  return { area, bounds: boundsOf(area.outer) };
}

/** Those whose boxes meet a polygon's. */
export function near(areas: readonly BoundedArea[], { outer }: Polygon): Polygon[] {
  const box = boundsOf(outer);
  return areas.filter(({ bounds }) => boundsMeet(bounds, box)).map(({ area }) => area);
}

/** The box around several runs of x, y pairs. */
export function boundsOfAll(parts: readonly ArrayLike<number>[]): Bounds {
  const boxes = parts.map(boundsOf);
  return {
    minX: Math.min(...boxes.map(({ minX }) => minX)),
    minY: Math.min(...boxes.map(({ minY }) => minY)),
    maxX: Math.max(...boxes.map(({ maxX }) => maxX)),
    maxY: Math.max(...boxes.map(({ maxY }) => maxY)),
  };
}

export function perimeter(ring: Ring): number {
  let length = 0;
  let j = ring.length - 2;
  for (let i = 0; i < ring.length; i += 2) {
    length += Math.hypot(ring[i] - ring[j], ring[i + 1] - ring[j + 1]);
    j = i;
  }
  return length;
}

/** Centre of the area a ring encloses; the mean of its vertices when that area is 0. */
export function centroid(ring: Ring): readonly [x: number, y: number] {
  const x0 = ring[0];
  const y0 = ring[1];
  let area = 0;
  let sumX = 0;
  let sumY = 0;
  let meanX = 0;
  let meanY = 0;
  for (let i = 0; i < ring.length; i += 2) {
    const j = (i + 2) % ring.length;
    const ax = ring[i] - x0;
    const ay = ring[i + 1] - y0;
    const bx = ring[j] - x0;
    const by = ring[j + 1] - y0;
    const cross = ax * by - bx * ay;
    area += cross;
    sumX += (ax + bx) * cross;
    sumY += (ay + by) * cross;
    meanX += ax;
    meanY += ay;
  }
  const vertices = ring.length / 2;
  if (area === 0) return [x0 + meanX / vertices, y0 + meanY / vertices];
  return [x0 + sumX / (3 * area), y0 + sumY / (3 * area)];
}

/**
 * Where a point lies to a ring, exactly: crossings of a ray to the right, each decided by the orientation predicate.
 *
 * @returns 1 inside, 0 on an edge or vertex, -1 outside; even-odd for rings that cross themselves
 */
export function pointInRing(x: number, y: number, ring: Ring): 1 | 0 | -1 {
  let isInside = false;
  let j = ring.length - 2;
  for (let i = 0; i < ring.length; j = i, i += 2) {
    const ax = ring[j];
    const ay = ring[j + 1];
    const bx = ring[i];
    const by = ring[i + 1];
    if ((ay < y && by < y) || (ay > y && by > y) || (ax < x && bx < x)) continue;
    const side = orientation(ax, ay, bx, by, x, y);
    if (side === 0 && isBetween(x, ax, bx) && isBetween(y, ay, by)) return 0;
    if (ay <= y === by <= y) continue;
    if (side > 0 === by > ay) isInside = !isInside;
  }
  return isInside ? 1 : -1;
}

/** As {@link pointInRing}, for a polygon with holes: 1 inside, 0 on a ring, -1 outside or in a hole. */
export function pointInPolygon(x: number, y: number, { outer, holes }: Polygon): 1 | 0 | -1 {
  const place = pointInRing(x, y, outer);
  if (place < 1) return place;
  for (const hole of holes) {
    const inHole = pointInRing(x, y, hole);
    if (inHole >= 0) return inHole === 0 ? 0 : -1;
  }
  return 1;
}

function isBetween(value: number, a: number, b: number): boolean {
  return (a <= value && value <= b) || (b <= value && value <= a);
}
