import { lineIntersection, segmentsTouch } from '../geometry/segments.ts';
import type { Ring } from '../types.ts';

/** Stretches of wall beside a gap that are tried as a line, longest first, m. */
const WALL_STRETCHES = [1, 0.5, 0.2];
/** A shorter stretch only says roughly where a wall points; it is taken as square to the other wall, m. */
const SURE_STRETCH = 0.5;
/** Rough directions are square when within this of it: cosine of 60°. */
const ROUGHLY_SQUARE = 0.5;
/** A stretch is straight when no vertex lies farther than this from its line, m: noise of a hand-held scanner. */
const STRAIGHT = 0.06;
/** Walls whose directions into the gap are nearer to opposed than this run on as one: cosine of 155°. */
const STRAIGHT_ON = -0.9;
/** Walls that meet more sharply than this make no corner: cosine of 45°. */
const SHARPEST = 0.7;
/** Walls side by side: cosine of 8°. */
const PARALLEL = 0.99;
/** Shorter legs are noise at a wall's end, m. */
const SHORTEST_LEG = 0.1;

/**
 * The corner a gap took away: where the walls before and after ring edge k meet, when both are straight and the
 * corner lies ahead of both, within `longestLeg` of each end; or where a lost end wall met the shorter of two parallel walls.
 *
 * @param ring counter-clockwise
 * @returns null when the gap is not at a corner
 */
export function missingCorner(
  ring: Ring,
  k: number,
  longestLeg: number,
): readonly [x: number, y: number] | null {
  const m = (k + 1) % (ring.length / 2);
  const directions = squared(wallDirection(ring, k, -1), wallDirection(ring, m, 1));
  if (directions === null) return null;
  const [before, after] = directions;
  const turn = before.x * after.x + before.y * after.y;
  if (turn < STRAIGHT_ON) return null;
  const [ax, ay, bx, by] = [ring[2 * k], ring[2 * k + 1], ring[2 * m], ring[2 * m + 1]];
  if (turn > SHARPEST) {
    const corner = turn > PARALLEL ? squareEnd([ax, ay, bx, by], before, after, longestLeg) : null;
    return corner !== null && isClear(ring, k, corner) ? corner : null;
  }
  const corner = lineIntersection(ax, ay, ax + before.x, ay + before.y, bx, by, bx + after.x, by + after.y);
  if (corner === null) return null;
  const legs = [
    (corner[0] - ax) * before.x + (corner[1] - ay) * before.y,
    (corner[0] - bx) * after.x + (corner[1] - by) * after.y,
  ];
  if (legs.some((leg) => leg < SHORTEST_LEG || leg > longestLeg)) return null;
  return isClear(ring, k, corner) ? corner : null;
}

/**
 * Between the ends of two walls side by side the end wall is gone: the room reaches as far as the longer of them, so the
 * shorter one runs on to where a wall square to it meets the end of the longer.
 */
function squareEnd(
  [ax, ay, bx, by]: readonly [number, number, number, number],
  before: Direction,
  after: Direction,
  longestLeg: number,
): readonly [x: number, y: number] | null {
  const ahead = (bx - ax) * before.x + (by - ay) * before.y;
  if (Math.abs(ahead) < SHORTEST_LEG || Math.abs(ahead) > longestLeg) return null;
  if (ahead > 0) return [ax + ahead * before.x, ay + ahead * before.y];
  const back = (ax - bx) * after.x + (ay - by) * after.y;
  return [bx + back * after.x, by + back * after.y];
}

interface Direction {
  readonly x: number;
  readonly y: number;
  /** Length of the wall it was taken from, m. */
  readonly stretch: number;
}

/** Both directions, an unsure one turned square to a sure one; null when the walls do not tell. */
function squared(before: Direction | null, after: Direction | null): readonly [Direction, Direction] | null {
  if (before === null || after === null) return null;
  const isSure = [before, after].map(({ stretch }) => stretch >= SURE_STRETCH);
  if (isSure[0] && isSure[1]) return [before, after];
  if (!isSure[0] && !isSure[1]) return null;
  const cosine = before.x * after.x + before.y * after.y;
  if (Math.abs(cosine) > ROUGHLY_SQUARE) return null;
  return isSure[0] ? [before, squareTo(before, after)] : [squareTo(after, before), after];
}

/** The direction square to `sure` that is nearer to `rough`. */
function squareTo(sure: Direction, rough: Direction): Direction {
  const side = sure.x * rough.y - sure.y * rough.x > 0 ? 1 : -1;
  return { x: -side * sure.y, y: side * sure.x, stretch: rough.stretch };
}

/** The way the wall that ends at vertex `end` points out into the gap. */
function wallDirection(ring: Ring, end: number, step: 1 | -1): Direction | null {
  const n = ring.length / 2;
  for (const stretch of WALL_STRETCHES) {
    const vertices: number[] = [];
    let reach = 0;
    for (let k = 0; k < n - 1 && reach < stretch; k++) {
      const at = (end + step * k + n) % n;
      vertices.push(at);
      reach = Math.hypot(ring[2 * at] - ring[2 * end], ring[2 * at + 1] - ring[2 * end + 1]);
    }
    const direction = reach < stretch ? null : fitDirection(ring, vertices);
    if (direction !== null) return { x: direction[0], y: direction[1], stretch };
  }
  return null;
}

/** Direction of the total least squares line through vertices, towards the first; null when they are not straight. */
function fitDirection(ring: Ring, vertices: readonly number[]): readonly [x: number, y: number] | null {
  const meanX = vertices.reduce((sum, v) => sum + ring[2 * v], 0) / vertices.length;
  const meanY = vertices.reduce((sum, v) => sum + ring[2 * v + 1], 0) / vertices.length;
  let [xx, xy, yy] = [0, 0, 0];
  for (const v of vertices) {
    const dx = ring[2 * v] - meanX;
    const dy = ring[2 * v + 1] - meanY;
    xx += dx * dx;
    xy += dx * dy;
    yy += dy * dy;
  }
  const angle = Math.atan2(2 * xy, xx - yy) / 2;
  const [ux, uy] = [Math.cos(angle), Math.sin(angle)];
  const isStraight = vertices.every(
    (v) => Math.abs(ux * (ring[2 * v + 1] - meanY) - uy * (ring[2 * v] - meanX)) <= STRAIGHT,
  );
  if (!isStraight) return null;
  const last = vertices[vertices.length - 1];
  const along =
    ux * (ring[2 * vertices[0]] - ring[2 * last]) + uy * (ring[2 * vertices[0] + 1] - ring[2 * last + 1]);
  return along > 0 ? [ux, uy] : [-ux, -uy];
}

/** Whether the way from vertex k over the corner to the next vertex touches no other edge. */
function isClear(ring: Ring, k: number, [x, y]: readonly [number, number]): boolean {
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
