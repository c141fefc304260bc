import type { SeenSpace } from '../columns/seen-space.ts';
import { alongOf, asideOf, crossingOf, type Face, isParallel, pointOn } from '../faces/face.ts';
import { type FaceSupport, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { LONGEST, NEAR_END, OPEN_SHARE, THICKEST_WALL, THINNEST_WALL, withCorners } from './wall-corners.ts';

/** Widest passage that a wall is taken to go on over, m. */
const WIDEST_PASSAGE = 2.5;
/** Over such a width, space seen on less than this share of it does not interrupt the wall. */
const HALF_OPEN = 0.5;

/** The side of a column is no longer than this, m, and space goes on this far past it, and to both sides of its line. */
const WIDEST_COLUMN = 0.6;
const PAST_COLUMN = 0.3;
const BESIDE_COLUMN = 0.1;
/** A line runs along the rim of a round column over no more than this, m: the column lies on one side, a wall may be near. */
const LONGEST_RIM = 0.25;
const PAST_RIM = [0.15, 0.3, 0.45];

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

/** A line that was seen no nearer than this, m, tells a wall's thickness if none is known that was seen over so much more. */
const FAR_OFF = 2;
const MUCH_MORE = 2;
/** What was seen no farther from the middle between two faces than this share of the way between them is between them. */
const BETWEEN = 0.25;
/** So near behind the other face, m, a room begins and no other face stands … */
const JUST_BEYOND = 0.1;
/** … if the ceiling hangs over so much of it. */
const ROOM_SHARE = 0.4;
/** So much of a niche's back was seen: the rest may be a window … */
const BACK_SHARE = 0.25;
/** … past its corners, m, where the faces beside a passage end. */
const NICHE_END = 0.1;
/** A niche is no deeper than this, m: deeper ones are rooms. */
const DEEPEST_NICHE = 0.75;

/**
 * Support of faces with what no point shows but the building tells: a wall goes on behind furniture, over a passage, to the
 * corner with another, and where its other face was seen.
 */
export function takenSupport(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  return withCorners(faces, goOn(faces, withPartners(faces, supports, seen), supports, seen), supports, seen);
}

/** Adds what a wall's other face tells of it. */
function withPartners(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  const known = supports.map(knownStretch);
  return supports.map((support, i) => {
    const face = faces[i];
    const others = faces.flatMap((other, j) => (j !== i && isParallel(face, other) ? [j] : []));
    const shares = support.shares.slice();
    for (const side of [1, -1]) {
      for (const stretch of backedStretches({ faces, supports, known, i, others, side })) {
        if (hidesAWall(face, stretch, seen)) for (const { k } of stretch) shares[k] = TAKEN_SHARE;
      }
    }
    return { ...support, shares };
  });
}

/** A bit of a face with a standing one behind it, signed distance along the face's normal. */
interface BackedBit {
  readonly k: number;
  readonly along: number;
  readonly aside: number;
}

interface Backing {
  readonly faces: readonly Face[];
  readonly supports: readonly FaceSupport[];
  readonly known: readonly KnownStretch[];
  readonly i: number;
  /** Those parallel to it. */
  readonly others: readonly number[];
  readonly side: number;
}

/** Where a face stands. */
interface KnownStretch {
  readonly bits: number;
  /** Bits from each bit to the nearest of them; infinite where there is none. */
  readonly ways: Float64Array;
}

function knownStretch({ shares }: FaceSupport): KnownStretch {
  const ways = new Float64Array(shares.length);
  let way = Infinity;
  const wayTo = (k: number) => {
    way = shares[k] >= WALL_SHARE ? 0 : way + 1;
    return way;
  };
  for (let k = 0; k < shares.length; k++) ways[k] = wayTo(k);
  way = Infinity;
  for (let k = shares.length - 1; k >= 0; k--) ways[k] = Math.min(ways[k], wayTo(k));
  return { bits: ways.filter((w) => w === 0).length, ways };
}

/**
 * The bits of a face that do not stand but have a standing face near on one side, by that face.
 *
 * Where the face was seen far off only and another line runs beside the standing one, too, that was seen nearer by and over
 * much more, the wall is as thick as that line tells.
 *
 * Not taken: whatever stands nearer by (areas of hard scenes 7.7 → 9.2 % off: sides of cupboards); nearer by and over more,
 * far off or not (rooms of what is beyond hard .94 → .87).
 */
function backedStretches({ faces, supports, known, i, others, side }: Backing): BackedBit[][] {
  const face = faces[i];
  const { from, step, shares } = supports[i];
  const asideTo = (other: Face, x: number, y: number) =>
    -side * asideOf(other, x, y) * Math.sign(face.nx * other.nx + face.ny * other.ny);
  const isKnownBetter = (
    j: number,
    { k, x, y, least }: { k: number; x: number; y: number; least: number },
  ) => {
    const thickness = least - asideTo(faces[j], x, y);
    const isAnother = Math.abs(thickness - least) >= THINNEST_WALL;
    if (!isAnother || thickness < THINNEST_WALL || thickness >= THICKEST_WALL) return false;
    const bit = Math.floor((alongOf(faces[j], x, y) - supports[j].from) / step);
    const isFar = known[i].ways[k] * step > FAR_OFF && known[j].ways[bit] < known[i].ways[k];
    return isFar && known[j].bits > MUCH_MORE * known[i].bits;
  };
  const byOther = new Map<number, BackedBit[]>();
  for (let k = 0; k < shares.length; k++) {
    if (shares[k] >= WALL_SHARE) continue;
    const along = from + (k + 0.5) * step;
    const [x, y] = pointOn(face, along);
    let [nearest, least] = [-1, THICKEST_WALL];
    for (const j of others) {
      const other = faces[j];
      const aside = asideTo(other, x, y);
      if (aside <= 0 || aside >= least || !wallAt(supports[j], alongOf(other, x, y))) continue;
      [nearest, least] = [j, aside];
    }
    if (nearest < 0 || least < THINNEST_WALL) continue;
    if (others.some((j) => isKnownBetter(j, { k, x, y, least }))) continue;
    const bit = { k, along, aside: side * least };
    const stretch = byOther.get(nearest);
    if (stretch) stretch.push(bit);
    else byOther.set(nearest, [bit]);
  }
  return [...byOther.values()];
}

/**
 * Whether there is a wall between a face and the one behind it: nothing seen between them, but room behind.
 *
 * Not taken: what was seen between as a share of what was seen before the face, as sparse scans show little of either (clean
 * corners at 5 cm .953 → .951, hard .697 → .690).
 */
function hidesAWall(face: Face, stretch: readonly BackedBit[], seen: SeenSpace): boolean {
  let [open, beyond] = [0, 0];
  for (const { along, aside } of stretch) {
    if (seen.at(...pointOn(face, along, aside / 2), BETWEEN * Math.abs(aside))) open++;
    if (seen.at(...pointOn(face, along, aside + Math.sign(aside) * JUST_BEYOND))) beyond++;
  }
  return open <= OPEN_SHARE * stretch.length && beyond >= ROOM_SHARE * stretch.length;
}

/** Lets walls go on over gaps between two stretches of them, unless another wall passes by at both ends: a corridor. */
function goOn(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  own: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  return supports.map((support, i) => {
    const { from, step } = support;
    const shares = support.shares.map((share, k) => (own[i].shares[k] >= WALL_SHARE ? 1 : share));
    const stretches = stretchesOf(support).filter((stretch) => !standsFree({ faces, own, i }, stretch, seen));
    stretches.slice(1).forEach((stretch, s) => {
      const [begin, end] = [stretches[s].to, stretch.from];
      if (!goesOnOver({ faces, own, i, begin, end }, seen)) return;
      const [first, last] = [begin, end].map((along) => Math.round((along - from) / step));
      for (let m = first; m < last; m++) shares[m] = Math.max(shares[m], TAKEN_SHARE);
    });
    return { ...support, shares };
  });
}

/** Stretches of a face that stand in one, as places along it, m. */
function stretchesOf({ from, step, shares }: FaceSupport): { readonly from: number; readonly to: number }[] {
  const stretches: { from: number; to: number }[] = [];
  for (let k = 0; k < shares.length; k++) {
    if (shares[k] < WALL_SHARE) continue;
    const last = stretches.at(-1);
    const [begin, end] = [from + k * step, from + (k + 1) * step];
    if (last && begin - last.to < step / 2) last.to = end;
    else stretches.push({ from: begin, to: end });
  }
  return stretches;
}

/**
 * Whether a stretch is the side of a column: short, and ceiling was seen past both of its ends; a wall in line with it does
 * not go on to it as over a passage.
 *
 * Not taken: floor as well as ceiling, and sides up to 0.8 m: piers between doors are taken for columns (rooms of a clean home
 * 1.00 → .89).
 */
function standsFree(
  line: FaceAmong,
  { from, to }: { readonly from: number; readonly to: number },
  seen: SeenSpace,
): boolean {
  const face = line.faces[line.i];
  const openAt = (along: number) =>
    [-BESIDE_COLUMN, 0, BESIDE_COLUMN].map((across) => seen.at(...pointOn(face, along, across)));
  const isFreePast = (end: number, past: number) =>
    !openAt(end + past).includes(false) && !meetsWall(line, end, past);
  if (to - from <= WIDEST_COLUMN && isFreePast(from, -PAST_COLUMN) && isFreePast(to, PAST_COLUMN))
    return true;
  const isRimPast = (end: number, way: number) => {
    const past = PAST_RIM.find((off) => {
      const [left, on, right] = openAt(end + way * off);
      return on && (left || right);
    });
    return past !== undefined && !meetsWall(line, end, way * past);
  };
  const isSeen = wallAt(line.own[line.i], (from + to) / 2);
  return isSeen && to - from <= LONGEST_RIM && isRimPast(from, -1) && isRimPast(to, 1);
}

/** Whether a wall that stands on both sides of a face's line crosses it between a place along it and one so far on, m. */
function meetsWall({ faces, own, i }: FaceAmong, along: number, past: number): boolean {
  return faces.some((other, j) => {
    const place = crossingOf(faces[i], other);
    if (place === null) return false;
    const share = (alongOf(faces[i], ...place) - along) / past;
    const there = alongOf(other, ...place);
    return (
      share > 0 && share < 1 && [-WIDEST_COLUMN, WIDEST_COLUMN].every((off) => wallAt(own[j], there + off))
    );
  });
}

/** One of the faces of a storey, and what is known of them. */
interface FaceAmong {
  readonly faces: readonly Face[];
  readonly own: readonly FaceSupport[];
  readonly i: number;
}

interface GapPlace extends FaceAmong {
  readonly begin: number;
  readonly end: number;
}

/** Whether a wall goes on over a gap: nothing was seen there, or it is a passage. */
function goesOnOver(gap: GapPlace, seen: SeenSpace): boolean {
  const { faces, i, begin, end } = gap;
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
  let [open, count] = [0, 0];
  for (let along = begin + PLACE / 2; along < end; along += PLACE) {
    count++;
    if (seen.at(...pointOn(face, along, across))) open++;
  }
  return open / Math.max(1, count);
}

/**
 * Whether a gap leads from room to room: it is narrower than the space on either side of it, and no wall stands behind it.
 *
 * A corridor that passes through, or the mouth of a wing, is as wide as the gap.
 */
function isPassage(gap: GapPlace): boolean {
  const { faces, own, i, begin, end } = gap;
  const isNarrowing = [1, -1].every((side) =>
    [begin, end].some((along) => !passesBy(faces, own, i, { along, side })),
  );
  if (!isNarrowing) return false;
  return ![1, -1].some((side) => hasNicheBack(gap, side));
}

/** Whether a wall stands behind a gap on one side, over most of its width but for a window. */
function hasNicheBack({ faces, own, i, begin, end }: GapPlace, side: number): boolean {
  const face = faces[i];
  const backs = faces.flatMap((other, j) => (i !== j && isParallel(face, other) ? [j] : []));
  const isBacked = (along: number) => {
    const [x, y] = pointOn(face, along);
    return backs.some((j) => {
      const turn = Math.sign(face.nx * faces[j].nx + face.ny * faces[j].ny);
      const aside = -side * turn * asideOf(faces[j], x, y);
      return aside > 0 && aside < DEEPEST_NICHE && wallAt(own[j], alongOf(faces[j], x, y));
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
function passesBy(
  faces: readonly Face[],
  own: readonly FaceSupport[],
  i: number,
  { along, side }: { readonly along: number; readonly side: number },
): boolean {
  const face = faces[i];
  return faces.some((other, j) => {
    const place = crossingOf(face, other);
    if (place === null || Math.abs(alongOf(face, ...place) - along) > NEAR_END) return false;
    const [x, y] = place;
    // There may be a door beside the gap.
    return PASSING.some((off) =>
      wallAt(own[j], alongOf(other, x + side * off * face.nx, y + side * off * face.ny)),
    );
  });
}

function wallAt({ from, step, shares }: FaceSupport, along: number): boolean {
  return (shares[Math.floor((along - from) / step)] ?? 0) >= WALL_SHARE;
}
