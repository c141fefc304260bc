import { turnBetween } from './column-directions.ts';
import { alongOf, asideOf, endsOf, type Face } from './face.ts';

/** A face that scatters so many times as another it crosses … */
const NOISES = 1.5;
/** … turning by less than this from it, radians, … */
const MOST_TURN = Math.PI / 18;
/** … and coming so far off it to both sides, m, is no surface … */
const LEAST_ASIDE = 0.015;
/** … where both run side by side for so long, m; the other may end there only because the first took its columns. */
const LEAST_BESIDE = 0.5;
/** … unless that is so many times shorter and was seen so many times less densely: a picture on the wall. */
const TIMES_SHORTER = 4;
const TIMES_SPARSER = 4;

/** A face that is none, with one that is. */
export interface Straddling {
  readonly face: Face;
  readonly other: Face;
}

/**
 * Lines that run askew through both faces of a thin wall: surfaces do not cross at so sharp an angle. O(faces²).
 *
 * Without it a wall of an office is cut in two by a line that goes on over the corridor (corners of that floor at 5 cm .95 → .99).
 * Not taken: to drop such lines without growing others from what they leave (rooms of a furnished curved house .89 → .75).
 */
export function findStraddling(faces: readonly Face[]): Straddling[] {
  return faces.flatMap((face) => {
    const other = faces.find(
      (each) =>
        face.noise > NOISES * each.noise &&
        turnOf(face, each) < MOST_TURN &&
        crosses(face, each) &&
        !isOnWall(each, face),
    );
    return other ? [{ face, other }] : [];
  });
}

function turnOf(a: Face, b: Face): number {
  return turnBetween(Math.atan2(a.ny, a.nx), Math.atan2(b.ny, b.nx));
}

/** Whether a face is of something that hangs on another, of which little was seen. */
function isOnWall(face: Face, wall: Face): boolean {
  const [length, whole] = [face, wall].map(({ from, to }) => to - from);
  return TIMES_SHORTER * length < whole && (TIMES_SPARSER * face.support) / length < wall.support / whole;
}

/** Whether a face comes off to both sides of the line of another that it runs beside. */
function crosses(face: Face, other: Face): boolean {
  const ends = endsOf(face);
  const [from, to] = ends.map((end) => alongOf(other, ...end)).sort((a, b) => a - b);
  if (Math.min(to, other.to) - Math.max(from, other.from) < LEAST_BESIDE) return false;
  const [a, b] = ends.map((end) => asideOf(other, ...end));
  return a * b < 0 && Math.min(Math.abs(a), Math.abs(b)) > LEAST_ASIDE;
}
