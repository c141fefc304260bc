import { leastVertex } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';

/**
 * Two vertices far apart to cut a ring at, the same whichever vertex it starts from and whichever way it turns.
 *
 * From the first vertex by x, then y, always on to the farthest vertex until that is no farther than the last step:
 * mostly the diameter, so both are corners of the convex hull that no simplification should take. Exact ties go by x,
 * then y. A few linear sweeps.
 *
 * @returns vertex numbers, the first ≠ the second for rings of two distinct vertices or more
 */
export function cutVertices(ring: Ring): readonly [first: number, second: number] {
  let first = leastVertex(ring);
  let second = farthestFrom(ring, first);
  let reach = 0;
  while (squaredDistance(ring, first, second) > reach) {
    reach = squaredDistance(ring, first, second);
    const next = farthestFrom(ring, second);
    first = second;
    second = next;
  }
  return isBefore(ring, first, second) ? [first, second] : [second, first];
}

/** The open lines from the first to the second vertex and back, both ends included. */
export function cutRing(
  ring: Ring,
  [first, second]: readonly [number, number],
): readonly [Float64Array, Float64Array] {
  return [lineBetween(ring, first, second), lineBetween(ring, second, first)];
}

/** Joins what {@link cutRing} cut, without the doubled ends. */
export function joinLines([there, back]: readonly [Float64Array, Float64Array]): Ring {
  const ring = new Float64Array(there.length + back.length - 4);
  ring.set(there.subarray(0, there.length - 2));
  ring.set(back.subarray(0, back.length - 2), there.length - 2);
  return ring;
}

function farthestFrom(ring: Ring, vertex: number): number {
  let best = vertex;
  let farthest = -1;
  for (let v = 0; v < ring.length / 2; v++) {
    const squared = squaredDistance(ring, v, vertex);
    if (squared < farthest || (squared === farthest && !isBefore(ring, v, best))) continue;
    best = v;
    farthest = squared;
  }
  return best;
}

function squaredDistance(ring: Ring, v: number, w: number): number {
  return (ring[2 * v] - ring[2 * w]) ** 2 + (ring[2 * v + 1] - ring[2 * w + 1]) ** 2;
}

/** By x, then y. */
function isBefore(ring: Ring, v: number, w: number): boolean {
  return ring[2 * v] < ring[2 * w] || (ring[2 * v] === ring[2 * w] && ring[2 * v + 1] < ring[2 * w + 1]);
}

function lineBetween(ring: Ring, from: number, to: number): Float64Array {
  const n = ring.length / 2;
  const vertices = ((to - from + n) % n) + 1;
  const line = new Float64Array(2 * vertices);
  const head = Math.min(vertices, n - from);
  line.set(ring.subarray(2 * from, 2 * (from + head)));
  line.set(ring.subarray(0, 2 * (vertices - head)), 2 * head);
  return line;
}
