import Delaunator from 'delaunator';
import { orientRing, signedArea } from '../geometry/rings.ts';
import type { Polygon, Ring } from '../types.ts';

/**
 * α-shape [Edelsbrunner83]: the Delaunay triangles whose circumradius is at most α, as polygons with all their holes.
 *
 * @param points distinct points, x, y each, m
 * @param alpha m
 * @returns one polygon for each set of triangles joined by edges, largest outer ring first; empty when no triangle is small
 *   enough. Rings touch at most in vertices. O(n log n).
 */
export function alphaShape(points: Float64Array, alpha: number): Polygon[] {
  const { triangles, halfedges } = new Delaunator(points);
  const isKept = keepTriangles(points, triangles, alpha);
  const part = labelParts(halfedges, isKept);
  const ringsOfPart = new Map<number, Ring[]>();
  for (const { ring, triangle } of traceRings(points, triangles, halfedges, isKept)) {
    const rings = ringsOfPart.get(part[triangle]);
    if (rings === undefined) ringsOfPart.set(part[triangle], [ring]);
    else rings.push(ring);
  }
  const polygons = [...ringsOfPart.values()].map(toPolygon);
  return polygons.sort((a, b) => signedArea(b.outer) - signedArea(a.outer) || a.outer[0] - b.outer[0]);
}

/** 1 for each triangle of circumradius ≤ α. */
function keepTriangles(points: Float64Array, triangles: Uint32Array, alpha: number): Uint8Array {
  const isKept = new Uint8Array(triangles.length / 3);
  for (let t = 0; t < isKept.length; t++) {
    const [a, b, c] = [2 * triangles[3 * t], 2 * triangles[3 * t + 1], 2 * triangles[3 * t + 2]];
    const abx = points[b] - points[a];
    const aby = points[b + 1] - points[a + 1];
    const acx = points[c] - points[a];
    const acy = points[c + 1] - points[a + 1];
    const bcx = acx - abx;
    const bcy = acy - aby;
    const sides = Math.sqrt((abx * abx + aby * aby) * (acx * acx + acy * acy) * (bcx * bcx + bcy * bcy));
    // R = abc / (4 · area); a flat triangle has none.
    const fourAreas = 2 * Math.abs(abx * acy - aby * acx);
    if (fourAreas > 0 && sides <= alpha * fourAreas) isKept[t] = 1;
  }
  return isKept;
}

/** Number of the edge-connected part each kept triangle belongs to. */
function labelParts(halfedges: Int32Array, isKept: Uint8Array): Int32Array {
  const part = new Int32Array(isKept.length).fill(-1);
  const stack: number[] = [];
  let parts = 0;
  for (let seed = 0; seed < isKept.length; seed++) {
    if (isKept[seed] === 0 || part[seed] >= 0) continue;
    part[seed] = parts;
    stack.push(seed);
    while (stack.length > 0) {
      const t = stack.pop()!;
      for (let e = 3 * t; e < 3 * t + 3; e++) {
        const neighbour = halfedges[e] < 0 ? -1 : Math.floor(halfedges[e] / 3);
        if (neighbour < 0 || isKept[neighbour] === 0 || part[neighbour] >= 0) continue;
        part[neighbour] = parts;
        stack.push(neighbour);
      }
    }
    parts++;
  }
  return part;
}

interface TracedRing {
  readonly ring: Ring;
  /** A triangle of the part the ring bounds. */
  readonly triangle: number;
}

/** Walks the border of the kept triangles; a walk that passes a vertex twice is cut into simple rings there. */
function traceRings(
  points: Float64Array,
  triangles: Uint32Array,
  halfedges: Int32Array,
  isKept: Uint8Array,
): TracedRing[] {
  const following = (e: number) => (e % 3 === 2 ? e - 2 : e + 1);
  const isBorder = (e: number) => halfedges[e] < 0 || isKept[Math.floor(halfedges[e] / 3)] === 0;
  const isSeen = new Uint8Array(halfedges.length);
  const rings: TracedRing[] = [];
  for (let first = 0; first < halfedges.length; first++) {
    const triangle = Math.floor(first / 3);
    if (isSeen[first] === 1 || isKept[triangle] === 0 || !isBorder(first)) continue;
    const walk: number[] = [];
    let e = first;
    do {
      isSeen[e] = 1;
      walk.push(triangles[e]);
      e = following(e);
      while (!isBorder(e)) e = following(halfedges[e]);
    } while (e !== first);
    for (const loop of simpleLoops(walk)) rings.push({ ring: toRing(points, loop), triangle });
  }
  return rings;
}

/** Cuts a closed walk into loops that pass no vertex twice. */
function simpleLoops(walk: readonly number[]): number[][] {
  const loops: number[][] = [];
  const path: number[] = [];
  const placeOf = new Map<number, number>();
  for (const vertex of walk) {
    const place = placeOf.get(vertex);
    if (place !== undefined) {
      const loop = path.splice(place);
      for (const passed of loop) placeOf.delete(passed);
      loops.push(loop);
    }
    placeOf.set(vertex, path.length);
    path.push(vertex);
  }
  loops.push(path);
  return loops;
}

function toRing(points: Float64Array, vertices: readonly number[]): Ring {
  const ring = new Float64Array(2 * vertices.length);
  vertices.forEach((vertex, k) => {
    ring[2 * k] = points[2 * vertex];
    ring[2 * k + 1] = points[2 * vertex + 1];
  });
  return ring;
}

/** Of the rings of one part the largest is the outer one. */
function toPolygon(rings: readonly Ring[]): Polygon {
  const bySize = [...rings].sort((a, b) => Math.abs(signedArea(b)) - Math.abs(signedArea(a)));
  const [outer, ...holes] = bySize;
  return {
    outer: orientRing(outer, 'counter-clockwise'),
    holes: holes.map((hole) => orientRing(hole, 'clockwise')),
  };
}
