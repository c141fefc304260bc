/**
 * Points among which are all vertices of the lower (side 1) or upper (side -1) chain of the convex hull: those that
 * have a point as low (as high) before them and another behind them are left out [Bentley78]. Exact, by comparisons
 * alone.
 *
 * @param xy distinct points in lexicographic order
 * @returns their numbers, in order; the first and the last point are among them. O(n).
 */
export function chainCandidates(xy: Float64Array, side: 1 | -1): Uint32Array {
  const n = xy.length >> 1;
  const isLowest = new Uint8Array(n);
  let lowest = Number.POSITIVE_INFINITY;
  for (let i = n - 1; i >= 0; i--) {
    const y = side * xy[2 * i + 1];
    if (y >= lowest) continue;
    lowest = y;
    isLowest[i] = 1;
  }
  const candidates = new Uint32Array(n);
  let count = 0;
  lowest = Number.POSITIVE_INFINITY;
  for (let i = 0; i < n; i++) {
    const y = side * xy[2 * i + 1];
    if (y < lowest) lowest = y;
    else if (isLowest[i] === 0) continue;
    candidates[count++] = i;
  }
  return candidates.subarray(0, count);
}
