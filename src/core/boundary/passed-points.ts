import { type HullRing, isBlocked, lengthOf } from './hull-ring.ts';
import type { OpeningRules } from './opening.ts';
import { findOpeningPoint } from './opening-point.ts';

/** No room is narrower than this, m: what lies nearer behind a wall is its noise or its other face. */
const NARROWEST_ROOM = 0.2;
/** Depths of points on an edge come out this far off, m. */
const ROUNDING = 1e-9;

/** The point the edge a → next[a] opens to that the ring does not pass already; -1 when there is none. */
export function unpassedPointBehind(hull: HullRing, a: number, { supportLength }: OpeningRules): number {
  const look = { opened: a, longest: supportLength };
  let p = findOpeningPoint(hull, a, hull.next[a]);
  if (p >= 0 && isPassed(hull, p, look))
    p = findOpeningPoint(hull, a, hull.next[a], (q) => isPassed(hull, q, look));
  return p >= 0 && isBlocked(hull, a, p, hull.next[a]) ? -1 : p;
}

interface Look {
  /** The edge to be opened: what lies behind it, or in the wedge at its ends, it may well take in. */
  readonly opened: number;
  /** Longest edge that follows a wall, m. */
  readonly longest: number;
}

/**
 * Whether the ring passes point p already: p lies behind an edge, on its inner side, nearer than any room is wide.
 *
 * Such a point is of the wall the edge follows. A ring that took it in would have that wall between two outsides: it
 * would lead through a room, not around it.
 */
function isPassed(hull: HullRing, p: number, look: Look): boolean {
  const { next, edges } = hull;
  const { x, y } = hull.grid;
  const count = edges.around(x[p], y[p], NARROWEST_ROOM);
  for (let k = 0; k < count; k++) {
    const a = edges.u[edges.found[k]];
    if (a === look.opened || next[a] !== edges.v[edges.found[k]]) continue;
    if (isBehind(hull, a, p, look)) return true;
  }
  return false;
}

/** Whether p lies just behind the edge a → next[a], or in the wedge between it and an edge that turns away from p. */
function isBehind(hull: HullRing, a: number, p: number, { opened, longest }: Look): boolean {
  const { next, previous } = hull;
  const { x, y } = hull.grid;
  const b = next[a];
  const ux = x[b] - x[a];
  const uy = y[b] - y[a];
  const dx = x[p] - x[a];
  const dy = y[p] - y[a];
  const length = Math.sqrt(ux * ux + uy * uy);
  const depth = (dy * ux - dx * uy) / length;
  if (length > longest || depth < -ROUNDING || depth > NARROWEST_ROOM) return false;
  const along = (dx * ux + dy * uy) / length;
  if (along >= 0 && along <= length) return true;
  const beyond = along < 0 ? -along : along - length;
  if (beyond * beyond + depth * depth > NARROWEST_ROOM * NARROWEST_ROOM) return false;
  const [from, at, to] = along < 0 ? [previous[a], a, b] : [a, b, next[b]];
  if (from === opened || at === opened) return false;
  const isSettled = lengthOf(hull, along < 0 ? from : at) <= longest;
  return isSettled && (x[at] - x[from]) * (y[to] - y[at]) - (y[at] - y[from]) * (x[to] - x[at]) < 0;
}
