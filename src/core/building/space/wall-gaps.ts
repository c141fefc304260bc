import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { alongOf, behindOf, crossingOf, type Face, isParallel, pointOn } from '../faces/face.ts';
import { type FaceAmong, type FaceSupport, wallAt } from '../faces/face-support.ts';
import { LONGEST, NEAR_END } from './wall-corners.ts';

/** Widest passage that a wall is taken to go on over, m. */
const WIDEST_PASSAGE = 2.5;
/** Over such a width, space seen on less than this share of it does not interrupt the wall. */
const HALF_OPEN = 0.5;

/** No corridor is narrower, m. */
const NARROWEST_CORRIDOR = 0.8;

/** Places along a gap are so far apart, m. */
const PLACE = 0.05;
/** Inside a wall is so near its line, m, on one side of it … */
const INSIDE = 0.05;
/** … and its rooms this far off, whatever cupboards stand there. */
const IN_ROOM = [0.2, 0.3];
/** Behind a stretch as long as a cupboard is deep, m, on which nothing was seen, anything may stand. */
const HIDDEN = 0.6;

/** A wall that crosses bounds a gap if it stands so far off it, m: more than a wall is thick, or past a door. */
const PASSING = [0.6, 0.9, 1.2, 1.5];

/** So much of a niche's back was seen: the rest may be a window … */
const BACK_SHARE = 0.25;
/** … past its corners, m, where the faces beside a passage end. */
const NICHE_END = 0.1;
/** A niche is no deeper than this, m: deeper ones are rooms. */
const DEEPEST_NICHE = 0.75;

/** What stands so near behind a gap, m, is the wall itself, in another line than the face: hardly a wall is thinner. Thin ones have room behind … */
const SAME_WALL = 0.08;
/** … this far past their other face, m. */
const PAST_WALL = 0.1;

/** A gap of a face, from one place along it to another, m. */
export interface GapPlace extends FaceAmong {
  readonly begin: number;
  readonly end: number;
}

/** Whether a wall goes on over a gap: nothing was seen there, or it is a passage. */
export function goesOnOver(gap: GapPlace, seen: SeenSpace): boolean {
  const { faces, i, begin, end } = gap;
  if ([1, -1].some((side) => isWallBehind(gap, side, seen)) || crossesCorridor(gap, seen)) return false;
  const open = openShare(faces[i], begin, end, seen);
  if (end - begin > WIDEST_PASSAGE) return end - begin <= LONGEST && open <= OPEN_SHARE;
  return (open <= HALF_OPEN && !isAsOpenAsBeside(gap, seen)) || isPassage(gap);
}

/**
 * Whether as much space was seen across a gap as on either side of it: far from a scanner little is seen of anything, so
 * that a line runs between its rows, but nothing stands there.
 *
 * Without it corridors are split where they bend (rooms of corridor-324 F1 1.00 → .86, areas of a second corpus 4.4 → 4.8 %
 * off). Not taken: by what `ceilingAcross` tells of the gap (hard corners at 5 cm .679 → .662); by the farther seen of
 * the two sides (hard footprints of the second corpus .965 → .963); also where a cupboard's length shows nothing (corners of home-l-cupboards
 * .63 → .53); cupboards from 0.45 m on (corridor-324 is split).
 */
function isAsOpenAsBeside({ faces, i, begin, end }: GapPlace, seen: SeenSpace): boolean {
  const shareAt = (across: number) => openShare(faces[i], begin, end, seen, across);
  const inside = Math.min(shareAt(INSIDE), shareAt(-INSIDE));
  if (inside <= OPEN_SHARE || longestHidden(faces[i], begin, end, seen) >= HIDDEN) return false;
  const besides = [1, -1].map((side) => meanOf(IN_ROOM.map((off) => shareAt(side * off))));
  return inside >= HALF_OPEN * Math.min(...besides);
}

/**
 * Whether from wall to wall across a gap the floor or the ceiling was seen on both sides of the line, and nothing on it: a corridor
 * passes through, of which rows of points far apart may show no ceiling on the line itself.
 */
function crossesCorridor({ faces, own, i, begin, end }: GapPlace, seen: SeenSpace): boolean {
  const walls = faces.flatMap((other, j) => {
    const place = crossingOf(faces[i], other);
    const along = place === null ? end : alongOf(faces[i], ...place);
    if (place === null || along <= begin || along >= end) return [];
    return [1, -1].some((side) => standsAside({ faces, own, i }, j, place, side)) ? [along] : [];
  });
  const isFree = (from: number, to: number) =>
    seenShare(own[i], from, to) <= OPEN_SHARE &&
    [INSIDE, -INSIDE].every(
      (across) => shareOf(from, to, (along) => seen.isOpen(...pointOn(faces[i], along, across))) >= HALF_OPEN,
    );
  walls.sort((a, b) => a - b);
  return walls.slice(1).some((to, k) => to - walls[k] >= NARROWEST_CORRIDOR && isFree(walls[k], to));
}

/** Share of a stretch of a face on which anything was seen. */
function seenShare({ from, step, isSeen }: FaceSupport, begin: number, end: number): number {
  return shareOf(begin, end, (along) => isSeen[Math.floor((along - from) / step)] === 1);
}

function meanOf(values: readonly number[]): number {
  return values.reduce((sum, value) => sum + value, 0) / values.length;
}

/** The longest stretch on which no space was seen on a face's line or near it, m. */
function longestHidden(face: Face, begin: number, end: number, seen: SeenSpace): number {
  let [last, longest] = [begin, 0];
  for (let along = begin + PLACE / 2; along < end; along += PLACE) {
    if (![-INSIDE, 0, INSIDE].some((across) => seen.at(...pointOn(face, along, across)))) continue;
    longest = Math.max(longest, along - last);
    last = along;
  }
  return Math.max(longest, end - last);
}

/** Share of a stretch on which space was seen, `across` off it, m. */
function openShare(face: Face, begin: number, end: number, seen: SeenSpace, across = 0): number {
  return shareOf(begin, end, (along) => seen.at(...pointOn(face, along, across)));
}

/** Share of the places along a stretch at which something holds. */
function shareOf(begin: number, end: number, holds: (along: number) => boolean): number {
  let [held, count] = [0, 0];
  for (let along = begin + PLACE / 2; along < end; along += PLACE) {
    count++;
    if (holds(along)) held++;
  }
  return held / Math.max(1, count);
}

/**
 * Whether a gap leads from room to room: it is narrower than the space on either side of it, and no wall stands behind it.
 *
 * A corridor that passes through, or the mouth of a wing, is as wide as the gap.
 */
function isPassage(gap: GapPlace): boolean {
  const { begin, end } = gap;
  const isNarrowing = [1, -1].every((side) => [begin, end].some((along) => !passesBy(gap, along, side)));
  if (!isNarrowing) return false;
  return ![1, -1].some((side) => hasNicheBack(gap, side));
}

/** Whether over most of a gap a wall was seen just behind it, with no room behind that: the wall, which does not go on in this line. */
function isWallBehind({ faces, own, i, begin, end }: GapPlace, side: number, seen: SeenSpace): boolean {
  const face = faces[i];
  const others = faces.flatMap((other, j) => (i !== j && isParallel(face, other) ? [j] : []));
  const isBehind = (along: number) => {
    const place = pointOn(face, along);
    return others.some((j) => {
      const deep = behindOf(face, faces[j], side, place);
      if (deep <= 0 || deep > SAME_WALL || !wallAt(own[j], alongOf(faces[j], ...place))) return false;
      return !seen.at(...pointOn(face, along, side * (deep + PAST_WALL)));
    });
  };
  return shareOf(begin, end, isBehind) > 0.5;
}

/** Whether a wall stands behind a gap on one side, over most of its width but for a window. */
function hasNicheBack({ faces, own, i, begin, end }: GapPlace, side: number): boolean {
  const face = faces[i];
  const backs = faces.flatMap((other, j) => (i !== j && isParallel(face, other) ? [j] : []));
  const isBacked = (along: number) => {
    const place = pointOn(face, along);
    return backs.some((j) => {
      const deep = behindOf(face, faces[j], side, place);
      return deep > 0 && deep < DEEPEST_NICHE && wallAt(own[j], alongOf(faces[j], ...place));
    });
  };
  let [count, backed, first, last] = [0, 0, end, begin];
  for (let along = begin + NICHE_END; along < end - NICHE_END; along += own[i].step) {
    count++;
    if (!isBacked(along)) continue;
    backed++;
    first = Math.min(first, along);
    last = along;
  }
  return backed > BACK_SHARE * count && last - first > (end - begin) / 2;
}

/** Whether a wall leads away from a face, near a place along it, to one side. */
function passesBy({ faces, own, i }: FaceAmong, along: number, side: number): boolean {
  const face = faces[i];
  return faces.some((other, j) => {
    const place = crossingOf(face, other);
    if (place === null || Math.abs(alongOf(face, ...place) - along) > NEAR_END) return false;
    return standsAside({ faces, own, i }, j, place, side);
  });
}

/** Whether a face that crosses another at a place stands on one side of it, be there a door beside. */
function standsAside(
  { faces, own, i }: FaceAmong,
  j: number,
  [x, y]: readonly [number, number],
  side: number,
): boolean {
  const { nx, ny } = faces[i];
  return PASSING.some((off) => wallAt(own[j], alongOf(faces[j], x + side * off * nx, y + side * off * ny)));
}
