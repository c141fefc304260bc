import { weightedMedian } from '../../robust-scale.ts';
import type { Polygon } from '../../types.ts';
import { isSharp } from '../faces/ceiling-across.ts';
import { ceilingBehind } from '../faces/ceiling-behind.ts';
import { alongOf, behindOf, endsOf, isParallel, pointOn } from '../faces/face.ts';
import { type FaceSupport, STEP, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { pairFaces, USUAL_THICKNESS } from '../walls/pair-faces.ts';
import { edgesOf } from '../walls/room-edges.ts';
import { type BlindSite, blindSide } from './blind-side.ts';
import type { FoundRooms, WallFace, WallFaces } from './found-rooms.ts';
import { THICKEST_WALL, THINNEST_WALL } from './wall-corners.ts';

/** What is seen over less than this, m, may be a column or furniture, and no wall. */
const SHORTEST_WALL = 0.6;
/** The beginning of the ceiling behind a wall is told this well, m. */
const CEILING_ERROR = 0.03;
/** A wall's other face was seen so near a stretch that lacks it, m. */
const MOST_APART = 4;
/** The ceiling is known to end at a wall within a room along so much of it. */
const KNOWN_SHARE = 0.25;
/** Shortest stretch that lacks a back, m. */
const SHORTEST = 0.2;
/** How far the back is drawn on past the stretch, m: to the walls at its ends. */
const OVERLAP = 0.3;

/**
 * The other faces of walls that have room on both sides and no thickness: seen from one side only.
 *
 * The wall stands on the side where neither floor nor ceiling was seen beside the face. Its other face is where it was seen
 * elsewhere along the wall, or else as far as the storey's other walls are thick, and no farther than where the ceiling behind
 * begins. Within one room only what is a wall for sure has one: furniture stands there. O(faces · stretches + points of the
 * ceilings beside).
 *
 * Not taken: as thick as other walls, whatever was seen of this one elsewhere (clean corners at 5 cm .966 → .953, hard .676 →
 * .659 and .690 → .649: jogs); within a room as between two (hard .697 → .676: cupboards become stubs), or never (clean .965 →
 * .961: real stubs go).
 *
 * @param walls the faces that `found` was made of
 */
export function missingBacks(found: FoundRooms, walls: WallFaces, site: BlindSite): WallFaces {
  const thickness = usualThickness(found.rooms.map(({ outline }) => outline));
  const backs = [...sharedStretches(found)].flatMap(([line, stretches]) =>
    stretches.flatMap((stretch) => backOf({ line, ...stretch }, walls, site, thickness) ?? []),
  );
  return { faces: backs.map(({ face }) => face), supports: backs.map(({ support }) => support) };
}

interface Back {
  readonly face: WallFace;
  readonly support: FaceSupport;
}

function backOf(stretch: LineStretch, walls: WallFaces, site: BlindSite, usual: number): Back | null {
  const { line, from, to, isParting } = stretch;
  const face = walls.faces[line];
  const side = blindSide(site, face, from, to);
  if (side === 0) return null;
  const thickest = ceilingBehind(site.cloud, site.columns, face, { from, to, side });
  const other = otherFace(walls.faces, stretch, side, Math.min(THICKEST_WALL, thickest + CEILING_ERROR));
  if (other === null && !isParting && !isWallWithin(walls, stretch)) return null;
  const thickness = Math.max(THINNEST_WALL, Math.min(usual, thickest));
  const back = other ?? { ...face, offset: face.offset + side * thickness };
  const [low, high] = [from, to].map((along) => alongOf(back, ...pointOn(face, along))).sort((a, b) => a - b);
  const shares = new Float64Array(Math.ceil((to - from + 2 * OVERLAP) / STEP)).fill(TAKEN_SHARE);
  return {
    face: { ...back, from: low, to: high, reach: OVERLAP, members: [], support: 0 },
    support: {
      from: low - OVERLAP,
      step: STEP,
      shares,
      isSeen: new Uint8Array(shares.length),
      ceiling: new Float64Array(shares.length).fill(Number.NaN),
    },
  };
}

/** The other face of a wall, seen elsewhere along it: the nearest to a stretch that lacks it; null where none was. */
function otherFace(
  faces: readonly WallFace[],
  { line, from, to }: LineStretch,
  side: number,
  thickest: number,
): WallFace | null {
  const face = faces[line];
  let [best, least] = [null as WallFace | null, MOST_APART];
  for (const other of faces) {
    if (other === face || other.arc || !isParallel(face, other)) continue;
    const aside = behindOf(face, other, side, pointOn(face, (from + to) / 2));
    if (aside < THINNEST_WALL || aside > thickest) continue;
    const [low, high] = endsOf(other)
      .map((end) => alongOf(face, ...end))
      .sort((a, b) => a - b);
    if (Math.min(high, face.to) - Math.max(low, face.from) < SHORTEST_WALL) continue;
    const apart = Math.max(0, low - to, from - high);
    if (apart < least) [best, least] = [other, apart];
  }
  return best;
}

/** The thickness that half the length of the inner walls between rooms has, or less: stubs are many, walls are long. */
export function usualThickness(rooms: readonly Polygon[]): number {
  const pairs = pairFaces(edgesOf(rooms));
  if (pairs.length === 0) return USUAL_THICKNESS;
  return weightedMedian(
    pairs.map(({ thickness }) => thickness),
    pairs.map(({ from, to }) => to - from),
  );
}

/** Whether a stretch within a room is a wall's all the same: long, and the ceiling is known to end along it. */
function isWallWithin({ faces, supports }: WallFaces, { line, from, to }: LineStretch): boolean {
  if (to - from < SHORTEST_WALL || !isSharp(faces[line])) return false;
  const { from: first, step, ceiling } = supports[line];
  const bits = ceiling.subarray(
    Math.max(0, Math.floor((from - first) / step)),
    Math.ceil((to - first) / step),
  );
  const known = bits.filter((share) => !Number.isNaN(share));
  const ending = known.filter((share) => share < WALL_SHARE);
  return known.length >= KNOWN_SHARE * bits.length && ending.length > known.length / 2;
}

/** A stretch of a line with room on both sides of it. */
interface Stretch {
  readonly from: number;
  readonly to: number;
  /** It parts two rooms, not one from itself. */
  readonly isParting: boolean;
}

/** … and which line. */
interface LineStretch extends Stretch {
  readonly line: number;
}

/** Stretches of lines that have room on both sides. */
function sharedStretches({ arrangement, support, space, faces, rooms }: FoundRooms): Map<number, Stretch[]> {
  const { x, y, origin, face, lines } = arrangement;
  const roomOf = new Int32Array(space.isRoom.length).fill(-1);
  rooms.forEach((room, i) => {
    for (const f of room.faces) roomOf[f] = i;
  });
  const found = new Map<number, Stretch[]>();
  for (let e = 0; e < support.length; e++) {
    const [f, g] = [face[2 * e], face[2 * e + 1]];
    if (f < 0 || g < 0 || space.isRoom[f] === 0 || space.isRoom[g] === 0 || support[e] < WALL_SHARE) continue;
    const line = lines[e].find((own) => own >= 0);
    if (line === undefined) continue;
    const [from, to] = [origin[2 * e], origin[2 * e + 1]]
      .map((v) => alongOf(faces[line], x[v], y[v]))
      .sort((a, b) => a - b);
    const known = found.get(line) ?? [];
    known.push({ from, to, isParting: roomOf[f] < 0 || roomOf[f] !== roomOf[g] });
    found.set(line, known);
  }
  for (const [line, stretches] of found)
    found.set(
      line,
      merged(stretches).filter(({ from, to }) => to - from >= SHORTEST),
    );
  return found;
}

function merged(stretches: readonly Stretch[]): Stretch[] {
  const joined: Stretch[] = [];
  for (const stretch of [...stretches].sort((a, b) => a.from - b.from)) {
    const last = joined[joined.length - 1];
    if (last && stretch.from <= last.to + STEP) {
      const isParting = last.isParting || stretch.isParting;
      joined[joined.length - 1] = { from: last.from, to: Math.max(last.to, stretch.to), isParting };
    } else joined.push(stretch);
  }
  return joined;
}
