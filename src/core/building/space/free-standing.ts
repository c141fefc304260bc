import type { SeenSpace } from '../columns/seen-space.ts';
import { alongOf, crossingOf, pointOn } from '../faces/face.ts';
import { type FaceAmong, wallAt } from '../faces/face-support.ts';

/** The side of a column is no longer than this, m, and space goes on this far past it, and to both sides of its line. */
const WIDEST_COLUMN = 0.6;
const PAST_COLUMN = 0.3;
const BESIDE_COLUMN = 0.1;
/** A line runs along the rim of a round column over no more than this, m: the column lies on one side, a wall may be near. */
const LONGEST_RIM = 0.25;
const PAST_RIM = [0.15, 0.3, 0.45];

/**
 * Whether a stretch is the side of a column: short, and ceiling was seen past both of its ends; a wall in line with it does
 * not go on to it as over a passage.
 *
 * Not taken: floor as well as ceiling, and sides up to 0.8 m: piers between doors are taken for columns (rooms of a clean home
 * 1.00 → .89).
 */
export function standsFree(
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
