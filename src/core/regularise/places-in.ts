import type { Ring } from '../types.ts';

/** Numbers in `ring` of the vertices of `part`, which follow each other as in the ring; no vertex twice. Linear. */
export function placesIn(ring: Ring, part: Ring): number[] {
  const n = ring.length / 2;
  let at = 0;
  return Array.from({ length: part.length / 2 }, (_, k) => {
    while (ring[2 * at] !== part[2 * k] || ring[2 * at + 1] !== part[2 * k + 1]) at = (at + 1) % n;
    return at;
  });
}
