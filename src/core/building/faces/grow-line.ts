import { Moments } from '../../geometry/moments.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { alongOf, asideOf, type Line, pointOn } from './face.ts';
import { reachOf } from './fit-line.ts';
import { type Course, type FreeColumns, LONGEST_BREAK, takeAcross } from './free-columns.ts';

/** A column whose own direction leaves the line by more than this, radians, belongs to another. */
const MOST_TURN = (20 * Math.PI) / 180;
/** Fewer columns make no line. */
const FEWEST = 3;
/** A growing line is looked on past its ends by its own length, or by this, m. */
const LEAST_REACH = 0.3;
/** Share of a face's length that has columns. */
const LEAST_FILLED = 0.35;

/** The line that grows from a free column, by its own length at a time at most; null where none does. O(columns of the line). */
export function growLine(walls: FreeColumns, seed: number): Line | null {
  const { columns, angle } = walls;
  const { centres, size } = columns;
  const [nx, ny] = [Math.cos(angle[seed]), Math.sin(angle[seed])];
  const at = alongOf({ nx, ny }, centres[2 * seed], centres[2 * seed + 1]);
  let line: Line = {
    nx,
    ny,
    offset: centres[2 * seed] * nx + centres[2 * seed + 1] * ny,
    from: at - 2 * size,
    to: at + 2 * size,
    members: [],
  };
  for (;;) {
    const length = line.to - line.from;
    const members = columnsAlong(walls, line, Math.max(length, LEAST_REACH));
    if (members.length < FEWEST) return null;
    const grown = throughColumns(columns, members);
    if (grown.to - grown.from <= length + size / 2) {
      const filled = members.length * size;
      return filled >= LEAST_FILLED * (grown.to - grown.from) ? grown : null;
    }
    line = grown;
  }
}

/** Columns along a line and beyond its ends, as far as they follow each other. */
function columnsAlong(walls: FreeColumns, line: Line, reach: number): number[] {
  const { size } = walls.columns;
  const middle = (line.from + line.to) / 2;
  const normal = Math.atan2(line.ny, line.nx);
  const course: Course = {
    pointAt: (along, across) => pointOn(line, along, across),
    asideOf: (x, y) => asideOf(line, x, y),
    normalAt: () => normal,
    mostTurn: MOST_TURN,
  };
  const found = new Set<number>();
  for (const side of [1, -1]) {
    const end = side === 1 ? line.to : line.from;
    const most = Math.abs(end - middle) + reach;
    let last = Math.abs(end - middle);
    for (let way = 0; way <= most && way - last <= LONGEST_BREAK; way += size / 2) {
      if (takeAcross(walls, course, middle + side * way, found)) last = Math.max(last, way);
    }
  }
  return [...found];
}

/** Line of least squares through columns, by their hits. */
function throughColumns(columns: HeightColumns, members: readonly number[]): Line {
  const { centres, hits } = columns;
  const [x0, y0] = [centres[2 * members[0]], centres[2 * members[0] + 1]];
  const moments = new Moments();
  for (const c of members) moments.add(centres[2 * c] - x0, centres[2 * c + 1] - y0, hits[c]);
  const { x, y, angle } = moments.spread();
  const [nx, ny] = [-Math.sin(angle), Math.cos(angle)];
  return { nx, ny, offset: (x0 + x) * nx + (y0 + y) * ny, ...reachOf(columns, members, { nx, ny }), members };
}
