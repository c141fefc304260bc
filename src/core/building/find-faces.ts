import type { PointCloud } from '../types.ts';
import { columnDirections, turnBetween } from './column-directions.ts';
import { alongOf, asideOf, type Face, type Line, pointOn } from './face.ts';
import { type CurvedFace, fitArc } from './fit-arc.ts';
import { fitLine, reachOf } from './fit-line.ts';
import { growArc } from './grow-arc.ts';
import { columnAt, type HeightColumns } from './height-columns.ts';

/** Columns with hits in fewer of their bins are no wall … */
const LEAST_HITS = 0.3;
/** … unless so many of those below the ceiling are hit. */
const LEAST_TOP_HITS = 0.5;
/** Columns this far off a growing line belong to it, m: two deviations of a bad scan, less than half a thin wall. */
const BAND = 0.04;
/** A column whose own direction leaves the line by more than this, radians, belongs to another. */
const MOST_TURN = (20 * Math.PI) / 180;
/** A line ends where no column follows for longer than this, m: a door with its frame. */
const LONGEST_BREAK = 1.3;
/** Shortest face, m: the side of a slender column, a niche. */
const SHORTEST = 0.15;
/** A line this long is no chord of a curved wall, m: with a radius up to 10 m it would leave its band. */
const SURELY_STRAIGHT = 2;
/** Points scatter more than this across no arc, m: it would be a corner. */
const MOST_ARC_NOISE = 0.03;
/** Share of a face's length that has columns. */
const LEAST_FILLED = 0.35;

/** Columns of a storey that may belong to walls, and those that faces have taken. */
export interface WallColumns {
  readonly columns: HeightColumns;
  /** Direction of the normal; NaN where a column makes no line with its neighbours. */
  readonly angle: Float64Array;
  readonly isFree: Uint8Array;
}

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
 * face. Then the line is fitted robustly to the points. What lies in no long line may lie in an arc, and then in a short line. O(columns · log columns).
 */
export function findFaces(cloud: PointCloud, columns: HeightColumns): FoundFaces {
  const isFree = wallColumns(columns);
  const { angle, support } = columnDirections(columns, isFree);
  const walls: WallColumns = { columns, angle, isFree };
  const seeds = Uint32Array.from(isFree.keys()).filter((c) => support[c] > 0);
  seeds.sort((a, b) => support[b] - support[a] || a - b);
  const take = (members: readonly number[]) => {
    for (const c of members) isFree[c] = 0;
  };
  const straight: Face[] = [];
  const curved: CurvedFace[] = [];
  const growLines = (shortest: number) => {
    for (const seed of seeds) {
      const line = isFree[seed] === 1 ? growLine(walls, seed) : null;
      if (!line || line.to - line.from < shortest) continue;
      const face = fitLine(cloud, columns, line);
      if (!face) continue;
      take(line.members);
      straight.push(face);
    }
  };
  growLines(SURELY_STRAIGHT);
  for (const seed of seeds) {
    const arc = isFree[seed] === 1 ? growArc(walls, seed) : null;
    const face = arc && fitArc(cloud, columns, arc);
    if (!face || face.noise > MOST_ARC_NOISE) continue;
    take(face.members);
    curved.push(face);
  }
  growLines(SHORTEST);
  return { straight, curved };
}

function wallColumns({ count, hits, bins, topHits, topBins }: HeightColumns): Uint8Array {
  const isWall = new Uint8Array(count);
  for (let c = 0; c < count; c++) {
    isWall[c] = hits[c] >= LEAST_HITS * bins || topHits[c] >= LEAST_TOP_HITS * topBins ? 1 : 0;
  }
  return isWall;
}

/** Lets a line grow from a column. */
function growLine(walls: WallColumns, seed: number): Line | null {
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
    const members = columnsAlong(walls, line, Math.max(length, 0.3));
    if (members.length < 3) return null;
    const grown = throughColumns(columns, members);
    if (grown.to - grown.from <= length + size / 2) {
      const filled = members.length * size;
      return filled >= LEAST_FILLED * (grown.to - grown.from) ? grown : null;
    }
    line = grown;
  }
}

/** Columns along a line and beyond its ends, as far as they follow each other. */
function columnsAlong(walls: WallColumns, line: Line, reach: number): number[] {
  const { size } = walls.columns;
  const middle = (line.from + line.to) / 2;
  const found: number[] = [];
  const seen = new Set<number>();
  for (const side of [1, -1]) {
    const end = side === 1 ? line.to : line.from;
    const most = Math.abs(end - middle) + reach;
    let last = Math.abs(end - middle);
    for (let way = 0; way <= most && way - last <= LONGEST_BREAK; way += size / 2) {
      if (collect(walls, line, middle + side * way, { found, seen })) last = Math.max(last, way);
    }
  }
  return found;
}

interface Collected {
  readonly found: number[];
  readonly seen: Set<number>;
}

/** Takes up the columns across a line at a place along it; tells whether there are any. */
function collect(walls: WallColumns, line: Line, along: number, { found, seen }: Collected): boolean {
  const { columns, angle, isFree } = walls;
  const { centres, size } = columns;
  const normal = Math.atan2(line.ny, line.nx);
  let isAny = false;
  for (let across = -BAND; across <= BAND; across += size / 2) {
    const c = columnAt(columns, ...pointOn(line, along, across));
    if (c < 0 || isFree[c] === 0) continue;
    if (seen.has(c)) {
      isAny = true;
      continue;
    }
    if (Math.abs(asideOf(line, centres[2 * c], centres[2 * c + 1])) > BAND) continue;
    // Corners and clutter have no direction.
    if (!(turnBetween(angle[c], normal) <= MOST_TURN)) continue;
    seen.add(c);
    found.push(c);
    isAny = true;
  }
  return isAny;
}

/** Line of least squares through columns, by their hits. */
function throughColumns(columns: HeightColumns, members: readonly number[]): Line {
  const { centres, hits } = columns;
  let [sw, sx, sy] = [0, 0, 0];
  for (const c of members) {
    sw += hits[c];
    sx += hits[c] * centres[2 * c];
    sy += hits[c] * centres[2 * c + 1];
  }
  const [mx, my] = [sx / sw, sy / sw];
  let [xx, xy, yy] = [0, 0, 0];
  for (const c of members) {
    const [dx, dy] = [centres[2 * c] - mx, centres[2 * c + 1] - my];
    xx += hits[c] * dx * dx;
    xy += hits[c] * dx * dy;
    yy += hits[c] * dy * dy;
  }
  const tangent = 0.5 * Math.atan2(2 * xy, xx - yy);
  const [nx, ny] = [-Math.sin(tangent), Math.cos(tangent)];
  return { nx, ny, offset: mx * nx + my * ny, ...reachOf(columns, members, { nx, ny }), members };
}
