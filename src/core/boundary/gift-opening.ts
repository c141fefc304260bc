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
import { EdgeHeap } from './edge-heap.ts';
import {
  firstPoint,
  type HullRing,
  isBlocked,
  lengthOf,
  startFromConvexHull,
  triangleArea,
} from './hull-ring.ts';
import { insertInto, isDeep, leaveClosed, type Opening, type OpeningRules, takeBack } from './opening.ts';
import { findOpeningPoint } from './opening-point.ts';
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
  const heap = new EdgeHeap(hull.grid);
  const first = firstPoint(hull);
  let a = first;
  do {
    opening.anchorFrom[a] = a;
    opening.anchorTo[a] = hull.next[a];
    pushEdge(hull, heap, a, rules);
    a = hull.next[a];
  } while (a !== first);
  openEdges(opening, rules, heap);
  opening.log.length = 0;
  return opening;
}

/**
 * Opens one edge of a finished ring by stricter rules, and takes that back unless it shows a gap: its ends are then
 * worth more than a long edge.
 */
export function probeEdge(opening: Opening, rules: OpeningRules, a: number): void {
  const { hull, log, bridges } = opening;
  const heap = new EdgeHeap(hull.grid);
  const bridged = bridges.length;
  opening.anchorFrom[a] = a;
  opening.anchorTo[a] = hull.next[a];
  pushEdge(hull, heap, a, rules);
  openEdges(opening, rules, heap);
  if (bridges.length === bridged) takeBack(opening, 0);
  log.length = 0;
}

/** Opens the edges of a heap, longest first, until none is left. */
function openEdges(opening: Opening, rules: OpeningRules, heap: EdgeHeap): void {
  const { hull } = opening;
  for (let a = heap.pop(); a >= 0; a = heap.pop()) {
    const p = findOpeningPoint(hull, a, hull.next[a]);
    if (p < 0 || isBlocked(hull, a, p, hull.next[a])) {
      leaveClosed(opening, rules, a, heap.length);
      continue;
    }
    if (heap.length <= rules.bridgeLimit && isDeep(opening, rules, a, p)) {
      openOnTrial(opening, rules, a, p);
      continue;
    }
    insertInto(opening, rules, a, p);
    pushEdge(hull, heap, a, rules);
    pushEdge(hull, heap, p, rules);
  }
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
