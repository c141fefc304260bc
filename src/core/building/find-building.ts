import type { StageContext } from '../context.ts';
import type { Options } from '../params.ts';
import type { PointCloud } from '../types.ts';
import { findStoreys } from './find-storeys.ts';
import { planStorey, type StoreyPlan } from './plan-storey.ts';

/**
 * Storeys with their rooms, walls, openings and structures, lowest first; storeys in which no room was found are left out.
 *
 * Ours. Empty for ready slices and for the method `outline`. O(n) in points beside what grows with the walls.
 *
 * @param kept indices of the points that are no outliers
 */
export function findBuilding(
  cloud: PointCloud,
  kept: Uint32Array,
  { planMethod, furniture }: Options,
  { progress, warn }: Pick<StageContext, 'progress' | 'warn'>,
): readonly StoreyPlan[] {
  if (planMethod === 'outline' || cloud.isFlat) return [];
  const heights = findStoreys(cloud, kept);
  const plans = heights.map((own, i) => {
    progress(i / heights.length);
    return planStorey(cloud, kept, own, furniture);
  });
  const storeys = plans.filter(({ rooms }) => rooms.length > 0);
  if (storeys.length > 0) {
    for (const [i, { rooms, floor, ceiling }] of plans.entries()) {
      if (rooms.length > 0) continue;
      warn({
        code: 'rooms/storey-left-out',
        message: `Storey ${i + 1} of ${plans.length}, from below, ${(ceiling - floor).toFixed(2)} m high, is left out: no walls close around most of the floor or ceiling seen there.`,
        hint: 'Crop the scan to its heights to have its outline drawn.',
      });
    }
  }
  if (storeys.some(({ isOpenAbove }) => isOpenAbove)) {
    warn({
      code: 'rooms/no-ceiling',
      message: 'No ceiling was seen: storeys are as high as their walls.',
      hint: 'A scan that shows the ceilings tells walls from tall furniture, and the heights of rooms.',
    });
  }
  if (storeys.some(({ isOpenBelow }) => isOpenBelow)) {
    warn({
      code: 'rooms/no-floor',
      message: 'No floor was seen: heights are told from the lowest points of the walls.',
      hint: 'Sills and heights of openings are too low by what is missing below.',
    });
  }
  if (storeys.length === 0) {
    warn({
      code: 'rooms/none-found',
      message:
        'No room was found: no walls that close around most of the floor or ceiling seen. The outline of the scan is drawn instead.',
      hint: 'Check the up axis and the unit; a single wall or an open place has no rooms.',
    });
  }
  return storeys;
}
