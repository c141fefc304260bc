/** Fewer points are sorted out no faster than they are hulled. */
const FEW = 64;
/** A point this far left of an edge lies there beyond doubt, in squares of the extent: 1,000 times the rounding. */
const SURE = 1e-12;

/**
 * Points among which are all vertices of the convex hull: those strictly inside the octagon of the points farthest in
 * eight directions are left out [Akl78], doubtful ones kept.
 *
 * @param xy distinct points in lexicographic order
 * @returns their numbers, in order. O(n).
 */
export function hullCandidates(xy: Float64Array): Uint32Array {
  const n = xy.length >> 1;
  const candidates = new Uint32Array(n);
  const octagon = n < FEW ? [] : extremes(xy);
  const isInside = octagon.length < 3 ? () => false : insideTest(xy, octagon);
  let count = 0;
  for (let i = 0; i < n; i++) if (!isInside(xy[2 * i], xy[2 * i + 1])) candidates[count++] = i;
  return candidates.subarray(0, count);
}

/** Points farthest right, up right, up, …: counter-clockwise, without repeats. */
function extremes(xy: Float64Array): number[] {
  const found = new Uint32Array(8);
  const best = new Float64Array(8).fill(Number.NEGATIVE_INFINITY);
  for (let i = 0; i < xy.length; i += 2) {
    const x = xy[i];
    const y = xy[i + 1];
    const sum = x + y;
    const difference = y - x;
    if (x > best[0]) [best[0], found[0]] = [x, i >> 1];
    if (sum > best[1]) [best[1], found[1]] = [sum, i >> 1];
    if (y > best[2]) [best[2], found[2]] = [y, i >> 1];
    if (difference > best[3]) [best[3], found[3]] = [difference, i >> 1];
    if (-x > best[4]) [best[4], found[4]] = [-x, i >> 1];
    if (-sum > best[5]) [best[5], found[5]] = [-sum, i >> 1];
    if (-y > best[6]) [best[6], found[6]] = [-y, i >> 1];
    if (-difference > best[7]) [best[7], found[7]] = [-difference, i >> 1];
  }
  return [...found].filter((point, k) => point !== found[(k + 7) % 8]);
}

/** Tells whether a point lies left of every edge of a ring, beyond doubt. */
function insideTest(xy: Float64Array, ring: readonly number[]): (x: number, y: number) => boolean {
  const edges = new Float64Array(4 * ring.length);
  let extent = 0;
  for (let k = 0; k < ring.length; k++) {
    const a = 2 * ring[k];
    const b = 2 * ring[(k + 1) % ring.length];
    edges.set([xy[a], xy[a + 1], xy[b] - xy[a], xy[b + 1] - xy[a + 1]], 4 * k);
    extent += Math.abs(xy[b] - xy[a]) + Math.abs(xy[b + 1] - xy[a + 1]);
  }
  const sure = SURE * extent * extent;
  return (x, y) => {
    for (let k = 0; k < edges.length; k += 4) {
      const side = edges[k + 2] * (y - edges[k + 1]) - edges[k + 3] * (x - edges[k]);
      if (!(side > sure)) return false;
    }
    return true;
  };
}
