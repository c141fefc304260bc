import { buildPointGrid, squaredDistanceToNearest } from './point-grid.ts';
import { distinctPoints } from './point-order.ts';

/** About as many points have their neighbour sought; the mean over more changes by less than 2 %. */
const SAMPLE = 2_000;
/** Points stand along walls, most of their box is empty: cells smaller than usual hold as many as a search likes. */
const CELLS_PER_POINT = 6;

/**
 * Mean distance from a point to its nearest neighbour, repeats left out.
 *
 * Beyond {@link SAMPLE} points every k-th in lexicographic order is asked, so the order given does not matter.
 *
 * @param xy x, y a point, m
 * @returns metres; 0 for fewer than two distinct points. Linear in points of even density.
 */
export function meanSpacing(xy: Float64Array): number {
  const distinct = distinctPoints(xy);
  const n = distinct.length >> 1;
  if (n < 2) return 0;
  const grid = buildPointGrid(distinct, 0, CELLS_PER_POINT);
  const stride = Math.max(1, Math.floor(n / SAMPLE));
  let sum = 0;
  let count = 0;
  for (let i = 0; i < n; i++) {
    // By lexicographic number, not by place in the grid: the grid's rows would alias with the stride.
    if (grid.source[i] % stride !== 0) continue;
    sum += Math.sqrt(squaredDistanceToNearest(grid, i));
    count++;
  }
  return sum / count;
}
