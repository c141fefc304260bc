import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { alongOf, behindOf, type Face, isParallel, pointOn } from '../faces/face.ts';
import { type FaceSupport, TAKEN_SHARE, WALL_SHARE, wallAt } from '../faces/face-support.ts';
import { THICKEST_WALL, THINNEST_WALL } from './wall-corners.ts';

/** A line that was seen no nearer than this, m, tells a wall's thickness if none is known that was seen over so much more. */
const FAR_OFF = 2;
const MUCH_MORE = 2;
/** What was seen no farther from the middle between two faces than this share of the way between them is between them. */
const BETWEEN = 0.25;
/** So near behind the other face, m, a room begins and no other face stands … */
const JUST_BEYOND = 0.1;
/** … if the ceiling hangs over so much of it. */
const ROOM_SHARE = 0.4;

/** Adds what a wall's other face tells of it. */
export function withPartners(
  faces: readonly Face[],
  supports: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  const known = supports.map(knownStretch);
  return supports.map((support, i) => {
    const face = faces[i];
    const others = faces.flatMap((other, j) =>
      j !== i && isParallel(face, other) && runsNear(face, support, other, supports[j]) ? [j] : [],
    );
    const shares = support.shares.slice();
    for (const side of [1, -1]) {
      for (const stretch of backedStretches({ faces, supports, known, i, others, side })) {
        if (hidesAWall(face, stretch, seen)) for (const { k } of stretch) shares[k] = TAKEN_SHARE;
      }
    }
    return { ...support, shares };
  });
}

/** Whether a parallel face comes, somewhere along one, no farther from it than a wall is thick. */
function runsNear(face: Face, support: FaceSupport, other: Face, others: FaceSupport): boolean {
  const ends = [support.from, endOf(support)].map((along) => pointOn(face, along));
  const [from, to] = ends.map((end) => alongOf(other, ...end)).sort((a, b) => a - b);
  if (to < others.from || from > endOf(others)) return false;
  const [here, there] = ends.map((end) => behindOf(face, other, 1, end));
  return here * there < 0 || Math.min(Math.abs(here), Math.abs(there)) < THICKEST_WALL;
}

const endOf = ({ from, step, shares }: FaceSupport): number => from + shares.length * step;

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
  /** Those parallel to it and near. */
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
  const isKnownBetter = (
    j: number,
    { k, place, least }: { k: number; place: readonly [number, number]; least: number },
  ) => {
    const thickness = least - behindOf(face, faces[j], side, place);
    const isAnother = Math.abs(thickness - least) >= THINNEST_WALL;
    if (!isAnother || thickness < THINNEST_WALL || thickness >= THICKEST_WALL) return false;
    const bit = Math.floor((alongOf(faces[j], ...place) - supports[j].from) / step);
    const isFar = known[i].ways[k] * step > FAR_OFF && known[j].ways[bit] < known[i].ways[k];
    return isFar && known[j].bits > MUCH_MORE * known[i].bits;
  };
  const byOther = new Map<number, BackedBit[]>();
  for (let k = 0; k < shares.length; k++) {
    if (shares[k] >= WALL_SHARE) continue;
    const along = from + (k + 0.5) * step;
    const place = pointOn(face, along);
    let [nearest, least] = [-1, THICKEST_WALL];
    for (const j of others) {
      const other = faces[j];
      const aside = behindOf(face, other, side, place);
      if (aside <= 0 || aside >= least || !wallAt(supports[j], alongOf(other, ...place))) continue;
      [nearest, least] = [j, aside];
    }
    if (nearest < 0 || least < THINNEST_WALL) continue;
    if (others.some((j) => isKnownBetter(j, { k, place, least }))) continue;
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
