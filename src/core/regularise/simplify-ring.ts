import { isCounterClockwise } from '../geometry/rings.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import { conflictingEdges, type RingEdge } from '../geometry/simplicity.ts';
import type { RegularisationPass, Ring } from '../types.ts';
import { cutRing, cutVertices, joinLines } from './cut-ring.ts';
import { douglasPeucker } from './douglas-peucker.ts';
import { radialDistance } from './radial-distance.ts';
import { visvalingam } from './visvalingam.ts';

export interface Tolerances {
  /** Radial distance and Douglas-Peucker, m. */
  readonly epsilon: number;
  /** Visvalingam, m². */
  readonly areaEpsilon: number;
}

/**
 * Simplifies one ring by the passes named, in the order given; see {@link simplifyRings}.
 *
 * @param ring simple
 * @returns simple ring with the same sense of rotation and at least three vertices, all from the ring given
 */
export function simplifyRing(
  ring: Ring,
  { passes, ...tolerances }: Tolerances & { readonly passes: readonly RegularisationPass[] },
): Ring {
  let rings: readonly Ring[] = [ring];
  for (const pass of passes) rings = simplifyRings(rings, pass, tolerances);
  return rings[0];
}

/**
 * One pass over rings that stay apart. Where it makes an edge cross another, or a ring turn over or vanish, the vertex
 * dropped farthest from that edge comes back, until all is well: the tolerance shrinks there and nowhere else.
 *
 * @param rings simple, not crossing each other; no vertex twice in a ring
 */
export function simplifyRings(
  rings: readonly Ring[],
  pass: RegularisationPass,
  tolerances: Tolerances,
): readonly Ring[] {
  const kept = rings.map((ring) => placesIn(ring, applyPass(ring, pass, tolerances)));
  for (;;) {
    const result = rings.map((ring, r) => ringOf(ring, kept[r]));
    const edges = [...conflictingEdges(result), ...turnedEdges(rings, result)];
    if (edges.length === 0) return result;
    const returning = rings.map(() => new Set<number>());
    for (const { ring, edge } of edges) {
      const vertex = farthestDropped(rings[ring], kept[ring], edge);
      if (vertex >= 0) returning[ring].add(vertex);
    }
    if (returning.every((vertices) => vertices.size === 0)) return rings;
    returning.forEach((vertices, r) => {
      if (vertices.size > 0) kept[r] = [...kept[r], ...vertices].sort((a, b) => a - b);
    });
  }
}

function applyPass(ring: Ring, pass: RegularisationPass, { epsilon, areaEpsilon }: Tolerances): Ring {
  if (pass === 'visvalingam') return visvalingam(ring, areaEpsilon);
  const passOf = pass === 'radial' ? radialDistance : douglasPeucker;
  const [there, back] = cutRing(ring, cutVertices(ring));
  return joinLines([passOf(there, epsilon), passOf(back, epsilon)]);
}

/** Numbers in `ring`, ascending, of the vertices of `part`, which follow each other as in the ring. */
function placesIn(ring: Ring, part: Ring): number[] {
  const n = ring.length / 2;
  const places: number[] = [];
  let at = 0;
  for (let k = 0; k < part.length; k += 2) {
    while (ring[2 * at] !== part[k] || ring[2 * at + 1] !== part[k + 1]) at = (at + 1) % n;
    places.push(at);
  }
  return places.sort((a, b) => a - b);
}

function ringOf(ring: Ring, kept: readonly number[]): Ring {
  const part = new Float64Array(2 * kept.length);
  kept.forEach((vertex, k) => {
    part[2 * k] = ring[2 * vertex];
    part[2 * k + 1] = ring[2 * vertex + 1];
  });
  return part;
}

/** All edges of rings that turn the other way than before. */
function turnedEdges(before: readonly Ring[], after: readonly Ring[]): RingEdge[] {
  return after.flatMap((ring, r) => {
    if (isCounterClockwise(ring) === isCounterClockwise(before[r])) return [];
    return Array.from({ length: ring.length / 2 }, (_, edge) => ({ ring: r, edge }));
  });
}

/** Of the vertices dropped between the ends of an edge the one farthest from it; -1 when none was. */
function farthestDropped(ring: Ring, kept: readonly number[], edge: number): number {
  const n = ring.length / 2;
  const from = kept[edge];
  const to = kept[(edge + 1) % kept.length];
  let best = -1;
  let farthest = -1;
  for (let v = (from + 1) % n; v !== to; v = (v + 1) % n) {
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
