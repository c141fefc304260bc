import { weightedMedian } from '../../robust-scale.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { wallColumns } from '../columns/wall-columns.ts';
import { columnDirections } from './column-directions.ts';
import { asideOf, type Face, type FaceSite } from './face.ts';
import { withEnds } from './face-ends.ts';
import { withStubs } from './face-stubs.ts';
import { type CurvedFace, fitArc } from './fit-arc.ts';
import { fitLine } from './fit-line.ts';
import type { FreeColumns } from './free-columns.ts';
import { growArc } from './grow-arc.ts';
import { growLine } from './grow-line.ts';
import { findStraddling, type Straddling } from './straddling.ts';
import { arcsOverLines, isChord, wallArc } from './wall-arcs.ts';

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
