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
