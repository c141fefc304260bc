import { lineIntersection } from '../../geometry/segments.ts';
import { isSimpleRing } from '../../geometry/simplicity.ts';
import type { Ring } from '../../types.ts';

/** Edges shorter than this are no shape of a wall but a seam of two fits, m. */
const SHORTEST = 0.06;
/** A corner moves no farther than this when a seam closes, m. */
const MOST_MOVE = 0.05;

/** Closes the seams of an outline: very short edges give way to the corner that their neighbours make. */
export function cleanRing(ring: Ring): Ring {
  let current = ring;
  for (;;) {
    const shorter = withoutShortest(current);
    if (shorter === null) return current;
    current = shorter;
  }
}

function withoutShortest(ring: Ring): Ring | null {
  const n = ring.length / 2;
  if (n <= 4) return null;
  const at = (i: number) => [ring[2 * ((i + n) % n)], ring[2 * ((i + n) % n) + 1]] as const;
  const edges = Array.from({ length: n }, (_, i) => {
    const [[ax, ay], [bx, by]] = [at(i), at(i + 1)];
    return { i, length: Math.hypot(bx - ax, by - ay) };
  });
  const short = edges.filter(({ length }) => length < SHORTEST).sort((a, b) => a.length - b.length);
  for (const { i } of short) {
    const closed = closeEdge(ring, i);
    if (isSimpleRing(closed)) return closed;
  }
  return null;
}

/** The ring without edge i. */
function closeEdge(ring: Ring, i: number): Ring {
  const n = ring.length / 2;
  const at = (k: number) => [ring[2 * ((k + n) % n)], ring[2 * ((k + n) % n) + 1]] as const;
  const [before, a, b, after] = [at(i - 1), at(i), at(i + 1), at(i + 2)];
  const [mx, my] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const corner = lineIntersection(...before, ...a, ...b, ...after);
  const isNear = corner !== null && Math.hypot(corner[0] - mx, corner[1] - my) <= MOST_MOVE;
  const [x, y] = isNear ? corner : [mx, my];
  const kept: number[] = [];
  for (let k = 0; k < n; k++) {
    if (k === i) kept.push(x, y);
    else if (k !== (i + 1) % n) kept.push(...at(k));
  }
  return Float64Array.from(kept);
}
