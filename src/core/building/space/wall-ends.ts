import type { SeenSpace } from '../columns/seen-space.ts';
import { alongOf, asideOf, behindOf, isParallel, pointOn } from '../faces/face.ts';
import { type FaceSupport, WALL_SHARE, wallAt } from '../faces/face-support.ts';
import { type BlindSite, blindSide } from './blind-side.ts';
import { NO_LINE, RETURN_LINE, type Segment } from './cut-segments.ts';
import type { WallFace, WallFaces } from './found-rooms.ts';

/** Thickest wall that may end, m. */
const THICKEST = 0.6;
/** Deepest step between two faces of a wall, m: pilasters, chimneys and niches are flatter than most cupboards. */
const DEEPEST_STEP = 0.4;
/** … and those flatter than this are panelling, or the frame of a door. */
const FLATTEST_STEP = 0.1;
/** Nearer faces are one, m. */
const THINNEST = 0.03;
/** Shortest stretch of wall whose ends count, m, and longest break in it. */
const SHORTEST = 0.2;
const LONGEST_BREAK = 0.15;
/** A wall ends where space was seen from so far past it, m, to so far, over most of the way. */
const PAST_FROM = 0.1;
const PAST_TO = 0.35;
/** Sparse scans show a place by those this far off it on both sides, m. */
const BESIDE = 0.05;
/** The wall's body is looked for from so far before its end, m, to so far. */
const BODY_FROM = 0.3;
const BODY_TO = 0.05;
/** Places along that way are so far apart, m. */
const PLACE = 0.05;
/** A stroke is longer than the wall is thick by this at each side, m, so that it surely meets both faces. */
const OVERLAP = 0.01;
/** Points this far before and past the end of a stretch tell where it is, m … */
const BEFORE_END = 0.15;
const PAST_END = 0.1;
/** … if they lie within so many deviations of the face … */
const NOISES = 3;
/** … but for this share of them: stray ones. */
const STRAY = 0.03;
/** Fewer points tell no end. */
const FEWEST = 5;

/** A storey, as the ends of its walls are looked for. */
export interface EndSite extends BlindSite {
  readonly seen: SeenSpace;
}

/**
 * Short strokes across a wall where it ends in the open, from its face to the one behind: at a niche, a passage, a stub.
 *
 * They let the subdivision end a wall there even where too little of its reveal was seen to be a face. Where another face
 * of the wall stands on past the end, the wall steps back to it or forward, at a niche, a pilaster, a chimney: a surface
 * joins the two, and the stroke is a wall. Where no face is beside it, the stroke cuts the wall's own, so that what stands of
 * it is told from what does not. O(faces · ends + points at the ends).
 *
 * Not taken: strokes as walls wherever a wall ends (clean corners at 5 cm .910 → .862: jags beside reveals that were seen);
 * ends by bits of the face, not by its points (.937 → .914); steps as deep as any wall (hard corners .549 → .538: sides of
 * cupboards) or as flat (.689 → .693, but jogs along the glass wall of a real room); on whichever side a face stands (rooms
 * of hard offices .88 → .80); only where no reveal was seen (no difference).
 */
export function wallEnds(
  { faces, supports }: WallFaces,
  taken: readonly FaceSupport[],
  site: EndSite,
): Segment[] {
  return faces.flatMap((face, i) =>
    face.reach === 0
      ? []
      : endsAlong(supports[i].shares, supports[i].step).flatMap(({ bit, way }) => {
          const bitEnd = supports[i].from + bit * supports[i].step;
          if (!isOpenPast(face, bitEnd, way, site.seen)) return [];
          const end: WallEnd = { face, along: endByPoints(site, face, bitEnd, way), way };
          const blind = bodySide(site, end);
          return [1, -1].flatMap((side) =>
            strokesFrom(end, { faces, supports: taken }, side, side === blind),
          );
        }),
  );
}

/** Where a stretch of wall ends along its face, m, and which way. */
interface WallEnd {
  readonly face: WallFace;
  readonly along: number;
  readonly way: 1 | -1;
}

/** First bits past the ends of long enough stretches of wall, and which way they end. */
function endsAlong(shares: Float64Array, step: number): { bit: number; way: 1 | -1 }[] {
  const stretches: [number, number][] = [];
  for (let k = 0; k < shares.length; k++) {
    if (shares[k] < WALL_SHARE) continue;
    const last = stretches[stretches.length - 1];
    if (last && (k - last[1]) * step <= LONGEST_BREAK) last[1] = k + 1;
    else stretches.push([k, k + 1]);
  }
  return stretches
    .filter(([from, to]) => (to - from) * step >= SHORTEST)
    .flatMap(([from, to]) => [
      { bit: from, way: -1 },
      { bit: to, way: 1 },
    ]);
}

function isOpenPast(face: WallFace, along: number, way: number, seen: SeenSpace): boolean {
  const isOpen = (past: number, across: number) => seen.isOpen(...pointOn(face, along + way * past, across));
  return mostPast(PAST_FROM, (past) => isOpen(past, 0) || (isOpen(past, BESIDE) && isOpen(past, -BESIDE)));
}

/** Whether something holds at most places past an end, from so far, m. */
function mostPast(from: number, holds: (past: number) => boolean): boolean {
  let [holding, count] = [0, 0];
  for (let past = from; past < PAST_TO; past += PLACE) {
    count++;
    if (holds(past)) holding++;
  }
  return holding > count / 2;
}

/** Where the points of a face end near a place along it: bits and columns are coarser than a corner is to be told. */
function endByPoints({ cloud, columns }: EndSite, face: WallFace, along: number, way: number): number {
  const past: number[] = [];
  for (const c of face.members) {
    for (let k = columns.start[c]; k < columns.start[c + 1]; k++) {
      const p = 3 * columns.points[k];
      const [x, y] = [cloud.positions[p], cloud.positions[p + 1]];
      const t = way * (alongOf(face, x, y) - along);
      if (t < -BEFORE_END || t > PAST_END || Math.abs(asideOf(face, x, y)) > NOISES * face.noise) continue;
      past.push(t);
    }
  }
  if (past.length < FEWEST) return along;
  past.sort((a, b) => b - a);
  return along + way * past[Math.floor(STRAY * past.length)];
}

/** The side on which the wall's body is: neither floor nor ceiling was seen there before its end; 0 where that is not told. */
function bodySide(site: EndSite, { face, along, way }: WallEnd): 1 | -1 | 0 {
  const [from, to] = [along - way * BODY_FROM, along - way * BODY_TO].sort((a, b) => a - b);
  return blindSide(site, face, from, to);
}

/** The stroke on one side of an end: to the face that stands on past it, or else to the nearest, or to none. */
function strokesFrom(end: WallEnd, { faces, supports }: WallFaces, side: number, isBody: boolean): Segment[] {
  const beside = faces.flatMap((other, j) => {
    const aside = asideTo(end, other, side);
    if (aside === null) return [];
    const isStep = isBody && aside >= FLATTEST_STEP && aside < DEEPEST_STEP;
    return [{ aside, isStep: isStep && standsPast(end, other, supports[j]) }];
  });
  beside.sort((a, b) => a.aside - b.aside);
  const target = beside.find(({ isStep }) => isStep) ?? beside[0];
  const [ax, ay] = pointOn(end.face, end.along, -side * OVERLAP);
  const [bx, by] = pointOn(end.face, end.along, side * ((target?.aside ?? 0) + OVERLAP));
  return [{ ax, ay, bx, by, line: target?.isStep ? RETURN_LINE : NO_LINE }];
}

/** How far beside an end another face's line runs on one side, m; null where it does not, or too far off. */
function asideTo({ face, along }: WallEnd, other: WallFace, side: number): number | null {
  if (other === face || !isParallel(face, other)) return null;
  const place = pointOn(face, along);
  const aside = behindOf(face, other, side, place);
  const there = alongOf(other, ...place);
  const isBeside = there > other.from - other.reach && there < other.to + other.reach;
  return isBeside && aside > THINNEST && aside <= THICKEST ? aside : null;
}

/** Whether another face was seen to stand past the end of one that was seen. */
function standsPast({ face, along, way }: WallEnd, other: WallFace, own: FaceSupport): boolean {
  if (face.members.length === 0 || other.members.length === 0) return false;
  return mostPast(PLACE, (past) => wallAt(own, alongOf(other, ...pointOn(face, along + way * past))));
}
