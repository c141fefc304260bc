import type { SeenSpace } from '../columns/seen-space.ts';
import { alongOf, crossingOf, type Face, pointOn } from '../faces/face.ts';
import { type FaceSupport, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';

/** A wall that stands within this of where another's line crosses its own meets it, m: with the thickness of a wall between. */
export const NEAR_END = 0.3;
/** Along a hidden stretch, or between the faces of a wall, hardly any place shows a floor or a ceiling. */
export const OPEN_SHARE = 0.15;
/** How far a wall is taken to go on unseen to the corner with another, m: behind a row of wardrobes. */
export const LONGEST = 3.5;
/** Walls seen over less than this, m, may be columns or furniture: they do not go on. */
const SHORTEST_WALL = 0.6;

/**
 * Lets walls go on from where they were last seen to the farthest other wall, where no space is seen on the way: furniture
 * stands in many a corner.
 *
 * @param supports what is known of the walls by now; `own` what was seen of them
 */
export function withCorners(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  own: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  const walls = faces.map(
    (face, i): SeenWall => ({
      face,
      own: own[i],
      stands: [...own[i].shares.keys()].filter((k) => own[i].shares[k] >= WALL_SHARE),
      seen,
    }),
  );
  return supports.map((support, i) => {
    if (walls[i].stands.length * support.step < SHORTEST_WALL) return support;
    const corners = walls.flatMap((other) => cornerOf(walls[i], other) ?? []);
    return goOnToCorners(walls[i], support, corners);
  });
}

interface SeenWall {
  readonly face: Face;
  readonly own: FaceSupport;
  /** Bits of it that were seen to stand. */
  readonly stands: readonly number[];
  readonly seen: SeenSpace;
}

function goOnToCorners(wall: SeenWall, support: FaceSupport, corners: readonly number[]): FaceSupport {
  const { from, step } = support;
  const shares = support.shares.slice();
  for (const side of [1, -1]) {
    for (const k of wall.stands) {
      const beyond = k + side;
      if (beyond < 0 || beyond >= shares.length || support.shares[beyond] >= WALL_SHARE) continue;
      const end = from + (side > 0 ? k + 1 : k) * step;
      const way = corners
        .map((corner) => side * (corner - end))
        .filter((length) => length > 0 && length <= LONGEST)
        .sort((a, b) => b - a)
        .find((length) => isUnseen(wall, end, end + side * length));
      if (way === undefined) continue;
      const last = Math.floor((end + side * way - from) / step);
      for (let m = beyond; m >= 0 && m < shares.length && (last - m) * side >= 0; m += side)
        shares[m] = Math.max(shares[m], TAKEN_SHARE);
    }
  }
  return { ...support, shares };
}

/** Where along a wall another meets it, m, if that one stands there or goes on to there unseen; null elsewhere. */
function cornerOf({ face }: SeenWall, other: SeenWall): number | null {
  const place = crossingOf(face, other.face);
  if (place === null) return null;
  const there = alongOf(other.face, ...place);
  const { from, step } = other.own;
  let [nearest, least] = [0, Infinity];
  for (const k of other.stands) {
    const at = from + (k + 0.5) * step;
    if (Math.abs(at - there) < least) [nearest, least] = [at, Math.abs(at - there)];
  }
  if (least > LONGEST || (least > NEAR_END && !isUnseen(other, nearest, there))) return null;
  return alongOf(face, ...place);
}

/** Whether hardly any space was seen along a stretch of a wall's line: no ceiling goes on over it, nor is its floor open. */
function isUnseen({ face, own, seen }: SeenWall, end: number, other: number): boolean {
  const [from, to] = [Math.min(end, other), Math.max(end, other)];
  let [open, count] = [0, 0];
  for (let along = from + own.step; along < to; along += own.step) {
    count++;
    const ceiling = own.ceiling[Math.floor((along - own.from) / own.step)] ?? Number.NaN;
    if (Number.isNaN(ceiling) ? seen.isOpen(...pointOn(face, along)) : ceiling >= 0.5) open++;
  }
  return open <= OPEN_SHARE * count;
}
