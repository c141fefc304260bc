import type { Ring } from '../types.ts';
import { orientation } from './predicates.ts';
import { type Bounds, boundsOf } from './rings.ts';
import { cellFor, SegmentGrid } from './segment-grid.ts';
import { segmentsTouch } from './segments.ts';

/** An edge by its ring and its first vertex. */
export interface RingEdge {
  readonly ring: number;
  readonly edge: number;
}

/**
 * Whether a ring is simple, exactly: three vertices or more, no two edges sharing a point but neighbours their
 * common vertex, and no neighbours folded onto each other. Near-linear by a grid over the edges.
 */
export function isSimpleRing(ring: Ring): boolean {
  return conflictingEdges([ring]).length === 0;
}

/**
 * The edges that keep rings from being simple, and from touching each other at most vertex on vertex without passing
 * through; all edges of a ring of fewer than three vertices. Exact; near-linear by a grid over the edges.
 */
export function conflictingEdges(rings: readonly Ring[]): RingEdge[] {
  const edges = edgesOf(rings);
  const { x, y, next, ringOf, firstOf } = edges;
  const n = x.length;
  const isBad = new Uint8Array(n);
  if (n === 0) return [];
  const grid = new SegmentGrid(x, y, edges.bounds, cellFor(edges.bounds, n));
  for (let e = 0; e < n; e++) {
    const isEmpty = x[e] === x[next[e]] && y[e] === y[next[e]];
    if (isEmpty || rings[ringOf[e]].length < 6) isBad[e] = 1;
    const count = grid.along(e, next[e]);
    for (let k = 0; k < count; k++) {
      const f = grid.u[grid.found[k]];
      if ((isBad[e] === 1 && isBad[f] === 1) || !isConflict(edges, e, f)) continue;
      isBad[e] = 1;
      isBad[f] = 1;
    }
    grid.add(e, next[e]);
  }
  const conflicts: RingEdge[] = [];
  for (let e = 0; e < n; e++)
    if (isBad[e] === 1) conflicts.push({ ring: ringOf[e], edge: e - firstOf[ringOf[e]] });
  return conflicts;
}

interface Edges {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly next: Int32Array;
  readonly previous: Int32Array;
  readonly ringOf: Int32Array;
  /** First edge of each ring. */
  readonly firstOf: Int32Array;
  readonly bounds: Bounds;
}

function edgesOf(rings: readonly Ring[]): Edges {
  const n = rings.reduce((sum, ring) => sum + (ring.length >> 1), 0);
  const x = new Float64Array(n);
  const y = new Float64Array(n);
  const next = new Int32Array(n);
  const previous = new Int32Array(n);
  const ringOf = new Int32Array(n);
  const firstOf = new Int32Array(rings.length);
  const xy = new Float64Array(2 * n);
  let at = 0;
  rings.forEach((ring, r) => {
    const size = ring.length >> 1;
    xy.set(ring, 2 * at);
    firstOf[r] = at;
    for (let k = 0; k < size; k++) {
      x[at + k] = ring[2 * k];
      y[at + k] = ring[2 * k + 1];
      next[at + k] = at + ((k + 1) % size);
      previous[at + k] = at + ((k + size - 1) % size);
      ringOf[at + k] = r;
    }
    at += size;
  });
  const bounds = boundsOf(xy);
  return { x, y, next, previous, ringOf, firstOf, bounds };
}

/** Whether edges e and f (from e to next[e], f to next[f]) meet in a way simple rings do not. */
function isConflict({ x, y, next, previous, ringOf }: Edges, e: number, f: number): boolean {
  const a = e;
  const b = next[e];
  const c = f;
  const d = next[f];
  if (!segmentsTouch(x[a], y[a], x[b], y[b], x[c], y[c], x[d], y[d])) return false;
  if (b === c) return b === d || isFolded(x, y, a, b, d);
  if (d === a) return isFolded(x, y, c, d, b);
  if (ringOf[e] === ringOf[f]) return true;
  const isSame = (p: number, q: number) => x[p] === x[q] && y[p] === y[q];
  if (isSame(b, d)) return isFolded(x, y, a, b, c) || passes(x, y, b, [previous[b], next[b]], [c, next[d]]);
  if (isSame(b, c)) return isFolded(x, y, a, b, d);
  if (isSame(a, d)) return isFolded(x, y, b, a, c);
  if (isSame(a, c)) return isFolded(x, y, b, a, d);
  return true;
}

/** Whether the segments ab and bc lie on each other. */
function isFolded(x: Float64Array, y: Float64Array, a: number, b: number, c: number): boolean {
  if (orientation(x[a], y[a], x[b], y[b], x[c], y[c]) !== 0) return false;
  return (x[a] - x[b]) * (x[c] - x[b]) + (y[a] - y[b]) * (y[c] - y[b]) > 0;
}

type Pair = readonly [number, number];

/** Whether two paths through the same point v, each from its first to its second neighbour, cross there. */
function passes(x: Float64Array, y: Float64Array, v: number, one: Pair, other: Pair): boolean {
  const turn = (p: number, q: number) => orientation(x[v], y[v], x[p], y[p], x[q], y[q]);
  const [from, to] = one;
  const isInSector = (p: number) =>
    turn(from, to) > 0 ? turn(from, p) > 0 && turn(p, to) > 0 : !(turn(to, p) >= 0 && turn(p, from) >= 0);
  return isInSector(other[0]) !== isInSector(other[1]);
}
