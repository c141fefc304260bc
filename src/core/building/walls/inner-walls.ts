import { areaOf, combine, grow } from '../../geometry/areas.ts';
import { centroid } from '../../geometry/rings.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { Gap, Polygon, Wall } from '../../types.ts';
import type { FacePair } from './pair-faces.ts';
import { validParts } from './valid-parts.ts';

/** A wall's strip reaches so far into the rooms beside it, m. */
const STRIP_MARGIN = 0.005;
/** Half the width of what is no wall but rounding, m. */
const SLIVER = 0.001;
/** Leftovers of walls smaller than this are debris, m². */
const DEBRIS = 1e-4;

/**
 * The walls between rooms: the area of the outline that is no room, cut into one piece a pair of faces.
 *
 * Where the strips of two pairs cross, the first has what they share, so that walls do not overlap; what no strip covers, the
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
  const pieces = cutApart(solid, pairs.map(pairRing));
  const rest = withoutSlivers(combine('difference', solid, pieces.flat()));
  for (const leftover of rest) {
    if (areaOf([leftover]) < DEBRIS) continue;
    const near = nearestPiece(leftover, pieces);
    if (near >= 0) pieces[near] = joined(pieces[near], leftover);
  }
  return pieces.flatMap((piece, i) =>
    validParts(piece).map((outline): Wall => {
      const { face, back, thickness } = pairs[i];
      const hidden = [face, back].every(({ owner }) => unseen[owner].some((gap) => touches(gap, pairs[i])));
      return { outline, thickness, confidence: hidden ? 0.5 : 1 };
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
  const whole = combine('union', [...piece, leftover]);
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

/** The strip of a wall, a little wider than it is: what is cut out of the area between rooms then leaves no slivers. */
function pairRing({ face, back, from, to }: FacePair): Float64Array {
  const onFace = (along: number, out: number) => [
    face.ax + along * face.ux + out * face.uy,
    face.ay + along * face.uy - out * face.ux,
  ];
  const onBack = (along: number) => {
    const [x, y] = onFace(along, 0);
    const t = (x - back.ax) * back.ux + (y - back.ay) * back.uy;
    // Away from the room behind is towards the face.
    return [back.ax + t * back.ux - STRIP_MARGIN * back.uy, back.ay + t * back.uy + STRIP_MARGIN * back.ux];
  };
  // The room is on the face's left, so the wall is on its right.
  return Float64Array.from(
    [onFace(from, -STRIP_MARGIN), onBack(from), onBack(to), onFace(to, -STRIP_MARGIN)].flat(),
  );
}
