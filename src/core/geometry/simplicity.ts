import type { Ring } from '../types.ts';
import { orientation } from './predicates.ts';
import { boundsOf } from './rings.ts';
import { SegmentGrid } from './segment-grid.ts';
import { segmentsTouch } from './segments.ts';

/**
 * Whether a ring is simple, exactly: three vertices or more, no two edges sharing a point but neighbours their
 * common vertex, and no neighbours folded onto each other. Near-linear by a grid over the edges.
 */
export function isSimpleRing(ring: Ring): boolean {
  return crossingRings([ring]).size === 0;
}

/**
 * Numbers of the rings that are not simple, or that touch another ring otherwise than vertex on vertex without
 * passing through it. Exact; near-linear by a grid over the edges.
 */
export function crossingRings(rings: readonly Ring[]): Set<number> {
  const bad = new Set<number>();
  const edges = edgesOf(rings);
  const { x, y, next, ringOf } = edges;
  const n = x.length;
  rings.forEach((ring, r) => {
    if (ring.length < 6) bad.add(r);
  });
  if (n === 0) return bad;
  const grid = new SegmentGrid(x, y, edges.bounds, edges.cell);
  for (let e = 0; e < n; e++) {
    const count = grid.along(e, next[e]);
    for (let k = 0; k < count; k++) {
      const f = grid.u[grid.found[k]];
      if (bad.has(ringOf[e]) && bad.has(ringOf[f])) continue;
      if (!isConflict(edges, e, f)) continue;
      bad.add(ringOf[e]);
      bad.add(ringOf[f]);
    }
    grid.add(e, next[e]);
  }
  return bad;
}

interface Edges {
  readonly x: Float64Array;
  readonly y: Float64Array;
  readonly next: Int32Array;
  readonly previous: Int32Array;
  readonly ringOf: Int32Array;
  readonly bounds: ReturnType<typeof boundsOf>;
  readonly cell: number;
}

function edgesOf(rings: readonly Ring[]): Edges {
  const n = rings.reduce((sum, ring) => sum + (ring.length >> 1), 0);
  const x = new Float64Array(n);
  const y = new Float64Array(n);
  const next = new Int32Array(n);
  const previous = new Int32Array(n);
  const ringOf = new Int32Array(n);
  const xy = new Float64Array(2 * n);
  let at = 0;
  rings.forEach((ring, r) => {
    const size = ring.length >> 1;
    xy.set(ring, 2 * at);
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
  // As many cells as edges: a long edge then passes about √n of them.
  const area = (bounds.maxX - bounds.minX) * (bounds.maxY - bounds.minY);
  const longest = Math.max(bounds.maxX - bounds.minX, bounds.maxY - bounds.minY);
  const cell = Math.max(Math.sqrt(area / n), longest / n) || 1;
  return { x, y, next, previous, ringOf, bounds, cell };
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
