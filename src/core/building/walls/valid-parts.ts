import { combine, grow } from '../../geometry/areas.ts';
import { perimeter, signedArea } from '../../geometry/rings.ts';
import { conflictingEdges } from '../../geometry/simplicity.ts';
import type { Polygon } from '../../types.ts';
import { withoutDebris } from './primary-outline.ts';

/** Half the width of what an area loses where it hangs together by less, m. */
const HAIR = 0.001;
/** So much less is given back, m, that what touched in a point does so no more: more than coordinates are rounded by. */
const GAP = 0.0002;
/** Parts narrower than this over all their length are rounding, m. */
const DEBRIS_WIDTH = 0.003;

/**
 * Areas as polygons that stand each for itself: rings simple and apart, no spikes, no part hanging on another by a point.
 *
 * Those that are so stay as they are but for needless vertices. The others lose what is thinner than a hair: shrunk by
 * half of that and grown back by a little less they come apart where they touched.
 */
export function validParts(areas: readonly Polygon[]): Polygon[] {
  return areas.flatMap((area) => {
    const plain = plainer(area);
    return isValid(plain) ? [plain] : opened(area);
  });
}

/** Whether a polygon's rings are simple and do not meet, not in a point either. */
export function isValid({ outer, holes }: Polygon): boolean {
  const rings = [outer, ...holes];
  if (conflictingEdges(rings).length > 0) return false;
  if (holes.length === 0) return true;
  const places = rings.flatMap((ring) =>
    Array.from({ length: ring.length / 2 }, (_, i) => `${ring[2 * i]} ${ring[2 * i + 1]}`),
  );
  return new Set(places).size === places.length;
}

function plainer({ outer, holes }: Polygon): Polygon {
  return { outer: withoutDebris(outer), holes: holes.map(withoutDebris) };
}

function opened(area: Polygon): Polygon[] {
  const shrunk = grow([area], -HAIR);
  return combine('intersection', grow(shrunk, HAIR - GAP), [area])
    .map((part) => (isValid(plainer(part)) ? plainer(part) : part))
    .filter((part) => isValid(part) && 2 * signedArea(part.outer) > DEBRIS_WIDTH * perimeter(part.outer));
}
