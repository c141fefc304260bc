import { areaOf, combine, grow } from '../../geometry/areas.ts';
import { circlesOf, withArcs } from '../../geometry/ring-arcs.ts';
import { centroid } from '../../geometry/rings.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { Gap, Polygon, Wall } from '../../types.ts';
import type { FacePair } from './pair-faces.ts';
import { validParts } from './valid-parts.ts';
import { wallStrips } from './wall-strips.ts';

/** Half the width of what is no wall but rounding, m. */
const SLIVER = 0.001;
/** Half the width of a crack between pieces of one wall: more than rounding leaves, m. */
const CRACK = 1e-5;
/** Leftovers of walls smaller than this are debris, m². */
const DEBRIS = 1e-4;

/**
 * The walls between rooms: the area of the outline that is no room, cut into one piece a pair of faces, or of curves.
 *
 * Where the strips of two cross, the first has what they share, so that walls do not overlap; what no strip covers, the
 * crossings of walls, goes to the nearest.
 *
 * @param unseen stretches that no point supports, a list a room
 */
export function innerWalls(
  rooms: readonly Polygon[],
  primary: readonly Polygon[],
  pairs: readonly FacePair[],
  unseen: readonly (readonly Gap[])[],
): Wall[] {
  const solid = withoutSlivers(combine('difference', primary, rooms));
  const strips = wallStrips(pairs);
  const pieces = cutApart(
    solid,
    strips.map(({ ring }) => ring),
  );
  // Hairlines along the pieces, some of them folded back on themselves, would be in the way of what is left.
  const rest = withoutSlivers(combine('difference', solid, grow(pieces.flat(), CRACK)));
  for (const leftover of rest) {
    if (areaOf([leftover]) < DEBRIS) continue;
    const near = nearestPiece(leftover, pieces);
    if (near >= 0) pieces[near] = joined(pieces[near], leftover);
  }
  const circles = rooms.flatMap(circlesOf);
  return pieces.flatMap((piece, i) =>
    validParts(piece).map((outline): Wall => {
      const { pairs: own, thickness } = strips[i];
      const hidden = (['face', 'back'] as const).every((side) =>
        own.some((pair) => unseen[pair[side].owner].some((gap) => touches(gap, pair))),
      );
      return { outline: withArcs(outline, circles), thickness, confidence: hidden ? 0.5 : 1 };
    }),
  );
}

/** What of an area is in each strip and in none before it. */
function cutApart(solid: readonly Polygon[], strips: readonly Float64Array[]): Polygon[][] {
  const areas = strips.map((outer): Polygon => ({ outer, holes: [] }));
  return areas.map((strip, i) => {
    const within = combine('intersection', solid, [strip]);
    return withoutSlivers(combine('difference', within, areas.slice(0, i)));
  });
}

/** Areas without what is narrower than a hair: what rounding left along their edges. */
function withoutSlivers(areas: readonly Polygon[]): Polygon[] {
  return combine('intersection', areas, grow(grow(areas, -SLIVER), SLIVER));
}

/** A wall's pieces with one more, joined where that makes one without a hole. */
function joined(piece: readonly Polygon[], leftover: Polygon): Polygon[] {
  const union = combine('union', [...piece, leftover]);
  const whole = union.length > piece.length ? grow(grow(union, CRACK), -CRACK) : union;
  return whole.every(({ holes }) => holes.length === 0) ? whole : [...piece, leftover];
}

function touches({ from, to }: Gap, { face, thickness }: FacePair): boolean {
  return [from, to].every(([x, y]) => {
    const aside = (x - face.ax) * face.uy - (y - face.ay) * face.ux;
    return aside > -0.01 && aside < thickness + 0.01;
  });
}

function nearestPiece(leftover: Polygon, pieces: readonly (readonly Polygon[])[]): number {
  const [x, y] = centroid(leftover.outer);
  let [best, least] = [-1, Infinity];
  pieces.forEach((piece, i) => {
    for (const { outer } of piece) {
      const away = distanceToRing(x, y, outer);
      if (away < least) [best, least] = [i, away];
    }
  });
  return best;
}
