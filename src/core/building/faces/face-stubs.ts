import { columnAt, type HeightColumns } from '../columns/height-columns.ts';
import { LEAST_HITS } from '../columns/wall-columns.ts';
import { asideOf, type Face, pointOn } from './face.ts';
import { reachOf } from './fit-line.ts';
import type { FreeColumns } from './free-columns.ts';

/** So far past the end of a long face, m, stubs of it are looked for: past a passage … */
const PAST_PASSAGE = 3;
/** … that are so long, m … */
const SHORTEST = 0.15;
/** … whose columns lie so near its line, m, or deviations of its points, and no farther apart than so many columns … */
const ON_LINE = 0.015;
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
  const { columns, isFree } = walls;
  const stubs = [1, -1].flatMap((way) => stubsPast(walls, face, way));
  if (stubs.length === 0) return face;
  for (const c of stubs) isFree[c] = 0;
  const members = [...face.members, ...stubs];
  return { ...face, members, ...reachOf(columns, members, face) };
}

function stubsPast({ columns, isFree }: FreeColumns, face: Face, way: number): number[] {
  const { centres, size } = columns;
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
    for (const across of [-onLine, 0, onLine]) {
      const c = wallColumnAt(columns, face, end + way * off, across);
      if (c < 0 || isFree[c] === 0 || run.includes(c)) continue;
      if (Math.abs(asideOf(face, centres[2 * c], centres[2 * c + 1])) > onLine) continue;
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
      AROUND_END.some((k) => wallColumnAt(columns, face, along + k * columns.size, side * off) >= 0),
    ),
  );
}

/** The column at a place along a face and off it, m, if more than furniture or a beam is in it; else −1. */
function wallColumnAt(columns: HeightColumns, face: Face, along: number, across: number): number {
  const c = columnAt(columns, ...pointOn(face, along, across));
  return c >= 0 && columns.hits[c] >= LEAST_HITS * columns.bins ? c : -1;
}
