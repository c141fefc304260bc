import type { Random } from '../random.ts';

/** Points of a sample at most: two million pairs; the average over more changes by less than 1 %. */
const MOST_SAMPLED = 2_000;

/**
 * Average distance between the points of a random sample ([Stojanovic19] Algorithm 1, AvgDist).
 *
 * @param xy x, y a point
 * @param share of the points that is sampled
 * @returns 0 for fewer than two points; of few points two are sampled at least. O(sample²).
 */
export function averageDistance(xy: Float64Array, share: number, random: Random): number {
  const points = xy.length / 2;
  if (points < 2) return 0;
  const size = Math.max(2, Math.min(MOST_SAMPLED, Math.round(share * points)));
  const order = Uint32Array.from({ length: points }, (_, i) => i);
  for (let i = 0; i < size; i++) {
    const j = i + Math.floor(random() * (points - i));
    [order[i], order[j]] = [order[j], order[i]];
  }
  let sum = 0;
  for (let i = 0; i < size; i++) {
    const [x, y] = [xy[2 * order[i]], xy[2 * order[i] + 1]];
    for (let j = i + 1; j < size; j++) sum += Math.hypot(xy[2 * order[j]] - x, xy[2 * order[j] + 1] - y);
  }
  return sum / ((size * (size - 1)) / 2);
}
