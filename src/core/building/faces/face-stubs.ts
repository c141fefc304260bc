import type { HeightColumns } from '../columns/height-columns.ts';
import { freeOnLine, highColumnAt, ON_LINE, withMembers } from './columns-on-line.ts';
import type { Face } from './face.ts';
import type { FreeColumns } from './free-columns.ts';

/** So far past the end of a long face, m, stubs of it are looked for: past a passage … */
const PAST_PASSAGE = 3;
/** … that are so long, m … */
const SHORTEST = 0.15;
/** … whose columns lie on its line, or so many deviations of its points off it, and no farther apart than so many columns … */
const NOISES = 1;
const APART = 1.5;
/** … and that end at a wall which stands so far off the line, m, on both of its sides: a column does not. */
const CROSSING = [0.25, 0.35, 0.45, 0.55];
/** That wall is looked for so many columns before and past the end. */
const AROUND_END = [-2, -1, 0, 1, 2];

/**
 * A long face with the stubs of wall on its line past passages, which are too short to have a line of their own: theirs would
 * run from one face to the other. Takes them. O(columns of the line drawn on).
 */
export function withStubs(walls: FreeColumns, face: Face): Face {
  return withMembers(
    walls,
    face,
    [1, -1].flatMap((way) => stubsPast(walls, face, way)),
  );
}

function stubsPast(walls: FreeColumns, face: Face, way: number): number[] {
  const { columns } = walls;
  const { size } = columns;
  const end = way > 0 ? face.to : face.from;
  const onLine = Math.max(ON_LINE, NOISES * face.noise);
  const stubs: number[] = [];
  let run: number[] = [];
  let [first, last] = [0, 0];
  const close = () => {
    const isLong = run.length > 0 && last - first + size >= SHORTEST;
    if (isLong && isCrossedAt(columns, face, end + way * last)) stubs.push(...run);
    run = [];
  };
  for (let off = size; off < PAST_PASSAGE; off += size / 2) {
    for (const c of freeOnLine(walls, face, end + way * off, onLine)) {
      if (run.includes(c)) continue;
      if (run.length === 0) first = off;
      run.push(c);
      last = off;
    }
    if (off - last > APART * size) close();
  }
  close();
  return stubs;
}

function isCrossedAt(columns: HeightColumns, face: Face, along: number): boolean {
  return [1, -1].every((side) =>
    CROSSING.some((off) =>
      AROUND_END.some((k) => highColumnAt(columns, face, along + k * columns.size, side * off) >= 0),
    ),
  );
}
