import { countOf } from '../../core/count-words.ts';
import { areaOf, combine } from '../../core/geometry/areas.ts';
import { boundsOfAll, ringsOf } from '../../core/geometry/rings.ts';
import type { StageResults } from '../../core/stage-results.ts';
import type { SecondaryBoundary, Storey } from '../../core/types.ts';
import { wallSection } from '../../solid/sections.ts';
import { hatch } from '../sheet/hatch.ts';
import { HATCHES } from '../sheet/secondary-hatch.ts';
import { path } from './marks.ts';
import { gapMarks, mappedRings } from './outline-pictures.ts';
import type { Drawing } from './page.ts';
import { ACCENT, AMBER, INK } from './palette.ts';
import { type TopView, topView } from './top-view.ts';

/** The hatches' spacing is in mm on a sheet; a picture shows them in px. */
const PIXELS_PER_MM = 3;
const OPERATION_WORDS = { subtract: 'subtracted', add: 'added', independent: 'independent' } as const;

/** Fig. 1b: walls filled, secondary boundaries hatched by what they do to the model. The lowest storey. */
export function drawPlan({ plan }: Partial<StageResults>): Drawing | null {
  const storey = plan?.storeys[0];
  if (plan === undefined || storey === undefined) return null;
  const { primary, secondary, gaps, walls } = storey;
  const outlines = secondary.map(({ outline }) => outline);
  const section = combine('difference', wallSection(storey), outlines);
  const shown = [...section, ...primary, ...outlines];
  if (shown.length === 0) return null;
  const view = topView(boundsOfAll(ringsOf(shown)));
  const thickness = Math.max(0, ...walls.map((wall) => wall.thickness));
  return {
    height: view.height,
    pixelsPerMetre: view.pixelsPerMetre,
    items: [
      path(mappedRings(section, view), true, { id: 'walls', fill: INK, 'fill-rule': 'evenodd' }),
      ...secondary.flatMap((boundary, i) => secondaryMarks(boundary, i, view)),
      ...gapMarks(gaps, view),
    ],
    counts: [
      ...(plan.storeys.length === 1 ? [] : [`storey 0 of ${plan.storeys.length}`]),
      `${areaOf(combine('union', primary)).toFixed(1)} m²`,
      `walls ${thickness.toFixed(2)} × ${storey.height.toFixed(2)} m`,
      ...operationCounts(secondary),
    ],
    legend: gaps.length === 0 ? [] : [{ colour: AMBER, label: gapWords(storey) }],
  };
}

/** Of rooms nothing is bridged: what nobody saw is there all the same. */
function gapWords({ gaps, rooms }: Storey): string {
  return rooms.length > 0
    ? countOf(gaps.length, 'inferred stretch', 'inferred stretches')
    : countOf(gaps.length, 'bridged gap');
}

function secondaryMarks({ outline, operation }: SecondaryBoundary, i: number, view: TopView): string[] {
  const rings = mappedRings([outline], view);
  const lines = HATCHES[operation].flatMap(({ angle, spacing }) =>
    hatch(rings, angle, PIXELS_PER_MM * spacing),
  );
  return [
    path(lines, false, { fill: 'none', stroke: ACCENT, 'stroke-width': 0.7 }),
    path(rings, true, { id: `secondary-${i}`, fill: 'none', stroke: ACCENT, 'stroke-width': 1.6 }),
  ];
}

function operationCounts(secondary: readonly SecondaryBoundary[]): string[] {
  return (['subtract', 'add', 'independent'] as const).flatMap((operation) => {
    const count = secondary.filter((boundary) => boundary.operation === operation).length;
    return count === 0 ? [] : [`${count} ${OPERATION_WORDS[operation]}`];
  });
}
