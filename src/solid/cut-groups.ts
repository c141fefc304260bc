import { combine } from '../core/geometry/areas.ts';
import { type Bounds, boundsMeet, boundsOf, inBounds, near } from '../core/geometry/rings.ts';
import type { Polygon } from '../core/types.ts';
import { rootOf, separateSets, unite } from '../core/union-find.ts';
import type { OpeningBox } from './opening-boxes.ts';

/** Boxes around areas that rounding alone keeps apart meet, m. */
const ROUNDING = 1e-5;

/** What an opening takes out of a part between two heights. */
interface Cut {
  readonly base: readonly Polygon[];
  readonly low: number;
  readonly high: number;
}

/** Cuts at one place: no other's box meets one of theirs. */
export interface CutGroup {
  readonly cuts: readonly Cut[];
  readonly boxes: readonly Bounds[];
}

/**
 * Openings by their places, each less what stands in its way. n log n for places that few others lie beside.
 *
 * @returns in the order of their first openings
 */
export function groupCuts(openings: readonly OpeningBox[], inTheWay: readonly Polygon[]): CutGroup[] {
  const obstacles = inTheWay.map(inBounds);
  const boxes = openings.map(({ base }) => grown(boundsOf(base.outer), ROUNDING));
  const groups = new Map<number, { cuts: Cut[]; boxes: Bounds[] }>();
  const sets = meetingSets(boxes);
  openings.forEach(({ base, low, high }, i) => {
    const root = rootOf(sets, i);
    const group = groups.get(root) ?? { cuts: [], boxes: [] };
    groups.set(root, group);
    const before = near(obstacles, base);
    group.cuts.push({ base: before.length > 0 ? combine('difference', [base], before) : [base], low, high });
    group.boxes.push(boxes[i]);
  });
  return [...groups.values()];
}

/** The areas that are cut away by those of a group's cuts that are open at a height. */
export function openAt({ cuts }: Pick<CutGroup, 'cuts'>, z: number): Polygon[] {
  return cuts.flatMap(({ base, low, high }) => (low < z && z < high ? base : []));
}

/** Those pieces of an area cut out by all groups that lie in each. */
export function piecesByGroup(pieces: readonly Polygon[], groups: readonly CutGroup[]): Polygon[][] {
  const bounded = pieces.map(inBounds);
  return groups.map(({ boxes }) =>
    bounded.filter(({ bounds }) => boxes.some((box) => boundsMeet(box, bounds))).map(({ area }) => area),
  );
}

export const grown = ({ minX, minY, maxX, maxY }: Bounds, by: number): Bounds => ({
  minX: minX - by,
  minY: minY - by,
  maxX: maxX + by,
  maxY: maxY + by,
});

/** Boxes in sets, of which none meets a box of another. */
function meetingSets(boxes: readonly Bounds[]): Uint32Array {
  const sets = separateSets(boxes.length);
  const fromLeft = boxes.map((_, i) => i).sort((a, b) => boxes[a].minX - boxes[b].minX || a - b);
  let open: number[] = [];
  for (const i of fromLeft) {
    open = open.filter((k) => boxes[k].maxX >= boxes[i].minX);
    for (const k of open) if (boundsMeet(boxes[k], boxes[i])) unite(sets, k, i);
    open.push(i);
  }
  return sets;
}
