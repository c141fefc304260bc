import { polygonArea } from '../core/geometry/rings.ts';
import { conflictingEdges } from '../core/geometry/simplicity.ts';
import type { FloorPlan, Polygon, Warning } from '../core/types.ts';

/** Less than this is no area, m²: a square of a millimetre. */
const NO_AREA = 1e-6;
/** So many places are named. */
const NAMED = 3;

/** Outlines of a plan from outside that files cannot hold as they are: without area, or crossing themselves. */
export function unsoundOutlines({ storeys }: FloorPlan): readonly Warning[] {
  const places = storeys.flatMap(({ primary, rooms, walls, secondary }, i) => [
    ...unsoundOf(primary, `storeys[${i}].primary`),
    ...Object.entries({ rooms, walls, secondary }).flatMap(([name, parts]) =>
      unsoundOf(
        parts.map(({ outline }) => outline),
        `storeys[${i}].${name}`,
      ),
    ),
  ]);
  if (places.length === 0) return [];
  const named = places.slice(0, NAMED).join(', ');
  const more = places.length > NAMED ? ` and ${places.length - NAMED} more` : '';
  return [
    {
      code: 'plan/unsound-outline',
      message: `The plan has outlines without area, or that cross themselves: ${named}${more}. Files leave them out, or hold what of them is sound.`,
      hint: 'Mend these outlines in the plan.',
    },
  ];
}

function unsoundOf(outlines: readonly Polygon[], list: string): string[] {
  return outlines.flatMap((outline, k) => (isSound(outline) ? [] : [`${list}[${k}]`]));
}

function isSound(outline: Polygon): boolean {
  return (
    Math.abs(polygonArea(outline)) > NO_AREA &&
    conflictingEdges([outline.outer, ...outline.holes]).length === 0
  );
}
