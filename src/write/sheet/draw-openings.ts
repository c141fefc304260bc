import { type Affine, mapped, type SheetItem } from '../../core/sheet.ts';
import type { Opening, Storey } from '../../core/types.ts';
import { type Depth, type OpeningBox, openingBoxes } from '../../solid/opening-boxes.ts';
import { jambDepths } from '../jamb-depths.ts';

/** Decimals of plan metres in data attributes: 0.1 mm. */
const DIGITS = 4;

/**
 * Draws openings in the walls: thin lines across the wall at both jambs, and between them for a door a thin line, since
 * nobody knows the hinge side, for a window a line on either face and one in the middle, and for a passage, whose head is
 * above the plan's cut, dashed lines on the faces.
 */
export function drawOpenings(storey: Storey, planToSheet: Affine): SheetItem[] {
  return openingBoxes(storey).flatMap((box): SheetItem[] => {
    const { number: i, opening } = box;
    const jambs = jambsOf(box);
    const [drawn, dashed] = betweenJambs(opening, jambs);
    const path = (style: 'opening' | 'passage', lines: readonly Float64Array[]) => ({
      kind: 'path' as const,
      style,
      lines: lines.map((line) => mapped(line, planToSheet)),
      isClosed: false,
    });
    const data = { kind: opening.type, opening: i, ...placeData(opening) };
    const items: SheetItem[] = [{ ...path('opening', [...jambs, ...drawn]), id: `opening-${i}`, data }];
    return dashed.length > 0 ? [...items, path('passage', dashed)] : items;
  });
}

/** Lines from jamb to jamb, whole ones and dashed ones. */
function betweenJambs(
  { type, from, to }: Opening,
  [left, right]: readonly [Float64Array, Float64Array],
): [drawn: Float64Array[], dashed: Float64Array[]] {
  if (type === 'door') return [[Float64Array.of(...from, ...to)], []];
  // Jambs run from one face of the wall to the other, both the same way.
  const at = (share: number) => [
    ...[left[0] + share * (left[2] - left[0]), left[1] + share * (left[3] - left[1])],
    ...[right[0] + share * (right[2] - right[0]), right[1] + share * (right[3] - right[1])],
  ];
  const lines = (shares: readonly number[]) => shares.map((share) => Float64Array.from(at(share)));
  return type === 'window' ? [lines([0, 0.5, 1]), []] : [[], lines([0, 1])];
}

/** Where a stretch of wall starts and ends, plan metres, for scripts. */
export function placeData({ from, to }: Pick<Opening, 'from' | 'to'>): Record<'from' | 'to', string> {
  const text = (place: readonly number[]) => place.map((value) => Number(value.toFixed(DIGITS))).join(' ');
  return { from: text(from), to: text(to) };
}

/** Across the wall at the two ends of an opening, as deep as the wall is there. */
function jambsOf(box: OpeningBox): readonly [Float64Array, Float64Array] {
  const { from, to } = box.opening;
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  const [ux, uy] = [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
  const across = ([x, y]: Opening['from'], { low, high }: Depth) =>
    Float64Array.of(x - low * uy, y + low * ux, x - high * uy, y + high * ux);
  const [left, right] = jambDepths(box);
  return [across(from, left), across(to, right)];
}
