import { type HullRing, insertPoint, lengthOf, removePoint, triangleArea } from './hull-ring.ts';

/** Depth up to which an opening only follows the noise of a wall, m: three deviations of a hand-held scanner. */
export const NOISE_DEPTH = 0.06;
/** The same in mean spacings, for sparse slices. */
const NOISE_SPACINGS = 2;
/** An edge that keeps this share of the edge it came from only crept on; its depth is counted from where it began. */
const CREEPING_SHARE = 0.7;

/** Lengths that steer an opening, m. */
export interface OpeningRules {
  /** Edges longer than this are opened. */
  readonly openingLength: number;
  /** Longest step between neighbours along a scanned wall. */
  readonly supportLength: number;
  /** Edges up to this long are opened on trial; 0 opens all at once, as the paper does. */
  readonly bridgeLimit: number;
  /** Mean distance to the nearest neighbour. */
  readonly spacing: number;
}

/** A ring while it is opened. */
export interface Opening {
  readonly hull: HullRing;
  /** For each edge the one its depth is counted from, as two points. */
  readonly anchorFrom: Int32Array;
  readonly anchorTo: Int32Array;
  /** Edges where the ring would have fallen through a gap: pairs of points. */
  readonly bridges: number[];
  /** Every insertion, to take it back: the point and the anchor of the edge it split. */
  readonly log: number[];
  /** Area of the convex hull, m². */
  readonly hullArea: number;
  /** Area the ring encloses, m². */
  area: number;
}

/** How far noise may put a point off its wall. */
export function noiseDepth({ spacing }: OpeningRules): number {
  return Math.max(NOISE_DEPTH, NOISE_SPACINGS * spacing);
}

/** Whether p lies deeper behind the edge a → next[a], or behind the edge that one crept on from, than noise does. */
export function isDeep(opening: Opening, rules: OpeningRules, a: number, p: number): boolean {
  const { hull, anchorFrom, anchorTo } = opening;
  const limit = noiseDepth(rules);
  if (depthOf(hull, a, hull.next[a], p) > limit) return true;
  return depthOf(hull, anchorFrom[a], anchorTo[a], p) > limit;
}

/**
 * Leaves the edge a → next[a] closed, and notes it as a bridge when it is longer than steps along a wall are.
 *
 * @returns the length no points support, beyond a step along a wall
 */
export function leaveClosed(opening: Opening, rules: OpeningRules, a: number, length: number): number {
  if (length <= rules.supportLength) return 0;
  if (length <= rules.bridgeLimit) opening.bridges.push(a, opening.hull.next[a]);
  return length - rules.supportLength;
}

/** Puts p between a and next[a]. */
export function insertInto(opening: Opening, { bridgeLimit }: OpeningRules, a: number, p: number): void {
  const { hull, anchorFrom, anchorTo } = opening;
  const length = lengthOf(hull, a);
  const from = anchorFrom[a];
  const to = anchorTo[a];
  opening.log.push(p, from, to);
  opening.area -= triangleArea(hull, a, hull.next[a], p);
  insertPoint(hull, a, p);
  for (const edge of [a, p]) {
    const isCreeping = length <= bridgeLimit && lengthOf(hull, edge) > CREEPING_SHARE * length;
    anchorFrom[edge] = isCreeping ? from : edge;
    anchorTo[edge] = isCreeping ? to : hull.next[edge];
  }
}

/** Undoes insertions down to a mark in the log. */
export function takeBack(opening: Opening, mark: number): void {
  const { hull, log, anchorFrom, anchorTo } = opening;
  while (log.length > mark) {
    const to = log.pop()!;
    const from = log.pop()!;
    const p = log.pop()!;
    const a = hull.previous[p];
    opening.area += triangleArea(hull, a, hull.next[p], p);
    removePoint(hull, p);
    anchorFrom[a] = from;
    anchorTo[a] = to;
  }
}

/** Distance of p from the line a → b, to its left. */
export function depthOf({ grid: { x, y } }: HullRing, a: number, b: number, p: number): number {
  const ux = x[b] - x[a];
  const uy = y[b] - y[a];
  return (ux * (y[p] - y[a]) - uy * (x[p] - x[a])) / Math.sqrt(ux * ux + uy * uy);
}
