import { lineIntersection, segmentsTouch } from '../geometry/segments.ts';
import type { Gap, Ring } from '../types.ts';

/** Stretches of wall beside a gap that are tried as a line, longest first, m; shorter ones do not say where it points. */
const WALL_STRETCHES = [1, 0.75, 0.5];
/** A stretch is straight when no vertex lies farther than this from its line, m: noise of a hand-held scanner. */
const STRAIGHT = 0.06;
/** … nor is it bent: two lines do not fit this many times better than one, … */
const BEND = 3;
/** … deviations below this, m, aside, which a bend in half a metre hides. */
const LEAST_DEVIATION = 0.005;
/** A line is fitted to this many vertices or more. */
const FEWEST_OF_A_LINE = 3;
/** Walls whose directions into the gap are nearer to opposed than this run on as one: cosine of 155°. */
const STRAIGHT_ON = -0.9;
/** Walls that would meet more sharply than this lie side by side: cosine of 45°. */
const SHARPEST = 0.7;
/** Shorter legs are noise at a wall's end, m. */
const SHORTEST_LEG = 0.1;
/** A wall is drawn on at most this many times as far as it was seen straight: a bend in it would take it elsewhere. */
const MOST_EXTENSION = 3.5;

/**
 * The corner a gap took away: where the walls before and after ring edge k meet, when both are straight and the
 * corner lies ahead of both, within `longestLeg` of each end. Where one wall alone says its direction, or both say
 * the same, the corner is taken as square.
 *
 * @param ring counter-clockwise
 * @returns null when the gap is not at a corner
 */
export function missingCorner(ring: Ring, k: number, longestLeg: number): Gap['from'] | null {
  const m = (k + 1) % (ring.length / 2);
  const gap: Chord = { ax: ring[2 * k], ay: ring[2 * k + 1], bx: ring[2 * m], by: ring[2 * m + 1] };
  const before = wallDirection(ring, k, -1);
  const after = wallDirection(ring, m, 1);
  return cornerOf(gap, before, after, longestLeg);
}

interface Chord {
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
}

/** Where the walls meet, or one of them and a wall square to it; null when they do not tell. */
function cornerOf(
  gap: Chord,
  before: Direction | null,
  after: Direction | null,
  longestLeg: number,
): Gap['from'] | null {
  if (before === null || after === null) return squareCorner(gap, before, after, longestLeg);
  const turn = before.x * after.x + before.y * after.y;
  if (turn > SHARPEST) return squareCorner(gap, before, after, longestLeg);
  return turn < STRAIGHT_ON ? null : meeting(gap, before, after, longestLeg);
}

/** Where both walls meet. */
function meeting(
  { ax, ay, bx, by }: Chord,
  before: Direction,
  after: Direction,
  longestLeg: number,
): Gap['from'] | null {
  const corner = lineIntersection(ax, ay, ax + before.x, ay + before.y, bx, by, bx + after.x, by + after.y);
  if (corner === null) return null;
  const legs = [
    [before, (corner[0] - ax) * before.x + (corner[1] - ay) * before.y],
    [after, (corner[0] - bx) * after.x + (corner[1] - by) * after.y],
  ] as const;
  const isLeg = ([wall, leg]: (typeof legs)[number]) =>
    leg >= SHORTEST_LEG && leg <= Math.min(longestLeg, MOST_EXTENSION * wall.seen);
  return legs.every(isLeg) ? corner : null;
}

/**
 * Where a wall runs on to meet one square to it from the other end of the gap. Of two walls side by side, whose end
 * wall is gone, it is the shorter one: the room reaches as far as the longer does.
 */
function squareCorner(
  { ax, ay, bx, by }: Chord,
  before: Direction | null,
  after: Direction | null,
  longestLeg: number,
): Gap['from'] | null {
  const ahead = before === null ? 0 : (bx - ax) * before.x + (by - ay) * before.y;
  const back = after === null ? 0 : (ax - bx) * after.x + (ay - by) * after.y;
  const [wall, leg, x, y] =
    ahead > back ? ([before, ahead, ax, ay] as const) : ([after, back, bx, by] as const);
  if (wall === null) return null;
  const side = Math.sqrt(Math.max(0, (bx - ax) ** 2 + (by - ay) ** 2 - leg * leg));
  const longest = Math.min(longestLeg, MOST_EXTENSION * wall.seen);
  const isCorner = Math.min(leg, side) >= SHORTEST_LEG && Math.max(leg, side) <= longest;
  return isCorner ? [x + leg * wall.x, y + leg * wall.y] : null;
}

interface Direction {
  readonly x: number;
  readonly y: number;
  /** Length of the straight stretch that tells it, m; 0 where the wall is bent, and not drawn on. */
  readonly seen: number;
}

/** The way the wall that ends at vertex `end` points out into the gap. */
function wallDirection(ring: Ring, end: number, step: 1 | -1): Direction | null {
  const n = ring.length / 2;
  let bent: Direction | null = null;
  for (const stretch of WALL_STRETCHES) {
    const vertices: number[] = [];
    let reach = 0;
    for (let k = 0; k < n - 1 && reach < stretch; k++) {
      const at = (end + step * k + n) % n;
      vertices.push(at);
      reach = Math.hypot(ring[2 * at] - ring[2 * end], ring[2 * at + 1] - ring[2 * end + 1]);
    }
    const line = reach < stretch ? null : fitLine(ring, vertices);
    if (line === null) continue;
    const [x, y] = line.towards;
    if (!line.isBent) return { x, y, seen: reach };
    bent ??= { x, y, seen: 0 };
  }
  return bent;
}

interface FittedLine {
  readonly towards: readonly [x: number, y: number];
  readonly isBent: boolean;
}

/** The total least squares line through vertices, towards the first; null when they are not straight. */
function fitLine(ring: Ring, vertices: readonly number[]): FittedLine | null {
  const [x0, y0] = [ring[2 * vertices[0]], ring[2 * vertices[0] + 1]];
  const sums = runningMoments(vertices.map((v) => [ring[2 * v] - x0, ring[2 * v + 1] - y0]));
  const { meanX, meanY, xx, xy, yy } = spread(sums[0], sums[vertices.length]);
  const angle = Math.atan2(2 * xy, xx - yy) / 2;
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const isStraight = vertices.every(
    (v) => Math.abs(ux * (ring[2 * v + 1] - y0 - meanY) - uy * (ring[2 * v] - x0 - meanX)) <= STRAIGHT,
  );
  if (!isStraight) return null;
  const last = vertices[vertices.length - 1];
  const along = ux * (x0 - ring[2 * last]) + uy * (y0 - ring[2 * last + 1]);
  return { towards: along > 0 ? [ux, uy] : [-ux, -uy], isBent: isBent(sums) };
}

/** Whether two lines, one up to some vertex and one from there on, fit far better than one line does. */
function isBent(sums: readonly Moments[]): boolean {
  const n = sums.length - 1;
  const whole = squaredResidual(sums[0], sums[n]);
  let best = whole;
  for (let k = FEWEST_OF_A_LINE; k <= n - FEWEST_OF_A_LINE; k++) {
    best = Math.min(best, squaredResidual(sums[0], sums[k]) + squaredResidual(sums[k], sums[n]));
  }
  return whole > BEND ** 2 * Math.max(best, n * LEAST_DEVIATION ** 2);
}

/** Count, sums of x, y, x², xy and y². */
type Moments = readonly [number, number, number, number, number, number];

/** Moments of the first k points, for k from none to all. */
function runningMoments(points: readonly (readonly [x: number, y: number])[]): readonly Moments[] {
  const sums: Moments[] = [[0, 0, 0, 0, 0, 0]];
  for (const [x, y] of points) {
    const [count, sumX, sumY, sumXX, sumXY, sumYY] = sums[sums.length - 1];
    sums.push([count + 1, sumX + x, sumY + y, sumXX + x * x, sumXY + x * y, sumYY + y * y]);
  }
  return sums;
}

/** Mean and second moments about it of the points between two running moments. */
function spread(from: Moments, to: Moments) {
  const [count, sumX, sumY, sumXX, sumXY, sumYY] = to.map((sum, k) => sum - from[k]);
  const [meanX, meanY] = [sumX / count, sumY / count];
  const [xx, xy, yy] = [sumXX - sumX * meanX, sumXY - sumX * meanY, sumYY - sumY * meanY];
  return { meanX, meanY, xx, xy, yy };
}

/** Sum of the squared distances from their line of the points between two running moments. */
function squaredResidual(from: Moments, to: Moments): number {
  const { xx, xy, yy } = spread(from, to);
  return Math.max(0, (xx + yy - Math.hypot(xx - yy, 2 * xy)) / 2);
}

/** Whether the way from vertex k over the corner to the next vertex touches no other edge. */
export function isClear(ring: Ring, k: number, [x, y]: readonly [number, number]): boolean {
  const n = ring.length / 2;
  const m = (k + 1) % n;
  for (let i = 0; i < n; i++) {
    if (i === k) continue;
    const j = (i + 1) % n;
    const edge = [ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]] as const;
    if (j !== k && segmentsTouch(ring[2 * k], ring[2 * k + 1], x, y, ...edge)) return false;
    if (i !== m && segmentsTouch(ring[2 * m], ring[2 * m + 1], x, y, ...edge)) return false;
  }
  return true;
}
