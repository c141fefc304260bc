import { boundsOf, pointInRing } from '../../geometry/rings.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { PointCloud, Ring } from '../../types.ts';
import { columnAt, type HeightColumns, hasPlane } from '../columns/height-columns.ts';

/** What is within an outline is looked at so far off it, m, and what is around it as far as this. */
const RIM = 0.04;
const AROUND = 0.35;
/** Distance between the places at which areas are measured, m. */
const STEP = 0.02;
/** Floor and ceiling are looked for around an outline at so many places, so far off it, m. */
const PLACES = 24;
const BESIDE = 0.15;

type Place = 'within' | 'rim' | 'around' | 'beyond';

/** What was seen above and below a structure. */
export interface Surroundings {
  /** Points of the ceiling within the outline. */
  readonly ceilingWithin: number;
  /** Points of the ceiling that would be there were it seen as densely as around. */
  readonly ceilingExpected: number;
  /** Share of the middle of the outline over which, or under which, floor or ceiling was seen. */
  readonly seenWithin: number;
}

/** Looks at what was seen within and around an outline. O(points near it + its area). */
export function surroundingsOf(cloud: PointCloud, columns: HeightColumns, outline: Ring): Surroundings {
  const areas: Record<Place, number> = { within: 0, rim: 0, around: 0, beyond: 0 };
  const visited = new Set<number>();
  let [seen, middle] = [0, 0];
  forPlacesNear(outline, (x, y) => {
    const place = placeOf(outline, x, y);
    areas[place]++;
    const c = columnAt(columns, x, y);
    if (c >= 0) visited.add(c);
    // A column of the grid that reaches out of the outline has points of what is around.
    if (place !== 'within' || distanceToRing(x, y, outline) <= columns.size) return;
    middle++;
    if (hasPlane(columns, x, y)) seen++;
  });
  const { overPoints, overStart } = columns;
  const ceiling = countPlaces(
    cloud,
    outline,
    [...visited].map((c) => overPoints.subarray(overStart[c], overStart[c + 1])),
  );
  return {
    ceilingWithin: ceiling.within,
    ceilingExpected: (ceiling.around * areas.within) / Math.max(1, areas.around),
    seenWithin: middle === 0 ? 0 : seen / middle,
  };
}

function placeOf(outline: Ring, x: number, y: number): Place {
  const away = distanceToRing(x, y, outline);
  if (away < RIM) return 'rim';
  if (pointInRing(x, y, outline) > 0) return 'within';
  return away <= AROUND ? 'around' : 'beyond';
}

function forPlacesNear(outline: Ring, visit: (x: number, y: number) => void): void {
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  for (let x = minX - AROUND; x <= maxX + AROUND; x += STEP)
    for (let y = minY - AROUND; y <= maxY + AROUND; y += STEP) visit(x, y);
}

/** How many points are where; lists of their indices. */
function countPlaces(
  { positions }: PointCloud,
  outline: Ring,
  lists: readonly Uint32Array[],
): Record<Place, number> {
  const counts: Record<Place, number> = { within: 0, rim: 0, around: 0, beyond: 0 };
  for (const points of lists)
    for (const i of points) counts[placeOf(outline, positions[3 * i], positions[3 * i + 1])]++;
  return counts;
}

/** Share of the way around an outline along which floor or ceiling was seen. */
export function seenAround(columns: HeightColumns, outline: Ring): number {
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  const [cx, cy] = [(minX + maxX) / 2, (minY + maxY) / 2];
  let seen = 0;
  for (let k = 0; k < PLACES; k++) {
    const [ux, uy] = [Math.cos((2 * Math.PI * k) / PLACES), Math.sin((2 * Math.PI * k) / PLACES)];
    let reach = 0;
    while (pointInRing(cx + reach * ux, cy + reach * uy, outline) > 0) reach += STEP;
    if (hasPlane(columns, cx + (reach + BESIDE) * ux, cy + (reach + BESIDE) * uy)) seen++;
  }
  return seen / PLACES;
}
