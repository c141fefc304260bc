import type { Polygon, Ring } from '../../types.ts';
import { type CutSegments, cutSegments, type Segment } from './cut-segments.ts';

/**
 * The subdivision of the plane by segments: vertices, edges and the faces between them.
 *
 * Half edge 2e runs along edge e, 2e + 1 back; each has its face on its left.
 */
export interface Arrangement {
  readonly x: Float64Array;
  readonly y: Float64Array;
  /** Vertex each half edge starts from. */
  readonly origin: Int32Array;
  /** Half edge that follows around the face. */
  readonly next: Int32Array;
  /** Face on the left of each half edge; −1 where a ring bounds the outside. */
  readonly face: Int32Array;
  /** Lines each edge lies on; several where segments overlap. */
  readonly lines: readonly (readonly number[])[];
  /** One half edge of each face's outer ring. */
  readonly faceEdge: Int32Array;
  /** Half edges, one a ring, of what lies within each face without touching it. */
  readonly holes: readonly (readonly number[])[];
  /** m², holes not taken off. */
  readonly areas: Float64Array;
}

/**
 * Cuts segments at each other and finds the faces between them; what bounds no face is left out.
 *
 * O(n²) comparisons of bounding boxes for n segments, O(k log k) for k crossings.
 */
export function arrange(segments: readonly Segment[]): Arrangement {
  return traceFaces(cutSegments(segments));
}

function traceFaces({ x, y, edges }: CutSegments): Arrangement {
  const origin = new Int32Array(2 * edges.a.length);
  edges.a.forEach((from, e) => {
    [origin[2 * e], origin[2 * e + 1]] = [from, edges.b[e]];
  });
  const next = nextAround(origin, x, y);
  const face = new Int32Array(origin.length).fill(-1);
  const faceEdge: number[] = [];
  const areas: number[] = [];
  const outsides: number[] = [];
  const isSeen = new Uint8Array(origin.length);
  for (let h = 0; h < origin.length; h++) {
    if (isSeen[h]) continue;
    let area = 0;
    let g = h;
    do {
      isSeen[g] = 1;
      const [u, v] = [origin[g], origin[g ^ 1]];
      area += (x[u] - x[origin[h]]) * (y[v] - y[origin[h]]) - (x[v] - x[origin[h]]) * (y[u] - y[origin[h]]);
      g = next[g];
    } while (g !== h);
    if (area <= 0) {
      outsides.push(h);
      continue;
    }
    do {
      face[g] = faceEdge.length;
      g = next[g];
    } while (g !== h);
    faceEdge.push(h);
    areas.push(area / 2);
  }
  const traced = {
    x,
    y,
    origin,
    next,
    face,
    lines: edges.lines,
    faceEdge: Int32Array.from(faceEdge),
    areas: Float64Array.from(areas),
  };
  return { ...traced, holes: nestOutsides(traced, outsides) };
}

/** The next half edge around a face: at its end, the first clockwise from where it came. */
function nextAround(origin: Int32Array, x: Float64Array, y: Float64Array): Int32Array {
  const out: number[][] = Array.from({ length: x.length }, () => []);
  const angle = new Float64Array(origin.length);
  for (let h = 0; h < origin.length; h++) {
    out[origin[h]].push(h);
    angle[h] = Math.atan2(y[origin[h ^ 1]] - y[origin[h]], x[origin[h ^ 1]] - x[origin[h]]);
  }
  const next = new Int32Array(origin.length);
  for (const around of out) {
    around.sort((g, h) => angle[g] - angle[h]);
    around.forEach((h, k) => {
      next[h ^ 1] = around[(k + around.length - 1) % around.length];
    });
  }
  return next;
}

type Traced = Omit<Arrangement, 'holes'>;

/** Which face each separate part of the arrangement lies in. */
function nestOutsides(traced: Traced, outsides: readonly number[]): number[][] {
  const holes: number[][] = Array.from(traced.faceEdge, () => []);
  if (outsides.length < 2) return holes;
  for (const h of outsides) {
    const own = new Set<number>();
    let g = h;
    do {
      own.add(traced.origin[g]);
      g = traced.next[g];
    } while (g !== h);
    const [px, py] = [traced.x[traced.origin[h]], traced.y[traced.origin[h]]];
    let best = -1;
    for (let f = 0; f < traced.faceEdge.length; f++) {
      if (best >= 0 && traced.areas[f] >= traced.areas[best]) continue;
      if (own.has(traced.origin[traced.faceEdge[f]])) continue;
      if (isInFace(traced, f, px, py)) best = f;
    }
    if (best < 0) continue;
    holes[best].push(h);
    g = h;
    do {
      traced.face[g] = best;
      g = traced.next[g];
    } while (g !== h);
  }
  return holes;
}

function isInFace({ x, y, origin, next, faceEdge }: Traced, f: number, px: number, py: number): boolean {
  let isInside = false;
  let h = faceEdge[f];
  do {
    const [u, v] = [origin[h], origin[h ^ 1]];
    if (u < 0) break;
    if (y[u] > py !== y[v] > py && px < x[u] + ((py - y[u]) / (y[v] - y[u])) * (x[v] - x[u]))
      isInside = !isInside;
    h = next[h];
  } while (h !== faceEdge[f]);
  return isInside;
}

/** The ring that half edge `h` is part of. */
export function ringFrom(
  { x, y, origin, next }: Pick<Arrangement, 'x' | 'y' | 'origin' | 'next'>,
  h: number,
): Ring {
  const ring: number[] = [];
  let g = h;
  do {
    ring.push(x[origin[g]], y[origin[g]]);
    g = next[g];
  } while (g !== h);
  return Float64Array.from(ring);
}

/** The area of a face, less what lies within it. */
export function faceArea(arrangement: Arrangement, f: number): Polygon {
  const { faceEdge, holes } = arrangement;
  return {
    outer: ringFrom(arrangement, faceEdge[f]),
    holes: holes[f].map((h) => ringFrom(arrangement, h)),
  };
}
