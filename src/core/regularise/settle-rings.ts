import { isCounterClockwise, pointInRing } from '../geometry/rings.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import { conflictingEdges, type RingEdge } from '../geometry/simplicity.ts';
import type { Ring } from '../types.ts';
import { type Nesting, nestingOf } from './nesting.ts';

/** What a pass wants of a ring. */
export interface RingDraft {
  /** Numbers of the vertices that stay, ascending. */
  readonly kept: readonly number[];
  /** Where vertices that stay go, x, y; the others stay where they are. */
  readonly moved?: ReadonlyMap<number, readonly [x: number, y: number]>;
}

/** A ring on its way to what its draft wants. */
interface Settling {
  readonly ring: Ring;
  kept: number[];
  readonly moved: Map<number, readonly [x: number, y: number]>;
}

/**
 * Carries out what a pass wants of rings, but for the places where edges would cross or touch, a ring turn over or
 * vanish, or come to lie in or out of another: there moved vertices go back and then, farthest first, dropped ones
 * return, until all is well. So a pass gives way where it must and nowhere else.
 *
 * @param rings simple, not crossing each other; no vertex twice in a ring
 */
export function settleRings(rings: readonly Ring[], drafts: readonly RingDraft[]): readonly Ring[] {
  const settling = rings.map((ring, r): Settling => {
    return { ring, kept: [...drafts[r].kept], moved: new Map(drafts[r].moved) };
  });
  const nesting = nestingOf(rings);
  for (;;) {
    const result = settling.map(settledRing);
    const conflicts = conflictingEdges(result);
    // The exact tests of turn and nesting are for rings that are simple.
    const bad =
      conflicts.length > 0
        ? conflicts
        : [...turnedEdges(rings, result), ...movedIn(settling, result, nesting)];
    if (bad.length === 0) return result;
    if (!giveWay(settling, bad)) return rings;
  }
}

/** Takes back what was done at these edges. @returns whether anything was */
function giveWay(settling: readonly Settling[], edges: readonly RingEdge[]): boolean {
  const back = settling.map(() => new Set<number>());
  const returning = settling.map(() => new Set<number>());
  for (const { ring, edge } of edges) {
    const { kept, moved } = settling[ring];
    const movedEnds = [kept[edge], kept[(edge + 1) % kept.length]].filter((vertex) => moved.has(vertex));
    for (const vertex of movedEnds) back[ring].add(vertex);
    const dropped = movedEnds.length > 0 ? -1 : farthestDropped(settling[ring], edge);
    if (dropped >= 0) returning[ring].add(dropped);
  }
  settling.forEach((one, r) => {
    for (const vertex of back[r]) one.moved.delete(vertex);
    if (returning[r].size > 0) one.kept = [...one.kept, ...returning[r]].sort((a, b) => a - b);
  });
  return back.some(({ size }) => size > 0) || returning.some(({ size }) => size > 0);
}

function settledRing({ ring, kept, moved }: Settling): Ring {
  const settled = new Float64Array(2 * kept.length);
  kept.forEach((vertex, k) => {
    const [x, y] = moved.get(vertex) ?? [ring[2 * vertex], ring[2 * vertex + 1]];
    settled[2 * k] = x;
    settled[2 * k + 1] = y;
  });
  return settled;
}

/** All edges of rings that turn the other way than before. */
function turnedEdges(before: readonly Ring[], after: readonly Ring[]): RingEdge[] {
  return after.flatMap((ring, r) => {
    return isCounterClockwise(ring) === isCounterClockwise(before[r]) ? [] : edgesOf(ring, r);
  });
}

/** Edges over which a ring has come to lie in or out of another. */
function movedIn(settling: readonly Settling[], after: readonly Ring[], before: Nesting): RingEdge[] {
  const now = nestingOf(after);
  const edges: RingEdge[] = [];
  for (let r = 0; r < after.length; r++) {
    for (let s = 0; s < after.length; s++) {
      if (now.has(r, s) === before.has(r, s)) continue;
      const hasMoved = settling[r].moved.size + settling[s].moved.size > 0;
      if (hasMoved) edges.push(...edgesOf(after[r], r), ...edgesOf(after[s], s));
      else edges.push(...pocketsAround(settling[r], after[s]).map((edge) => ({ ring: r, edge })));
    }
  }
  return edges;
}

/** Edges whose dropped vertices hold a vertex of another ring between them and the edge. */
function pocketsAround({ ring, kept }: Settling, other: Ring): number[] {
  return Array.from(kept.keys()).filter((edge) => {
    const pocket = chainOf(ring, kept, edge).flatMap((v) => [ring[2 * v], ring[2 * v + 1]]);
    if (pocket.length < 6) return false;
    const outline = Float64Array.from(pocket);
    for (let i = 0; i < other.length; i += 2) {
      const place = pointInRing(other[i], other[i + 1], outline);
      if (place > 0) return true;
    }
    return false;
  });
}

function edgesOf(ring: Ring, r: number): RingEdge[] {
  return Array.from({ length: ring.length / 2 }, (_, edge) => ({ ring: r, edge }));
}

/** Of the vertices dropped between the ends of an edge the one farthest from it; -1 when none was. */
function farthestDropped({ ring, kept }: Settling, edge: number): number {
  const chain = chainOf(ring, kept, edge);
  const [from, to] = [chain[0], chain[chain.length - 1]];
  let best = -1;
  let farthest = -1;
  for (const v of chain.slice(1, -1)) {
    const squared = squaredDistanceToSegment(
      ring[2 * v],
      ring[2 * v + 1],
      ring[2 * from],
      ring[2 * from + 1],
      ring[2 * to],
      ring[2 * to + 1],
    );
    if (squared <= farthest) continue;
    farthest = squared;
    best = v;
  }
  return best;
}

/** The vertices an edge stands for, its ends included. */
function chainOf(ring: Ring, kept: readonly number[], edge: number): number[] {
  const n = ring.length / 2;
  const from = kept[edge];
  const to = kept[(edge + 1) % kept.length];
  // One vertex alone stands for the whole ring.
  const steps = (to - from + n) % n || n;
  return Array.from({ length: steps + 1 }, (_, k) => (from + k) % n);
}
