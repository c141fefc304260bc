import type { PointCloud } from '../../types.ts';
import { type HeightColumns, hasPlane } from '../columns/height-columns.ts';
import { ceilingBeside } from '../faces/ceiling-across.ts';
import { type Face, pointOn } from '../faces/face.ts';
import { STEP } from '../faces/face-support.ts';

/** The blind side shows floor or ceiling over less than this share of what the other side does. */
const BLIND_SHARE = 0.5;
/** Fewer points of a ceiling tell nothing. */
const FEWEST = 6;
/** So near a face, m, is its own noise; so far off ends the thinnest wall's inside. */
const NEAR = 0.03;
const FAR = 0.08;

/** A storey, as the sides of its walls are looked at. */
export interface BlindSite {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
}

/**
 * The side of a stretch of a face on which nothing was seen, where a wall's body is: 1, −1, or 0 where both sides or none were.
 *
 * Its ceiling tells it point by point; where too little of that was seen, columns with floor or ceiling do, which are nearly
 * as wide as a thin wall. O(columns beside the stretch).
 *
 * Not taken: by columns alone (rooms of what is beyond hard .96 → .91, clean ones of other buildings .990 → .986).
 */
export function blindSide({ cloud, columns }: BlindSite, face: Face, from: number, to: number): 1 | -1 | 0 {
  const count = Math.max(1, Math.round((to - from) / STEP));
  const ceilings = ceilingBeside(cloud, columns, face, { from, step: (to - from) / count, count });
  const isTold = Math.max(...ceilings) >= FEWEST;
  const [ahead, behind] = isTold ? ceilings : planesBeside(columns, face, from, to);
  if (ahead < BLIND_SHARE * behind) return 1;
  return behind < BLIND_SHARE * ahead ? -1 : 0;
}

/** Columns with floor or ceiling on the side of a face's normal, and on the other. */
function planesBeside(columns: HeightColumns, face: Face, from: number, to: number): [number, number] {
  const count = (side: number) => {
    let planes = 0;
    for (let along = from + STEP / 2; along < to; along += STEP) {
      for (let across = NEAR; across <= FAR; across += (FAR - NEAR) / 2) {
        if (hasPlane(columns, ...pointOn(face, along, side * across))) planes++;
      }
    }
    return planes;
  };
  return [count(1), count(-1)];
}
