import simplify from 'simplify-js';
import { squaredDistanceToSegment } from '../geometry/segments.ts';

/** `simplify-js` recurses once a vertex at worst; 10,000 deep overflows the stack, so longer lines are halved first. */
const LONGEST_PIECE = 4_000;

/**
 * Douglas-Peucker simplification [Douglas73] by `simplify-js`: vertices within ε of the line between those kept go.
 *
 * Lines too long for the package's recursion are split as the algorithm itself would split them, so nothing changes.
 *
 * @param line open, x, y a vertex, m; both ends stay
 */
export function douglasPeucker(line: Float64Array, epsilon: number): Float64Array {
  const kept: number[] = [line[0], line[1]];
  // Pieces still to do, the leftmost on top; each gives all its vertices but the first.
  const pieces: [number, number][] = [[0, line.length / 2 - 1]];
  while (pieces.length > 0) {
    const [first, last] = pieces.pop()!;
    if (last - first < LONGEST_PIECE) {
      simplifyPiece(line, first, last, epsilon, kept);
      continue;
    }
    const farthest = farthestVertex(line, first, last, epsilon);
    if (farthest < 0) kept.push(line[2 * last], line[2 * last + 1]);
    else pieces.push([farthest, last], [first, farthest]);
  }
  return Float64Array.from(kept);
}

function simplifyPiece(
  line: Float64Array,
  first: number,
  last: number,
  epsilon: number,
  kept: number[],
): void {
  const points: { x: number; y: number }[] = [];
  for (let v = first; v <= last; v++) points.push({ x: line[2 * v], y: line[2 * v + 1] });
  const simplified = simplify(points, epsilon, true);
  for (let k = 1; k < simplified.length; k++) kept.push(simplified[k].x, simplified[k].y);
}

/** The vertex farthest from the segment first → last, -1 when none is farther than ε. */
function farthestVertex(line: Float64Array, first: number, last: number, epsilon: number): number {
  let best = -1;
  let most = epsilon * epsilon;
  const [ax, ay, bx, by] = [line[2 * first], line[2 * first + 1], line[2 * last], line[2 * last + 1]];
  for (let v = first + 1; v < last; v++) {
    const squared = squaredDistanceToSegment(line[2 * v], line[2 * v + 1], ax, ay, bx, by);
    if (squared <= most) continue;
    most = squared;
    best = v;
  }
  return best;
}
