/*
 * Gift opening and its safeguard, for a newcomer.
 *
 * Lengths alone cannot tell a doorway from a niche: the edge across either is longer than the opening length, and
 * behind the doorway the ring falls into the room (a 10 × 4 m room lost 98.8 % of its area through a gap of 0.6 m).
 * What lies behind the edge can tell. A wall's points may support the outline from one side only, so an edge opens to
 * no point of a wall the ring passes already; and an edge short enough to be a gap is opened on trial and judged.
 *
 *   gift-opening.ts   opens edges, longest first, deep ones last; those up to `bridgeLimit` go to trial
 *   passed-points.ts  the points of walls the ring passes already
 *   trial.ts          opens all that lies behind one edge, weighs it, and keeps it or takes it back: the edge is a bridge
 *   pocket.ts         what a recess looks like from its mouth: a strip between two walls, no hollow wall, not the room
 *   opening.ts        the ring with a log, so that anything can be taken back, and the bridges found
 *   opening-point.ts  the one point an edge opens to; hull-ring.ts the linked ring, and what blocks an edge
 *   bridged-gaps.ts   tells gaps from stray points (wall-run.ts), puts corners back that gaps took away
 *                     (gap-corner.ts), and warns
 *   coarsen.ts        closes again what a longer opening length leaves closed: gaps are found at one scale for all
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
 * {@link openOnTrial}; when the ring would fall through into the room the edge stays and is noted as a bridge. That is
 * settled down to `supportLength`; {@link reachOpeningLength} goes on from there. Points come sorted and ties go by
 * coordinates, so the order given does not matter.
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
  const openingLength = rules.bridgeLimit > 0 ? rules.supportLength : rules.openingLength;
  openEdges(opening, { ...rules, openingLength }, Number.POSITIVE_INFINITY);
  return opening;
}

/** Takes an opening from the scale gaps are found at to the opening length, finer or coarser. */
export function reachOpeningLength(opening: Opening, rules: OpeningRules): void {
  if (rules.bridgeLimit === 0) return;
  if (rules.openingLength < rules.supportLength) openEdges(opening, rules, rules.supportLength);
  else coarsen(opening, rules);
}

/**
 * Opens the edges of a ring that are no longer than `longest`, the longest of them first, until none is left.
 *
 * Doubtful ones come last: to tell whether an edge leads through a room the ring must lie at its walls.
 */
function openEdges(opening: Opening, rules: OpeningRules, longest: number): void {
  const { hull } = opening;
  const heap = new EdgeHeap(hull.grid);
  const doubtful = new EdgeHeap(hull.grid);
  for (const a of ringPoints(hull)) if (lengthOf(hull, a) <= longest) pushEdge(hull, heap, a, rules);
  openSureEdges(opening, rules, heap, doubtful);
  for (let a = doubtful.pop(); a >= 0; a = doubtful.pop()) {
    const p = unpassedPointBehind(hull, a, rules);
    if (p < 0) leaveClosed(opening, rules, a, doubtful.length);
    else if (doubtful.length <= rules.bridgeLimit && isDeep(opening, rules, a, p)) {
      openOnTrial(opening, rules, a, p);
    } else {
      openTo(opening, rules, heap, a, p);
      openSureEdges(opening, rules, heap, doubtful);
    }
  }
}

/** Opens the edges of a heap, longest first; those that lead deeper than noise does go to `doubtful`. */
function openSureEdges(opening: Opening, rules: OpeningRules, heap: EdgeHeap, doubtful: EdgeHeap): void {
  const { hull } = opening;
  for (let a = heap.pop(); a >= 0; a = heap.pop()) {
    const p = findOpeningPoint(hull, a, hull.next[a]);
    if (p < 0 || isBlocked(hull, a, p, hull.next[a])) leaveClosed(opening, rules, a, heap.length);
    else if (rules.bridgeLimit > 0 && isDeep(opening, rules, a, p)) doubtful.push(a, heap.length);
    else openTo(opening, rules, heap, a, p);
  }
}

function openTo(opening: Opening, rules: OpeningRules, heap: EdgeHeap, a: number, p: number): void {
  insertInto(opening, rules, a, p);
  pushEdge(opening.hull, heap, a, rules);
  pushEdge(opening.hull, heap, p, rules);
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
