import type { Axis, Vec3 } from '../types.ts';
import { doorwaySide } from './doorway-side.ts';
import { furnitureSide } from './furniture-side.ts';
import { alignment, findHeightPlanes, type HeightPlanes } from './height-planes.ts';
import { type RoomGap, roomColumns } from './room-columns.ts';
import { axisVector, uprightRotation } from './rotation.ts';
import type { SurfacePatches } from './surface-patches.ts';

const AXES = ['z', 'y', 'x'] as const;
/**
 * How far each axis is trusted before looking. The walls of a corridor narrower than high are a larger
 * opposed pair than its floor and ceiling; scanners write z up, cameras and game engines y up, hardly
 * anything x up.
 */
const TRUST = { z: 1, y: 0.75, x: 0.5 } as const;
/** An axis along which furniture or doorways clearly show a floor is this many times as likely. */
const FURNISHED = 2;
/** A runner-up this close makes the choice doubtful. */
const DOUBTFUL = 0.9;
/** Cones around an axis in which normals are averaged, each around the last mean: tilts to 20° are found. */
const CONES = [20, 8, 4].map((degrees) => Math.cos((degrees * Math.PI) / 180));
/** A gap between planes shorter than this share of the longest is a slab or a table, not a room. */
const ROOM_GAP_SHARE = 0.6;

/** Which way is up, and why. */
export interface Gravity {
  readonly up: Axis;
  /**
   * Mean normal of the horizontal patches, source axes, pointing up; the axis itself where there are none.
   */
  readonly normal: Vec3;
  readonly planes: HeightPlanes;
  readonly reason: string;
  /** What may be wrong: another axis, or the other end of this one. */
  readonly doubt: 'axis' | 'end' | null;
}

/**
 * Finds the gravity axis: the one whose two largest opposed planes cover most area, seen by patches of equal size.
 *
 * The paper turns clouds by hand ([Stojanovic19] §3); ours. Floor and ceiling differ by the furniture, of which more
 * stands on the floor than hangs from the ceiling, and by the doorways, which reach down to the floor. Where neither
 * tells, or they disagree, the axis points along itself, not against, and the end is doubtful.
 *
 * @param positions the points the patches were fitted to
 * @param given the axis a person named; nothing is judged then
 * @param stated the axis the format names: trusted as z is, and never found upside down
 */
export function findGravity(
  positions: Float32Array,
  patches: SurfacePatches,
  given: Axis | 'auto',
  stated?: Axis,
): Gravity {
  if (given !== 'auto') {
    const { normal, planes } = lookAlong(patches, axisVector(given));
    return { up: given, normal, planes, reason: `${given} is up because it was given.`, doubt: null };
  }
  const [best, second] = rankAxes(positions, patches, stated);
  if (best.score === 0) {
    const reason = 'No floor or ceiling was found; z is up by convention.';
    return { up: 'z', normal: axisVector('z'), planes: best.planes, reason, doubt: 'axis' };
  }
  const isStated = best.axis === stated;
  const isUpsideDown = !isStated && floorEnd(best) < 0;
  const up: Axis = isUpsideDown ? `-${best.axis}` : best.axis;
  const { normal, planes } = isUpsideDown ? lookAlong(patches, axisVector(up)) : best;
  const isAxisDoubtful = second.score > DOUBTFUL * best.score;
  return {
    up,
    normal,
    planes,
    reason: `${up} is up: the largest opposed planes lie across ${best.axis}${isStated ? '' : sayEnd(best)}.`,
    doubt: isAxisDoubtful ? 'axis' : !isStated && floorEnd(best) === 0 ? 'end' : null,
  };
}

/** What tells floor from ceiling along an axis: 1 where the lower plane is the floor, −1 the upper one, 0 silent. */
interface EndSigns {
  readonly furniture: -1 | 0 | 1;
  readonly doorways: -1 | 0 | 1;
}

const SILENT: EndSigns = { furniture: 0, doorways: 0 };

/** Above zero where the axis points up, below where it points down; 0 where the signs tell nothing or disagree. */
function floorEnd({ furniture, doorways }: EndSigns): number {
  return furniture + doorways;
}

function sayEnd({ furniture, doorways }: EndSigns): string {
  if (furniture + doorways > 0) return '';
  if (furniture === 0 && doorways === 0)
    return '; neither furniture nor doorways show which of them is the floor';
  if (furniture + doorways === 0) return '; furniture and doorways disagree on which of them is the floor';
  const sign =
    doorways === 0
      ? 'the furniture side shows'
      : furniture === 0
        ? 'doorways show'
        : 'furniture and doorways show';
  return `; ${sign} that it points down in the file`;
}

/** The axes, likeliest first; the floor is told from the ceiling along those that come near. */
function rankAxes(positions: Float32Array, patches: SurfacePatches, stated?: Axis) {
  const seen = AXES.map((axis) => {
    const along = lookAlong(patches, axisVector(axis));
    return { axis, ...along, score: (axis === stated ? 1 : TRUST[axis]) * along.area };
  });
  const most = Math.max(...seen.map(({ score }) => score));
  return seen
    .map((along) => {
      if (along.score * FURNISHED < most || most === 0) return { ...along, ...SILENT };
      const rotation = { upright: uprightRotation(along.axis), up: along.normal };
      const columns = roomColumns(positions, patches, rotation);
      const rooms = roomGaps(along.planes);
      const signs = { furniture: furnitureSide(columns, rooms), doorways: doorwaySide(columns, rooms) };
      const isFurnished = floorEnd(signs) > 0;
      return { ...along, ...signs, score: isFurnished ? FURNISHED * along.score : along.score };
    })
    .sort((a, b) => b.score - a.score);
}

function lookAlong(patches: SurfacePatches, axis: Vec3) {
  const normal = meanNormal(patches, axis);
  const planes = findHeightPlanes(patches, normal, CONES[0]);
  const apart = planes.planes.filter(
    ({ height }) => Math.abs(height - planes.planes[0].height) > 2 * patches.size,
  );
  const area = Math.hypot(planes.planes[0]?.area ?? 0, apart[0]?.area ?? 0);
  return { normal, planes, area };
}

/** Mean of the normals near `axis`, signs turned alike, in narrowing cones. */
function meanNormal(patches: SurfacePatches, axis: Vec3): Vec3 {
  let mean = axis;
  for (const minCosine of CONES) {
    const sum = [0, 0, 0];
    for (let i = 0; i < patches.count; i++) {
      const cosine = alignment(patches, i, mean);
      if (Math.abs(cosine) < minCosine) continue;
      for (let k = 0; k < 3; k++) sum[k] += Math.sign(cosine) * patches.normals[3 * i + k];
    }
    const length = Math.hypot(...sum);
    if (length > 0) mean = [sum[0] / length, sum[1] / length, sum[2] / length];
  }
  return mean;
}

/**
 * Spaces high enough to be rooms between neighbouring strong planes, and between those and the ends of the cloud, for many
 * a scan has a floor only. None that is higher than wide: so look rooms along a wrong axis.
 */
function roomGaps({ strong, range }: HeightPlanes): RoomGap[] {
  const end = (height: number) => ({ height, area: 0 });
  const levels = [end(range[0]), ...strong, end(range[1])];
  const gaps = levels.slice(1).map((above, i) => {
    const below = levels[i];
    return { low: below.height, high: above.height, area: Math.max(below.area, above.area) };
  });
  const longest = Math.max(...gaps.map(({ low, high }) => high - low));
  return gaps.filter(
    ({ low, high, area }) => high - low >= ROOM_GAP_SHARE * longest && high - low <= Math.sqrt(area),
  );
}
