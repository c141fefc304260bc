import type { Ring } from '../types.ts';

/**
 * Two vertices far apart to cut a ring at, the same whichever vertex it starts from: the one farthest from the mean
 * of all, and the one farthest from that; of equals the first by x, then y. Linear.
 *
 * @returns vertex numbers, the first ≠ the second for rings of two distinct vertices or more
 */
export function cutVertices(ring: Ring): readonly [first: number, second: number] {
  let x = 0;
  let y = 0;
  for (let i = 0; i < ring.length; i += 2) {
    x += ring[i] - ring[0];
    y += ring[i + 1] - ring[1];
  }
  const n = ring.length / 2;
  const first = farthestFrom(ring, ring[0] + x / n, ring[1] + y / n);
  return [first, farthestFrom(ring, ring[2 * first], ring[2 * first + 1])];
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

function farthestFrom(ring: Ring, x: number, y: number): number {
  let best = 0;
  let farthest = -1;
  for (let i = 0; i < ring.length; i += 2) {
    const squared = (ring[i] - x) ** 2 + (ring[i + 1] - y) ** 2;
    if (squared < farthest) continue;
    const isFirst =
      ring[i] < ring[2 * best] || (ring[i] === ring[2 * best] && ring[i + 1] < ring[2 * best + 1]);
    if (squared === farthest && !isFirst) continue;
    best = i / 2;
    farthest = squared;
  }
  return best;
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
