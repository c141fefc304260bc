import { weightedMedian } from '../../robust-scale.ts';
import type { Polygon } from '../../types.ts';
import { type HeightColumns, hasPlane } from '../columns/height-columns.ts';
import { alongOf, pointOn } from '../faces/face.ts';
import { type FaceSupport, STEP, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import { pairFaces } from '../walls/pair-faces.ts';
import { edgesOf } from '../walls/room-edges.ts';
import type { FoundRooms, WallFace, WallFaces } from './found-rooms.ts';

/** Thickness of an inner wall where no other tells, m: a stud wall. */
const USUAL_THICKNESS = 0.12;
/** Shortest stretch that lacks a back, m. */
const SHORTEST = 0.2;
/** How far the back is drawn on past the stretch, m: to the walls at its ends. */
const OVERLAP = 0.3;
/** A back's side shows floor or ceiling over less than this share of what the other side does. */
const BLIND_SHARE = 0.5;
/** So near a face, m, is its own noise; so far off ends the thinnest wall's inside. */
const NEAR = 0.03;
const FAR = 0.08;

/**
 * The other faces of walls that two rooms share without a thickness: seen from one room only.
 *
 * The wall stands on the side where neither floor nor ceiling was seen beside the face; its thickness is that of the
 * storey's other walls.
 */
export function missingBacks(found: FoundRooms, columns: HeightColumns): WallFaces {
  const thickness = usualThickness(found.rooms.map(({ outline }) => outline));
  const faces: WallFace[] = [];
  const supports: FaceSupport[] = [];
  for (const [line, stretches] of sharedStretches(found)) {
    for (const [from, to] of stretches) {
      const face = found.faces[line];
      const side = blindSide(columns, face, from, to);
      if (side === 0) continue;
      faces.push({
        ...face,
        offset: face.offset + side * thickness,
        from,
        to,
        reach: OVERLAP,
        members: [],
        support: 0,
      });
      const shares = new Float64Array(Math.ceil((to - from + 2 * OVERLAP) / STEP)).fill(TAKEN_SHARE);
      supports.push({
        from: from - OVERLAP,
        step: STEP,
        shares,
        isSeen: new Uint8Array(shares.length),
        ceiling: new Float64Array(shares.length).fill(Number.NaN),
      });
    }
  }
  return { faces, supports };
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

/** Stretches of lines along which two rooms meet at a wall. */
function sharedStretches({
  arrangement,
  support,
  space,
  faces,
}: FoundRooms): Map<number, [number, number][]> {
  const { x, y, origin, face, lines } = arrangement;
  const found = new Map<number, [number, number][]>();
  for (let e = 0; e < support.length; e++) {
    const [f, g] = [face[2 * e], face[2 * e + 1]];
    if (f < 0 || g < 0 || space.isRoom[f] === 0 || space.isRoom[g] === 0 || support[e] < WALL_SHARE) continue;
    const line = lines[e].find((own) => own >= 0);
    if (line === undefined) continue;
    const ends = [origin[2 * e], origin[2 * e + 1]]
      .map((v) => alongOf(faces[line], x[v], y[v]))
      .sort((a, b) => a - b);
    const known = found.get(line) ?? [];
    known.push([ends[0], ends[1]]);
    found.set(line, known);
  }
  for (const [line, stretches] of found)
    found.set(
      line,
      merged(stretches).filter(([from, to]) => to - from >= SHORTEST),
    );
  return found;
}

function merged(stretches: [number, number][]): [number, number][] {
  const joined: [number, number][] = [];
  for (const [from, to] of stretches.sort((a, b) => a[0] - b[0])) {
    const last = joined[joined.length - 1];
    if (last && from <= last[1] + STEP) last[1] = Math.max(last[1], to);
    else joined.push([from, to]);
  }
  return joined;
}

/** The side of a face on which nothing was seen: 1, −1, or 0 where both sides or none were. */
export function blindSide(columns: HeightColumns, face: WallFace, from: number, to: number): 1 | -1 | 0 {
  const seen = [1, -1].map((side) => {
    let count = 0;
    for (let along = from + STEP / 2; along < to; along += STEP) {
      for (let across = NEAR; across <= FAR; across += (FAR - NEAR) / 2) {
        if (hasPlane(columns, ...pointOn(face, along, side * across))) count++;
      }
    }
    return count;
  });
  if (seen[0] < BLIND_SHARE * seen[1]) return 1;
  return seen[1] < BLIND_SHARE * seen[0] ? -1 : 0;
}
