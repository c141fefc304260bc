import { Moments } from '../../geometry/moments.ts';
import { weightedMedian } from '../../robust-scale.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { wallColumns } from '../columns/wall-columns.ts';
import { columnDirections } from './column-directions.ts';
import { alongOf, asideOf, type Face, type FaceSite, type Line, pointOn } from './face.ts';
import { withEnds } from './face-ends.ts';
import { withStubs } from './face-stubs.ts';
import { type CurvedFace, fitArc } from './fit-arc.ts';
import { fitLine, reachOf } from './fit-line.ts';
import { type Course, type FreeColumns, LONGEST_BREAK, takeAcross } from './free-columns.ts';
import { growArc } from './grow-arc.ts';
import { findStraddling, type Straddling } from './straddling.ts';
import { arcsOverLines, isChord, wallArc } from './wall-arcs.ts';

/** A column whose own direction leaves the line by more than this, radians, belongs to another. */
const MOST_TURN = (20 * Math.PI) / 180;
/** Shortest face, m: the side of a slender column, a niche. */
const SHORTEST = 0.15;
/** A line this long is no chord of a curved wall, m: with a radius up to 10 m it would leave its band. */
const SURELY_STRAIGHT = 2;
/** Points scatter across a wall no more than so many times what they usually do, or this, m: else it is clutter in a row. */
const WALL_NOISE_RATIO = 3;
const LEAST_WALL_NOISE = 0.02;
/** Across an arc they may less, and never more than the last, m: it would be a corner. */
const ARC_NOISE_RATIO = 1.7;
const LEAST_ARC_NOISE = 0.005;
const MOST_ARC_NOISE = 0.03;
/** Columns so near another face, m, or so many times its noise, are its own. */
const OTHERS = 0.03;
const NOISES = 2;
/** Fewer columns make no line. */
const FEWEST = 3;
/** A growing line is looked on past its ends by its own length, or by this, m. */
const LEAST_REACH = 0.3;
/** Share of a face's length that has columns. */
const LEAST_FILLED = 0.35;

/** Upright surfaces of a storey. */
export interface FoundFaces {
  readonly straight: readonly Face[];
  readonly curved: readonly CurvedFace[];
}

/**
 * Upright planes and cylinders of a storey seen from above.
 *
 * Lines grow from the columns that make the straightest lines with their neighbours: what follows along a line joins, the
 * line is fitted anew and grows on, at most by its own length at a time, so that it never leaves its wall for the other
 * face. Then the line is fitted robustly to the points. What lies in no long
 * line, or better in an arc than there, may lie in an arc, and then in a short line. O(columns · log columns).
 */
export function findFaces({ cloud, columns, ceiling }: FaceSite): FoundFaces {
  const isFree = wallColumns(columns, ceiling);
  const { angle, support } = columnDirections(columns, isFree);
  const walls: FreeColumns = { columns, angle, isFree };
  const seeds = Uint32Array.from(isFree.keys()).filter((c) => support[c] > 0);
  seeds.sort((a, b) => support[b] - support[a] || a - b);
  const take = (members: readonly number[]) => {
    for (const c of members) isFree[c] = 0;
  };
  const growLines = (shortest: number) => {
    const grown: Face[] = [];
    for (const seed of seeds) {
      const line = isFree[seed] === 1 ? growLine(walls, seed) : null;
      if (!line || line.to - line.from < shortest) continue;
      const face = fitLine(cloud, columns, line);
      if (!face) continue;
      take(line.members);
      grown.push(face);
    }
    return grown;
  };
  const longest = growLines(SURELY_STRAIGHT).map((face) => withStubs(walls, face));
  const usual = usualNoise(longest);
  const mostArcNoise = Math.min(MOST_ARC_NOISE, Math.max(LEAST_ARC_NOISE, ARC_NOISE_RATIO * usual));
  const growArcs = (grow: (seed: number) => CurvedFace | null) => {
    const grown: CurvedFace[] = [];
    for (const seed of seeds) {
      const arc = isFree[seed] === 1 ? grow(seed) : null;
      if (!arc || arc.noise > mostArcNoise) continue;
      take(arc.members);
      grown.push(arc);
    }
    return grown;
  };
  const { arcs, lines: long } = arcsOverLines({ cloud, walls, lines: longest, usual });
  const sure = [...arcs, ...growArcs((seed) => wallArc(cloud, walls, seed))];
  const bent = growArcs((seed) => anyArc(cloud, walls, seed));
  const mostNoise = Math.max(LEAST_WALL_NOISE, WALL_NOISE_RATIO * usual);
  const areWalls = (faces: readonly Face[]) =>
    faces.filter((face) => face.noise <= mostNoise && !isChord(columns, face, sure));
  const found = areWalls([...long, ...growLines(SHORTEST)]);
  const straddling = findStraddling(found);
  for (const each of straddling) for (const c of besideOther(columns, each)) isFree[c] = 1;
  const straight = found.filter((face) => straddling.every((each) => each.face !== face));
  const all = [...straight, ...areWalls(growLines(SHORTEST))];
  return { straight: all.map((face) => withEnds(walls, face)), curved: [...sure, ...bent] };
}

/** Columns of a line that is no surface which are not those of the one it crosses. */
function besideOther({ centres }: HeightColumns, { face, other }: Straddling): number[] {
  const band = Math.max(OTHERS, NOISES * other.noise);
  return [...face.members].filter((c) => Math.abs(asideOf(other, centres[2 * c], centres[2 * c + 1])) > band);
}

/** The arc that grows from a column, be it of a wall, a column or furniture. */
function anyArc(cloud: PointCloud, walls: FreeColumns, seed: number): CurvedFace | null {
  const arc = growArc(walls, seed, false);
  return arc && fitArc(cloud, walls.columns, arc);
}

/** The noise of the faces on which half of all points lie: walls, since clutter has fewer. */
function usualNoise(faces: readonly Face[]): number {
  if (faces.length === 0) return MOST_ARC_NOISE;
  return weightedMedian(
    faces.map(({ noise }) => noise),
    faces.map(({ support }) => support),
  );
}

/** Lets a line grow from a column. */
function growLine(walls: FreeColumns, seed: number): Line | null {
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
