import { OPEN_SHARE, type SeenSpace } from '../columns/seen-space.ts';
import { alongOf, asideOf, endsOf, pointOn } from '../faces/face.ts';
import { type FaceSupport, TAKEN_SHARE, WALL_SHARE } from '../faces/face-support.ts';
import type { WallFace, WallFaces } from './found-rooms.ts';
import { NEAR_END } from './wall-corners.ts';

/** A curve is drawn past the line of the wall it ends at by so much, m: the two are sure to cross. */
const PAST = 0.02;

/** The chords of a curved wall up to the walls that it is drawn on to: what is past the first that stands is cut off. O(chords · walls). */
export function endedAtWalls(chords: readonly WallFace[], walls: WallFaces): WallFace[] {
  const firstSeen = chords.findIndex(({ support }) => support > 0);
  const lastSeen = chords.findLastIndex(({ support }) => support > 0);
  const meets = chords.map((chord) => walls.faces.flatMap((_, i) => crossingWith(chord, walls, i) ?? []));
  const isMet = meets.map(({ length }) => length > 0);
  const before = isMet.lastIndexOf(true, firstSeen);
  const after = isMet.indexOf(true, lastSeen);
  return chords.flatMap((chord, k) => {
    if (k < before || (after >= 0 && k > after)) return [];
    if (chord.support > 0) return [chord];
    if (k === before) return [{ ...chord, from: Math.max(chord.from, Math.max(...meets[k]) - PAST) }];
    return k === after ? [{ ...chord, to: Math.min(chord.to, Math.min(...meets[k]) + PAST) }] : [chord];
  });
}

/** Where along a chord it crosses a wall's line, m, if that stands near; null elsewhere. */
function crossingWith(chord: WallFace, { faces, supports }: WallFaces, i: number): number | null {
  const [a, b] = endsOf(chord);
  const [asideA, asideB] = [asideOf(faces[i], ...a), asideOf(faces[i], ...b)];
  if (asideA > 0 === asideB > 0) return null;
  const share = asideA / (asideA - asideB);
  const along = (1 - share) * alongOf(faces[i], ...a) + share * alongOf(faces[i], ...b);
  const { from, step, shares } = supports[i];
  const [low, high] = [-NEAR_END, NEAR_END].map((off) => Math.floor((along + off - from) / step));
  const isStanding = shares
    .subarray(Math.max(0, low), Math.max(0, high + 1))
    .some((own) => own >= WALL_SHARE);
  return isStanding ? chord.from + share * (chord.to - chord.from) : null;
}

/**
 * Support of chords with what their curve tells: it goes on where no space is seen, as straight walls do behind furniture
 * and to the corner with another. O(bits of chords).
 */
export function withCurves(
  faces: readonly WallFace[],
  supports: readonly FaceSupport[],
  seen: SeenSpace,
): FaceSupport[] {
  return supports.map((support, i) => {
    const { from, step, shares } = support;
    if (!faces[i].arc) return support;
    let open = 0;
    for (let k = 0; k < shares.length; k++) {
      if (shares[k] < WALL_SHARE && seen.at(...pointOn(faces[i], from + (k + 0.5) * step))) open++;
    }
    if (open > OPEN_SHARE * shares.length) return support;
    return { ...support, shares: shares.map((share) => Math.max(share, TAKEN_SHARE)) };
  });
}
