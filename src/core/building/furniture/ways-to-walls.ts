import { columnAt } from '../columns/height-columns.ts';
import type { RoomEdge } from '../walls/room-edges.ts';
import type { StandingPoints } from './standing-points.ts';

/** Nobody carries a scanner so low that it sees the top of what is higher than this, m … */
export const EYE_HEIGHT = 1.3;
/** … which reaches back to the wall if that is no farther than the deepest cupboard, m. */
const DEEPEST = 0.8;
/** Lower things stand before the wall if it is no farther than this, m, skirting and the wall's own points left out. */
const BEFORE_WALL = 0.15;

type Place = readonly [x: number, y: number];

/**
 * Places between a group of columns and the walls it stands before, x, y each; none where most of the floor there was seen.
 *
 * @param edges of the room
 */
export function waysToWalls(
  edges: readonly RoomEdge[],
  standing: StandingPoints,
  group: ReadonlySet<number>,
): number[] {
  const { columns, top } = standing;
  const { size, table } = columns;
  const ways: number[] = [];
  let [open, closed] = [0, 0];
  for (const c of group) {
    const [ix, iy] = table.coordinatesOf(c);
    const [x, y] = [(ix + 0.5) * size, (iy + 0.5) * size];
    const foot = footOf(edges, x, y);
    if (foot.away > (top[c] > EYE_HEIGHT ? DEEPEST : BEFORE_WALL)) continue;
    const way = wayAcross(standing, group, [x, y], foot.place);
    if (way === null) open++;
    else closed++;
    ways.push(...(way ?? []));
  }
  return closed > open ? ways : [];
}

/** The place on the nearest wall that is square to it from a place in the room; infinitely far where there is none. */
function footOf(edges: readonly RoomEdge[], x: number, y: number): { place: Place; away: number } {
  let best: { place: Place; away: number } = { place: [x, y], away: Infinity };
  for (const { ax, ay, ux, uy, length } of edges) {
    const [along, away] = [(x - ax) * ux + (y - ay) * uy, (y - ay) * ux - (x - ax) * uy];
    if (along < 0 || along > length || away < 0 || away >= best.away) continue;
    best = { place: [ax + along * ux, ay + along * uy], away };
  }
  return best;
}

/** Null where the floor was seen on the way, or something else stands there. */
function wayAcross(
  standing: StandingPoints,
  group: ReadonlySet<number>,
  from: Place,
  to: Place,
): number[] | null {
  const steps = Math.max(1, Math.ceil(Math.hypot(to[0] - from[0], to[1] - from[1]) / standing.columns.size));
  const way: number[] = [];
  for (let k = 1; k <= steps; k++) {
    const [x, y] = [from[0] + (k / steps) * (to[0] - from[0]), from[1] + (k / steps) * (to[1] - from[1])];
    const at = columnAt(standing.columns, x, y);
    // The column at the wall shows the floor of the gap before it.
    if (!group.has(at) && !isUnseen(standing, at) && k < steps - 1) return null;
    way.push(x, y);
  }
  return way;
}

/** Whether neither the floor was seen in a column nor what stands on it. */
export function isUnseen({ columns, room }: StandingPoints, c: number): boolean {
  return c < 0 || (room[c] < 0 && (columns.planes[c] & 1) === 0);
}
