/*
 * Gift opening and its safeguard, for a newcomer.
 *
 * Lengths alone cannot tell a doorway from a niche: the edge across either is longer than the opening length, and
 * behind the doorway the ring falls into the room (a 10 × 4 m room lost 98.8 % of its area through a gap of 0.6 m).
 * What lies behind the edge can tell, so an edge short enough to be a gap is opened on trial and judged afterwards:
 *
 *   gift-opening.ts   opens edges, longest first; those up to `bridgeLimit` that lead deeper than noise go to trial
 *   trial.ts          opens all that lies behind one edge, weighs it, and keeps it or takes it back: the edge is a bridge
 *   pocket.ts         what a recess looks like from its mouth: a strip between two walls, no hollow wall, not the room
 *   opening.ts        the ring with a log, so that anything can be taken back, and the bridges found
 *   opening-point.ts  the one point an edge opens to; hull-ring.ts the linked ring, and what blocks an edge
 *   bridged-gaps.ts   afterwards: probes edges left closed, tells gaps from stray points (wall-run.ts), puts corners
 *                     back that gaps took away (gap-corner.ts), and warns
 */
import { coarsen } from './coarsen.ts';
import { EdgeHeap } from './edge-heap.ts';
import {
  firstPoint,
  type HullRing,
  isBlocked,
  lengthOf,
  ringPoints,
  startFromConvexHull,
  triangleArea,
} from './hull-ring.ts';
import { insertInto, isDeep, leaveClosed, type Opening, type OpeningRules } from './opening.ts';
import { findOpeningPoint } from './opening-point.ts';
import { unpassedPointBehind } from './passed-points.ts';
import { openOnTrial } from './trial.ts';

/**
 * Gift opening [Rosén14] §3: from the convex hull, the longest edge is opened to the inner point that sees it under
 * the smallest larger angle, while that keeps the ring simple, until no edge is longer than the opening length.
 *
 * Ours beside it: an edge short enough to be a gap in a wall (up to `bridgeLimit`) is opened on trial, see
 * {@link openOnTrial}; when the ring would fall through into the room the edge stays and is noted as a bridge. Points
 * come sorted and ties go by coordinates, so the order given does not matter.
 *
 * @param sorted distinct points in lexicographic order, not all on one line, m
 * @returns the ring, vertices among the points. About O(n + e log e) for e edges and points of even density.
 */
export function openGift(sorted: Float64Array, rules: OpeningRules): Opening {
  const hull = startFromConvexHull(sorted, rules.spacing);
  const n = hull.grid.x.length;
  const hullArea = ringArea(hull);
  const opening: Opening = {
    hull,
    anchorFrom: new Int32Array(n),
    anchorTo: new Int32Array(n),
    bridges: [],
    log: [],
    hullArea,
    area: hullArea,
  };
  for (const a of ringPoints(hull)) {
    opening.anchorFrom[a] = a;
    opening.anchorTo[a] = hull.next[a];
  }
  if (rules.bridgeLimit === 0) {
    openEdges(opening, rules, Number.POSITIVE_INFINITY);
    return opening;
  }
  openEdges(opening, { ...rules, openingLength: rules.supportLength }, Number.POSITIVE_INFINITY);
  if (rules.openingLength < rules.supportLength) openEdges(opening, rules, rules.supportLength);
  else coarsen(opening, rules);
  return opening;
}

/**
 * Opens the edges of a ring that are no longer than `longest`, the longest of them first, until none is left.
 *
 * Doubtful ones, on trial, come last: to tell whether an edge leads into the room the ring must lie at its walls.
 */
function openEdges(opening: Opening, rules: OpeningRules, longest: number): void {
  const { hull } = opening;
  const heap = new EdgeHeap(hull.grid);
  const doubtful = new EdgeHeap(hull.grid);
  for (const a of ringPoints(hull)) if (lengthOf(hull, a) <= longest) pushEdge(hull, heap, a, rules);
  for (;;) {
    let a = heap.pop();
    if (a >= 0) {
      const p = pointBehind(hull, a);
      if (p < 0) leaveClosed(opening, rules, a, heap.length);
      else if (rules.bridgeLimit > 0 && isDeep(opening, rules, a, p)) doubtful.push(a, heap.length);
      else {
        insertInto(opening, rules, a, p);
        pushEdge(hull, heap, a, rules);
        pushEdge(hull, heap, p, rules);
      }
      continue;
    }
    a = doubtful.pop();
    if (a < 0) return;
    const p = unpassedPointBehind(hull, a, rules);
    if (p < 0) leaveClosed(opening, rules, a, doubtful.length);
    else if (doubtful.length <= rules.bridgeLimit && isDeep(opening, rules, a, p))
      openOnTrial(opening, rules, a, p);
    else {
      insertInto(opening, rules, a, p);
      pushEdge(hull, heap, a, rules);
      pushEdge(hull, heap, p, rules);
    }
  }
}

/** The point the edge a → next[a] opens to, -1 when it cannot be opened. */
function pointBehind(hull: HullRing, a: number): number {
  const p = findOpeningPoint(hull, a, hull.next[a]);
  return p >= 0 && isBlocked(hull, a, p, hull.next[a]) ? -1 : p;
}

function pushEdge(hull: HullRing, heap: EdgeHeap, a: number, { openingLength }: OpeningRules): void {
  const length = lengthOf(hull, a);
  if (length > openingLength) heap.push(a, length);
}

function ringArea(hull: HullRing): number {
  const first = firstPoint(hull);
  let area = 0;
  for (let a = hull.next[first]; hull.next[a] !== first; a = hull.next[a]) {
    area += triangleArea(hull, first, a, hull.next[a]);
  }
  return area;
}
