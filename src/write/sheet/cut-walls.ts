import { combine } from '../../core/geometry/areas.ts';
import { inBounds, near, orientRing } from '../../core/geometry/rings.ts';
import type { Gap, Polygon, Storey } from '../../core/types.ts';
import { openingsAtCut } from '../../solid/sections.ts';

/** A gap is cut out of walls up to this much thicker than they are said to be, so that rounding leaves no sliver. */
const GAP_OVERLAP = 1.02;

/** Walls as a drawn plan shows them. */
export interface CutWalls {
  /** Disjoint; openings, secondary boundaries and inferred stretches are left free. */
  readonly cut: readonly Polygon[];
  /** Stretches of wall along gaps, which no point supports, with the number of the gap. */
  readonly inferred: readonly { readonly polygon: Polygon; readonly gap: number }[];
}

/** Cuts a storey's walls a metre above the floor and parts what was seen from what was inferred. */
export function cutWalls(storey: Storey): CutWalls {
  const section = combine(
    'difference',
    storey.walls.map(({ outline }) => outline),
    [...storey.secondary.map(({ outline }) => outline), ...openingsAtCut(storey)],
  );
  const thickness = Math.max(0, ...storey.walls.map((wall) => wall.thickness));
  const stretches = storey.gaps.map((gap) => stretchOf(gap, thickness * GAP_OVERLAP));
  const standing = section.map(inBounds);
  return {
    cut: stretches.length === 0 ? section : combine('difference', section, stretches),
    inferred: stretches.flatMap((stretch, gap) =>
      combine('intersection', near(standing, stretch), [stretch]).map((polygon) => ({ polygon, gap })),
    ),
  };
}

/** The rectangle along a gap, as wide as the wall to both sides. */
function stretchOf({ from, to }: Gap, reach: number): Polygon {
  const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
  const length = Math.hypot(dx, dy);
  if (length === 0) return { outer: new Float64Array(0), holes: [] };
  const [nx, ny] = [(-dy / length) * reach, (dx / length) * reach];
  const outer = Float64Array.of(
    ...[from[0] - nx, from[1] - ny, to[0] - nx, to[1] - ny],
    ...[to[0] + nx, to[1] + ny, from[0] + nx, from[1] + ny],
  );
  return { outer: orientRing(outer, 'counter-clockwise'), holes: [] };
}
