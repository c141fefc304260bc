import { FloorPlanError } from '../errors.ts';

/** Fewer points enclose no area and make no outline. */
export const FEWEST_POINTS = 3;
/** Share of a cloud's length below which its width is float32 rounding. */
const ROUNDING = 1e-6;

/**
 * Refuses clouds that enclose nothing: too few points, all equal, all on a line. O(n).
 *
 * @param hint what to try, where the file is not to blame
 * @throws input/too-few-points, input/degenerate
 */
export function checkSpread(positions: Float32Array, hint?: string): void {
  const points = positions.length / 3;
  if (points < FEWEST_POINTS) {
    throw new FloorPlanError(
      'input/too-few-points',
      `expected at least ${FEWEST_POINTS} points, found ${points}`,
      {
        hint: hint ?? 'Check that the file holds the whole scan.',
        detail: { points },
      },
    );
  }
  const a = farthestFrom(positions, 0);
  const b = farthestFrom(positions, a.index);
  if (b.distance === 0) throw degenerate('all points are equal', points, hint);
  if (widthAcross(positions, a.index, b.index) <= ROUNDING * b.distance) {
    throw degenerate('all points lie on one line', points, hint);
  }
}

function farthestFrom(p: Float32Array, index: number): { index: number; distance: number } {
  const [x, y, z] = p.subarray(3 * index, 3 * index + 3);
  let farthest = { index, distance: 0 };
  for (let i = 0; i < p.length; i += 3) {
    const distance = Math.hypot(p[i] - x, p[i + 1] - y, p[i + 2] - z);
    if (distance > farthest.distance) farthest = { index: i / 3, distance };
  }
  return farthest;
}

/** Largest distance of any point from the line through points `a` and `b`. */
function widthAcross(p: Float32Array, a: number, b: number): number {
  const [x, y, z] = p.subarray(3 * a, 3 * a + 3);
  const [dx, dy, dz] = [p[3 * b] - x, p[3 * b + 1] - y, p[3 * b + 2] - z];
  const length = Math.hypot(dx, dy, dz);
  let width = 0;
  for (let i = 0; i < p.length; i += 3) {
    const [px, py, pz] = [p[i] - x, p[i + 1] - y, p[i + 2] - z];
    const area = Math.hypot(py * dz - pz * dy, pz * dx - px * dz, px * dy - py * dx);
    width = Math.max(width, area / length);
  }
  return width;
}

function degenerate(found: string, points: number, hint?: string): FloorPlanError {
  return new FloorPlanError('input/degenerate', `expected points spread over an area, found that ${found}`, {
    hint: hint ?? 'Check which columns hold the coordinates.',
    detail: { points },
  });
}
