import type { SeenSpace } from '../columns/seen-space.ts';
import { alongOf, asideOf, isParallel, pointOn } from '../faces/face.ts';
import { WALL_SHARE } from '../faces/face-support.ts';
import { NO_LINE, type Segment } from './cut-segments.ts';
import type { WallFace, WallFaces } from './found-rooms.ts';

/** Thickest wall that may end, m. */
const THICKEST = 0.6;
/** Nearer faces are one, m. */
const THINNEST = 0.03;
/** Shortest stretch of wall whose ends count, m, and longest break in it. */
const SHORTEST = 0.2;
const LONGEST_BREAK = 0.15;
/** A wall ends where space was seen from so far past it, m, to so far, over most of the way. */
const PAST_FROM = 0.1;
const PAST_TO = 0.35;
/** A stroke is longer than the wall is thick by this at each side, m, so that it surely meets both faces. */
const OVERLAP = 0.01;

/**
 * Short strokes across a wall where it ends in the open, from its face to the one behind: at a niche, a passage, a stub.
 *
 * They let the subdivision end a wall there even where too little of its reveal was seen to be a face. O(faces · ends).
 */
export function wallEnds({ faces, supports }: WallFaces, seen: SeenSpace): Segment[] {
  return faces.flatMap((face, i) =>
    face.reach === 0
      ? []
      : endsAlong(supports[i].shares, supports[i].step).flatMap(({ bit, way }) => {
          const along = supports[i].from + bit * supports[i].step;
          if (!isOpenPast(face, along, way, seen)) return [];
          return [1, -1].flatMap((side) => strokeTo(face, faces, along, side) ?? []);
        }),
  );
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
  let [open, count] = [0, 0];
  for (let past = PAST_FROM; past < PAST_TO; past += 0.05) {
    count++;
    if (seen.isOpen(...pointOn(face, along + way * past))) open++;
  }
  return open > count / 2;
}

/** The stroke from a face to the nearest one parallel to it on one side; null where none is near. */
function strokeTo(face: WallFace, faces: readonly WallFace[], along: number, side: number): Segment | null {
  const [x, y] = pointOn(face, along);
  let nearest = Infinity;
  for (const other of faces) {
    if (other === face || !isParallel(face, other)) continue;
    const aside = -side * asideOf(other, x, y) * Math.sign(face.nx * other.nx + face.ny * other.ny);
    const there = alongOf(other, x, y);
    const isBeside = there > other.from - other.reach && there < other.to + other.reach;
    if (isBeside && aside > THINNEST) nearest = Math.min(nearest, aside);
  }
  if (nearest > THICKEST) return null;
  const [ax, ay] = pointOn(face, along, -side * OVERLAP);
  const [bx, by] = pointOn(face, along, side * (nearest + OVERLAP));
  return { ax, ay, bx, by, line: NO_LINE };
}
