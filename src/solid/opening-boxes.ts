import { combine } from '../core/geometry/areas.ts';
import { inBounds, near } from '../core/geometry/rings.ts';
import { oncePer } from '../core/once-per.ts';
import type { Opening, Polygon, Storey } from '../core/types.ts';

/** What an opening takes out of a storey's walls: a box across the wall, from jamb to jamb. */
export interface OpeningBox {
  /** Of the opening among the storey's. */
  readonly number: number;
  readonly opening: Opening;
  readonly base: Polygon;
  /** The walls about it, its own among them. */
  readonly walls: readonly Polygon[];
  /** The wall's faces, m to the left of the opening's axis; the box reaches past them. */
  readonly depth: Depth;
  /** Heights in the plan frame, m. */
  readonly low: number;
  readonly high: number;
}

/** Boxes stick out of the wall by this much, so that no cut is flush, m. */
const MARGIN = 1e-3;
/** Within an opening a curved wall leaves the straight axis by less, m. */
const BULGE = 0.25;
/** Half the width of the strip along the axis that must meet a wall for it to be the opening's own, m. */
const AXIS = 1e-3;
/** At an opening's ends a wall behind a corner may touch its own; so far from them, m, the two stand apart. */
const END = 1e-2;

/** The boxes of a storey's openings; those off every wall have none. */
export const openingBoxes = oncePer(({ floor, walls, openings }: Storey): readonly OpeningBox[] => {
  const placed = walls.map(({ outline }) => inBounds(outline));
  const reach = Math.max(0, ...walls.map(({ thickness }) => thickness)) / 2 + BULGE;
  return openings.flatMap((opening, number) => {
    const { from, to, sill, head } = opening;
    if (from[0] === to[0] && from[1] === to[1]) return [];
    const about = near(placed, strip(opening, -reach - END, reach + END));
    const depth = depthAcross(opening, about, reach);
    if (depth === null) return [];
    const base = strip(opening, depth.low - MARGIN, depth.high + MARGIN);
    return [{ number, opening, base, walls: about, depth, low: floor + sill, high: floor + head }];
  });
});

type Axis = Pick<Opening, 'from' | 'to'>;

/** As deep as the wall on the axis is there, however it bends; walls beside it and behind its corners stay whole. */
function depthAcross({ from, to }: Axis, walls: readonly Polygon[], reach: number): Depth | null {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [ex, ey] = [to[0] - from[0], to[1] - from[1]].map((d) => d * Math.min(END / length, 0.25));
  const middle: Axis = { from: [from[0] + ex, from[1] + ey], to: [to[0] - ex, to[1] - ey] };
  const own = depthOf(middle, walls, { low: -reach, high: reach });
  if (own.low >= own.high) return null;
  return depthOf({ from, to }, walls, { low: own.low - END, high: own.high + END });
}

export interface Depth {
  /** Distances to the left of an axis, m. */
  readonly low: number;
  readonly high: number;
}

/** How far the wall on an axis reaches to both its sides, looked at within a depth; inverted where there is none. */
function depthOf(opening: Axis, walls: readonly Polygon[], within: Depth): Depth {
  const { from, to } = opening;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [nx, ny] = [(from[1] - to[1]) / length, (to[0] - from[0]) / length];
  const axis = [strip(opening, -AXIS, AXIS)];
  let [low, high] = [Infinity, -Infinity];
  for (const piece of combine('intersection', walls, [strip(opening, within.low, within.high)])) {
    if (combine('intersection', [piece], axis).length === 0) continue;
    for (let i = 0; i < piece.outer.length; i += 2) {
      const aside = (piece.outer[i] - from[0]) * nx + (piece.outer[i + 1] - from[1]) * ny;
      [low, high] = [Math.min(low, aside), Math.max(high, aside)];
    }
  }
  return { low, high };
}

/** The rectangle along an opening between two distances to the left of its axis. */
function strip({ from, to }: Axis, low: number, high: number): Polygon {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [nx, ny] = [(from[1] - to[1]) / length, (to[0] - from[0]) / length];
  const outer = Float64Array.of(
    ...[from[0] + low * nx, from[1] + low * ny, to[0] + low * nx, to[1] + low * ny],
    ...[to[0] + high * nx, to[1] + high * ny, from[0] + high * nx, from[1] + high * ny],
  );
  return { outer, holes: [] };
}
