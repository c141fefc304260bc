import { combine } from '../core/geometry/areas.ts';
import type { Opening, Polygon, Storey } from '../core/types.ts';
import { openingBoxes } from '../solid/opening-boxes.ts';
import { type Affine, mapped, type SheetItem } from './sheet.ts';

/** Decimals of plan metres in data attributes: 0.1 mm. */
const DIGITS = 4;
/** A corner of the hole this near the end of an opening is the jamb's, m: the Booleans' rounding and more. */
const AT_JAMB = 1e-4;

/**
 * Draws openings in the walls: thin lines across the wall at both jambs, and for a door a thin line from jamb to jamb,
 * since nobody knows the hinge side.
 */
export function drawOpenings(storey: Storey, planToSheet: Affine): SheetItem[] {
  const walls = storey.walls.map(({ outline }) => outline);
  return storey.openings.flatMap((opening, i): SheetItem[] => {
    const [box] = openingBoxes({ ...storey, openings: [opening] });
    if (box === undefined) return [];
    const hole = combine('intersection', walls, [box.base]);
    const leaf = opening.type === 'door' ? [Float64Array.of(...opening.from, ...opening.to)] : [];
    const lines = [...jambsOf(hole, opening), ...leaf].map((line) => mapped(line, planToSheet));
    const data = { kind: opening.type, opening: i, ...placeData(opening) };
    return [{ kind: 'path', style: 'opening', lines, isClosed: false, id: `opening-${i}`, data }];
  });
}

/** Where a stretch of wall starts and ends, plan metres, for scripts. */
export function placeData({ from, to }: Pick<Opening, 'from' | 'to'>): Record<'from' | 'to', string> {
  const text = (place: readonly number[]) => place.map((value) => Number(value.toFixed(DIGITS))).join(' ');
  return { from: text(from), to: text(to) };
}

/** Across the wall at the two ends of an opening, as deep as the wall is there. */
function jambsOf(hole: readonly Polygon[], { from, to }: Opening): Float64Array[] {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  return [0, length].flatMap((end) => {
    let [low, high] = [Infinity, -Infinity];
    for (const { outer } of hole) {
      for (let i = 0; i < outer.length; i += 2) {
        const [x, y] = [outer[i] - from[0], outer[i + 1] - from[1]];
        if (Math.abs(x * ux + y * uy - end) > AT_JAMB) continue;
        const aside = ux * y - uy * x;
        [low, high] = [Math.min(low, aside), Math.max(high, aside)];
      }
    }
    const at = (aside: number) => [from[0] + end * ux - aside * uy, from[1] + end * uy + aside * ux];
    return low < high ? [Float64Array.of(...at(low), ...at(high))] : [];
  });
}
