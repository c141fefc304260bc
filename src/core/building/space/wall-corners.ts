import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { alongOf, crossingOf, type Face, pointOn } from '../faces/face.ts';
import { type FaceAmong, type FaceSupport, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { isDeep } from './deep-stretch.ts';

/** A wall that stands within this of where another's line crosses its own meets it, m: with the thickness of a wall between. */
export const NEAR_END = 0.3;
/** How far a wall is taken to go on unseen to the corner with another, m: behind a row of wardrobes. */
export const LONGEST = 3.5;
/** Walls seen over less than this, m, may be columns or furniture: they do not go on. */
const SHORTEST_WALL = 0.6;
/** A wall passes by another's end if it was seen on both sides of it, from so far off, m, to so far: past a door. */
const PASSING_FROM = 0.2;
const PASSING_TO = 1.2;
/** A wall ends at a corner this near its end, m: what was seen of it is told in bits. */
const AT_CORNER = 0.1;
/** Two faces nearer or farther apart make no inner wall, m. */
export const THINNEST_WALL = 0.04;
export const THICKEST_WALL = 0.4;
/** Space goes on across a wall's line if it is open this far off it on both sides, m: where a wall stands, one is inside it. */
const BESIDE = 0.05;
/** So far around a bit reaches what is known of its ceiling, m: nearer to a corner it tells of what lies past that. */
const CEILING_LOOK = 0.2;

/**
 * Lets walls go on from where they were last seen to the farthest other wall, where no space is seen on the way: furniture
 * stands in many a corner. They go on no farther than they are known to stand, but deep in what is hidden: between rows of
 * cupboards back to back, of whose wall a stub is seen.
 *
 * Not taken: as far from walls of any length (footprints of hard scenes .982 → .972: fronts of cupboards go on); to look
 * for space on the line alone, which lies before the wall as often as behind it (rooms of hard scenes .964 → .914: walls
 * between cupboards stop short, and rooms flow together); to ask the columns only, never the ceiling (rooms of what is beyond
 * hard .854 → .832); both sides at one place (rooms of hard scenes .969 → .964: sparse scans seldom show
 * that); the ceiling right up to the corner (corners of the scenes at 5 cm .989 → .971); on past a wall that goes by on both
 * sides (a partition cuts the corridor in front of it, where little of that was seen).
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
      among: { faces, own, i },
      own: own[i],
      stands: [...own[i].shares.keys()].filter((k) => own[i].shares[k] >= WALL_SHARE),
      farthest: Math.min(
        LONGEST,
        supports[i].shares.filter((share) => share >= WALL_SHARE).length * own[i].step,
      ),
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
  readonly among: FaceAmong;
  readonly own: FaceSupport;
  /** Bits of it that were seen to stand. */
  readonly stands: readonly number[];
  /** How far it is known to stand, and may go on unseen, m. */
  readonly farthest: number;
  readonly seen: SeenSpace;
}

/** Where a wall meets another, m along it, and whether that one was seen to pass by on both sides. */
interface Corner {
  readonly along: number;
  readonly passes: boolean;
}

function goOnToCorners(wall: SeenWall, support: FaceSupport, corners: readonly Corner[]): FaceSupport {
  const { from, step } = support;
  const shares = support.shares.slice();
  for (const side of [1, -1]) {
    for (const k of wall.stands) {
      const beyond = k + side;
      if (beyond < 0 || beyond >= shares.length || support.shares[beyond] >= WALL_SHARE) continue;
      const end = from + (side > 0 ? k + 1 : k) * step;
      if (corners.some(({ along, passes }) => passes && Math.abs(along - end) <= AT_CORNER)) continue;
      const ways = corners.map(({ along }) => side * (along - end));
      const way = wayOn(wall, end, ways, side);
      if (way === undefined) continue;
      const last = Math.floor((end + side * way - from) / step);
      for (let m = beyond; m >= 0 && m < shares.length && (last - m) * side >= 0; m += side)
        shares[m] = Math.max(shares[m], TAKEN_SHARE);
    }
  }
  return { ...support, shares };
}

/** How far a wall goes on from an end of it, m, of the ways to its corners; undefined where it does not. */
function wayOn(wall: SeenWall, end: number, ways: readonly number[], side: number): number | undefined {
  const met = ways.filter((way) => Math.abs(way) <= AT_CORNER);
  const isBehind = (way: number) => met.some((at) => way > Math.abs(at) && way <= at + THICKEST_WALL);
  return ways
    .filter((way) => way > 0 && way <= LONGEST && !isBehind(way))
    .sort((a, b) => b - a)
    .find((way) => {
      const [from, to] = [end, end + side * way].sort((a, b) => a - b);
      if (!isUnseen(wall, from, to)) return false;
      return way <= wall.farthest || isDeep({ ...wall.among, from, to }, wall.seen);
    });
}

/** Where along a wall another meets it, m, if that one stands there or goes on to there unseen; null elsewhere. */
function cornerOf({ face }: SeenWall, other: SeenWall): Corner | null {
  const place = crossingOf(face, other.face);
  if (place === null) return null;
  const there = alongOf(other.face, ...place);
  const { from, step } = other.own;
  let [nearest, least] = [0, Infinity];
  for (const k of other.stands) {
    const at = from + (k + 0.5) * step;
    if (Math.abs(at - there) < least) [nearest, least] = [at, Math.abs(at - there)];
  }
  if (least > NEAR_END && (least > LONGEST || !isUnseen(other, nearest, there))) return null;
  const passes = [1, -1].every((side) =>
    other.stands.some((k) => {
      const past = side * (from + (k + 0.5) * step - there);
      return past > PASSING_FROM && past < PASSING_TO;
    }),
  );
  return { along: alongOf(face, ...place), passes };
}

/** Whether hardly any space was seen across a stretch of a wall's line: no ceiling goes on over it, nor is its floor open. */
function isUnseen({ face, own, seen }: SeenWall, end: number, other: number): boolean {
  const [from, to] = [Math.min(end, other), Math.max(end, other)];
  // Side by side, as a sparse scan seldom shows both at one place.
  const open = [0, 0];
  let count = 0;
  for (let along = from + own.step; along < to; along += own.step) {
    count++;
    const isFar = along - from >= CEILING_LOOK && to - along >= CEILING_LOOK;
    const ceiling = isFar ? own.ceiling[Math.floor((along - own.from) / own.step)] : undefined;
    const isKnown = ceiling !== undefined && !Number.isNaN(ceiling);
    [BESIDE, -BESIDE].forEach((across, side) => {
      if (isKnown ? ceiling >= 0.5 : seen.isOpen(...pointOn(face, along, across))) open[side]++;
    });
  }
  return Math.min(...open) <= OPEN_SHARE * count;
}
