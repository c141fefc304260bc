import { boundsOf, centroid } from '../../core/geometry/rings.ts';
import type { Polygon, Ring } from '../../core/types.ts';

/** Cells along the longer side of the first grid, and how often the best cell is searched again more finely. */
const CELLS = 32;
const ROUNDS = 4;

/** A metre away from the centre of the area outweighs this much less room: even rooms get their label in the middle. */
const PULL = 0.05;

/**
 * Where a label has most room: about the pole of inaccessibility, the inner point farthest from every edge, drawn a
 * little to the centre of the area.
 *
 * A grid over the polygon, then finer grids around its best point; within a few centimetres, which is all a label needs.
 * Edges × CELLS² × ROUNDS.
 *
 * @returns x, y and the distance to the nearest edge, metres
 */
export function labelPoint({ outer, holes }: Polygon): readonly [x: number, y: number, distance: number] {
  const rings = [outer, ...holes];
  const [centreX, centreY] = centroid(outer);
  let window = boundsOf(outer);
  let cell = Math.max(window.maxX - window.minX, window.maxY - window.minY) / CELLS;
  let best: readonly [number, number, number] = [outer[0], outer[1], Number.NEGATIVE_INFINITY];
  let bestScore = Number.NEGATIVE_INFINITY;
  for (let round = 0; round < ROUNDS; round++) {
    for (let y = window.minY + cell / 2; y < window.maxY; y += cell) {
      for (let x = window.minX + cell / 2; x < window.maxX; x += cell) {
        const pull = PULL * Math.sqrt((x - centreX) ** 2 + (y - centreY) ** 2);
        const distance = distanceInside(rings, x, y, Math.max(0, bestScore + pull));
        const score = distance - pull;
        if (distance <= 0 || score <= bestScore) continue;
        best = [x, y, distance];
        bestScore = score;
      }
    }
    const [x, y] = best;
    window = { minX: x - cell, minY: y - cell, maxX: x + cell, maxY: y + cell };
    cell /= CELLS / 4;
  }
  return best;
}

/** Distance to the nearest edge; below 0 outside, and where it is no more than what it must be more than. */
function distanceInside(rings: readonly Ring[], x: number, y: number, least: number): number {
  const leastSquared = least * least;
  let isInside = false;
  let squared = Infinity;
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [ring[j], ring[j + 1], ring[i], ring[i + 1]];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside;
      const [dx, dy] = [bx - ax, by - ay];
      const lengthSquared = dx * dx + dy * dy;
      const share =
        lengthSquared === 0 ? 0 : Math.min(1, Math.max(0, ((x - ax) * dx + (y - ay) * dy) / lengthSquared));
      squared = Math.min(squared, (x - ax - share * dx) ** 2 + (y - ay - share * dy) ** 2);
      if (squared < leastSquared) return -1;
    }
  }
  return (isInside ? 1 : -1) * Math.sqrt(squared);
}
