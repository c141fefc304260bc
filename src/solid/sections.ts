import { combine, withoutHairlines } from '../core/geometry/areas.ts';
import { polygonArea } from '../core/geometry/rings.ts';
import { oncePer } from '../core/once-per.ts';
import type { Polygon, SecondaryBoundary, Storey } from '../core/types.ts';
import { openingBoxes } from './opening-boxes.ts';
import { separatePinches } from './pinches.ts';
import { shareVertices } from './share-vertices.ts';

/** Walls whose pieces stand nearer than this are one, m: the pieces are rounded each by itself. */
const HAIRLINE = 0.002;
/** A plan is cut this far above the floor, m: through doors and most windows. */
const CUT_HEIGHT = 1;

/**
 * Cross-section of a storey's walls a metre above the floor, openings cut, once secondary boundaries are carved out or
 * added: disjoint polygons, metres.
 */
export function wallSection(storey: Storey): Polygon[] {
  const open = openingsAtCut(storey);
  return carve(combine('difference', wallArea(storey), open), storey.secondary);
}

/** All walls of a storey in one, without the hairlines between pieces that were cut apart. */
export const wallArea = oncePer(({ walls }: Storey) =>
  withoutHairlines(unite(walls.map(({ outline }) => outline)), HAIRLINE),
);

/** What openings take out of the walls in the cross-section. */
export const openingsAtCut = oncePer((storey: Storey) => {
  const cut = storey.floor + CUT_HEIGHT;
  const open = openingBoxes(storey).filter(({ low, high }) => low < cut && cut < high);
  return open.map(({ base }) => base);
});

/** All that a storey covers, walls included; courtyards stay open. Disjoint polygons, metres. */
export const footprint = oncePer((storey: Storey) => {
  const walls = storey.walls.map(({ outline }) => outline);
  const rooms = storey.rooms.map(({ outline }) => outline);
  return unite([...storey.primary, ...rooms, ...walls]);
});

/**
 * An area after the secondary boundaries, in their order: subtracted ones are cut out, added ones joined on
 * ([Stojanovic19] §3.2); independent ones leave it alone.
 *
 * @returns disjoint polygons fit for extrusion, the largest first
 */
export function carve(base: readonly Polygon[], secondary: readonly SecondaryBoundary[]): Polygon[] {
  let section = [...base];
  for (const { operation, outlines } of runsOf(secondary)) {
    if (operation === 'subtract') section = combine('difference', section, outlines);
    if (operation === 'add') section = unite([...section, ...outlines]);
  }
  return separatePinches(section).sort((a, b) => polygonArea(b) - polygonArea(a));
}

/** Boundaries that follow each other with one operation, whose order does not count; independent ones left out. */
function runsOf(secondary: readonly SecondaryBoundary[]) {
  const runs: { operation: SecondaryBoundary['operation']; outlines: Polygon[] }[] = [];
  for (const { operation, outline } of secondary) {
    if (operation === 'independent') continue;
    if (runs.at(-1)?.operation !== operation) runs.push({ operation, outlines: [] });
    runs[runs.length - 1].outlines.push(outline);
  }
  return runs;
}

/** The union of areas; those that rounding alone keeps apart become one. */
export function unite(polygons: readonly Polygon[]): Polygon[] {
  if (polygons.length < 2) return combine('union', polygons);
  return combine('union', shareVertices(polygons.map((polygon) => [polygon])).flat());
}
