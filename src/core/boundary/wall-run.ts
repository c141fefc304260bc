import type { HullRing } from './hull-ring.ts';

/** How far beside an edge its walls are looked at, m and vertices; the first one counts at any distance. */
const FARTHEST = 0.5;
const VERTICES = 8;
/** Nearer vertices say nothing of a wall's direction, m, and are not counted. */
const NEAREST = 0.06;

/**
 * Whether the ring runs on at both ends of the edge a → next[a] in about its direction, as beside a gap in a wall.
 *
 * @param leastCosine of the turn between a wall and the edge
 */
export function continuesWalls(hull: HullRing, a: number, leastCosine: number): boolean {
  const b = hull.next[a];
  return runsOn(hull, hull.previous, b, a, leastCosine) && runsOn(hull, hull.next, a, b, leastCosine);
}

/** Whether some vertex a little beyond `to`, found by `step`, lies about on from `from` to `to`. */
function runsOn(
  { grid: { x, y } }: HullRing,
  step: Int32Array,
  from: number,
  to: number,
  leastCosine: number,
): boolean {
  const ux = x[to] - x[from];
  const uy = y[to] - y[from];
  const length = Math.sqrt(ux * ux + uy * uy);
  let distance = 0;
  for (let q = step[to], seen = 0; seen < VERTICES && q !== from && distance <= FARTHEST; q = step[q]) {
    const dx = x[q] - x[to];
    const dy = y[q] - y[to];
    distance = Math.sqrt(dx * dx + dy * dy);
    if (distance < NEAREST) continue;
    seen++;
    if (dx * ux + dy * uy >= leastCosine * distance * length) return true;
  }
  return false;
}
