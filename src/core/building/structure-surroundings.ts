import { boundsOf, pointInRing } from '../geometry/rings.ts';
import { distanceToRing } from '../secondary/structure.ts';
import type { PointCloud, Ring } from '../types.ts';
import { columnAt, type HeightColumns, hasPlane } from './height-columns.ts';

/** What is within an outline is looked at so far off it, m, and what is around it as far as this. */
const RIM = 0.04;
const AROUND = 0.35;
/** Distance between the places at which areas are measured, m. */
const STEP = 0.02;
/** Floor and ceiling are looked for around an outline at so many places, so far off it, m. */
const PLACES = 24;
const BESIDE = 0.15;

/** What was seen above and below a structure. */
export interface Surroundings {
  /** Points of the ceiling within the outline. */
  readonly ceilingWithin: number;
  /** Points of the ceiling that would be there were it seen as densely as around. */
  readonly ceilingExpected: number;
  /** Share of the middle of the outline over which, or under which, floor or ceiling was seen. */
  readonly seenWithin: number;
}

/** Looks at floor and ceiling within and around an outline. O(points of the ceiling near it + its area). */
export function surroundingsOf(
  { positions }: PointCloud,
  columns: HeightColumns,
  outline: Ring,
): Surroundings {
  const { overPoints, overStart, size } = columns;
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  const visited = new Set<number>();
  let [areaWithin, areaAround, within, around, seen, middle] = [0, 0, 0, 0, 0, 0];
  const placeOf = (x: number, y: number): 'within' | 'around' | null => {
    const away = distanceToRing(x, y, outline);
    if (away < RIM) return null;
    if (pointInRing(x, y, outline) > 0) return 'within';
    return away <= AROUND ? 'around' : null;
  };
  for (let x = minX - AROUND; x <= maxX + AROUND; x += STEP) {
    for (let y = minY - AROUND; y <= maxY + AROUND; y += STEP) {
      const place = placeOf(x, y);
      if (place === 'around') areaAround++;
      if (place === 'within') areaWithin++;
      // A column of the grid that reaches out of the outline has points of what is around.
      if (place === 'within' && distanceToRing(x, y, outline) > size) {
        middle++;
        if (hasPlane(columns, x, y)) seen++;
      }
      const c = columnAt(columns, x, y);
      if (c < 0 || visited.has(c)) continue;
      visited.add(c);
      for (let p = overStart[c]; p < overStart[c + 1]; p++) {
        const at = placeOf(positions[3 * overPoints[p]], positions[3 * overPoints[p] + 1]);
        if (at === 'within') within++;
        if (at === 'around') around++;
      }
    }
  }
  return {
    ceilingWithin: within,
    ceilingExpected: (around * areaWithin) / Math.max(1, areaAround),
    seenWithin: middle === 0 ? 0 : seen / middle,
  };
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
