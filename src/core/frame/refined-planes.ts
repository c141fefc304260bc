import type { PointCloud } from '../types.ts';
import type { HeightPlane, HeightPlanes } from './height-planes.ts';
import type { SurfacePatches } from './surface-patches.ts';

/** Cone around up in which a patch counts as floor or ceiling, once the cloud is upright. */
export const FLOOR_COSINE = Math.cos((8 * Math.PI) / 180);
/** Points within three standard deviations of the noise, and at least a bin of heights, belong to a plane. */
const PLANE_REACH = 3;
const PLANE_BINS = 12;
const REFINE_ROUNDS = 4;

/**
 * Heights of floor and ceiling in an upright cloud: each plane is moved to the mean of the points around it, again and
 * again, since patches are cut at voxel faces. O(n).
 *
 * @param positions metres, z up
 * @param patches those the planes were found in
 * @param from how heights of planes become heights of points: scale · height + lift
 */
export function refinedPlanes(
  positions: Float32Array,
  { floor, ceiling }: HeightPlanes,
  { noise, size }: SurfacePatches,
  { scale, lift }: { readonly scale: number; readonly lift: number },
): Pick<PointCloud, 'floor' | 'ceiling'> {
  const reach = scale * Math.max(PLANE_REACH * noise, size / PLANE_BINS);
  const heightOf = (plane: HeightPlane | null) =>
    plane && refineHeight(positions, scale * plane.height + lift, reach);
  return { floor: heightOf(floor), ceiling: heightOf(ceiling) };
}

function refineHeight(positions: Float32Array, height: number, reach: number): number {
  let refined = height;
  for (let round = 0; round < REFINE_ROUNDS; round++) {
    let sum = 0;
    let count = 0;
    for (let i = 2; i < positions.length; i += 3) {
      if (Math.abs(positions[i] - refined) > reach) continue;
      sum += positions[i] - refined;
      count++;
    }
    if (count > 0) refined += sum / count;
  }
  return refined;
}
