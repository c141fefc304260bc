import { turnOn } from '../../geometry/circle.ts';
import { medianOf } from '../../robust-scale.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { SMALLEST_RADIUS } from './chords.ts';
import { turnBetween } from './column-directions.ts';
import type { Face } from './face.ts';
import { type Arc, type CurvedFace, fitArc, reachAround } from './fit-arc.ts';
import type { FreeColumns } from './free-columns.ts';
import { growArc, isArc } from './grow-arc.ts';

/** Columns tell their wall's direction this well, radians: a dozen, each 15 mm off, over 0.6 m. */
const MOST_DIRECTION_ERROR = (1.5 * Math.PI) / 180;
/** A line is doubtful where its points scatter so many times as much as walls' do: a chord takes some of both faces … */
const DOUBTFUL = 1.25;
/** … and gives way to an arc across which they scatter so many times less. */
const BETTER = 1.25;
/** A line is covered when so many of its columns are on arcs … */
const COVERED = 0.5;
/** … as far off as this, m, or so many deviations of the arc's points. */
const BESIDE = 0.04;
const DEVIATIONS = 3;
/** So many of a line's columns, evenly along it, are tried as seeds of arcs. */
const TRIES = 8;

/**
 * The curved wall that grows from a column, fitted to its points; null where none does. O(columns and points of the arc).
 *
 * Furniture in a row bends as well: the columns of a wall look along it, each for itself.
 */
export function wallArc(cloud: PointCloud, walls: FreeColumns, seed: number): CurvedFace | null {
  const { columns } = walls;
  const grown = growArc(walls, seed, true);
  const fitted = grown && fitArc(cloud, columns, grown);
  if (!fitted || fitted.radius < SMALLEST_RADIUS) return null;
  const face = { ...fitted, ...reachAround(columns, fitted.members, fitted), isSure: true };
  return isArc(columns, face) && facesItsCentre(walls, face) ? face : null;
}

function facesItsCentre({ columns, angle }: FreeColumns, { cx, cy, members }: Arc): boolean {
  const { centres } = columns;
  const turns = Float64Array.from(members, (c) =>
    turnBetween(angle[c], Math.atan2(centres[2 * c + 1] - cy, centres[2 * c] - cx)),
  );
  return medianOf(turns) <= MOST_DIRECTION_ERROR;
}

/** Lines and the arcs that take the place of others. */
export interface ArcsOverLines {
  readonly arcs: readonly CurvedFace[];
  readonly lines: readonly Face[];
}

interface Search {
  readonly cloud: PointCloud;
  /** Nothing on the lines is free. */
  readonly walls: FreeColumns;
  readonly lines: readonly Face[];
  /** What points of walls usually scatter across them, m. */
  readonly usual: number;
}

/**
 * Arcs that explain the points of lines better than those do: a long line along a curved wall is its chord.
 *
 * Lines whose points scatter more than those of walls do are let go for a try; the ones that no arc covers stay as they are.
 * O(columns of doubtful lines), times those of an arc for each that grows none.
 */
export function arcsOverLines({ cloud, walls, lines, usual }: Search): ArcsOverLines {
  const { isFree, columns } = walls;
  const doubtful = lines.filter(({ noise }) => noise > DOUBTFUL * usual);
  const mark = (members: readonly number[], free: 0 | 1) => {
    for (const c of members) isFree[c] = free;
  };
  for (const { members } of doubtful) mark(members, 1);
  const arcs: CurvedFace[] = [];
  for (const seed of doubtful.flatMap(seedsAlong)) {
    const face = isFree[seed] === 1 ? wallArc(cloud, walls, seed) : null;
    if (!face || !isBetter(face, doubtful)) continue;
    mark(face.members, 0);
    arcs.push(face);
  }
  const kept = lines.filter((line) => !isChord(columns, line, arcs));
  for (const { members } of kept) mark(members, 0);
  return { arcs, lines: kept };
}

/** Whether a line stands on what belongs to arcs: their chord, or the fringe of their noise. O(columns of the line · arcs). */
export function isChord({ centres, size }: HeightColumns, line: Face, arcs: readonly CurvedFace[]): boolean {
  const isOn = (c: number, { cx, cy, radius, noise, from, to }: CurvedFace) => {
    const [dx, dy] = [centres[2 * c] - cx, centres[2 * c + 1] - cy];
    if (Math.abs(Math.hypot(dx, dy) - radius) > Math.max(BESIDE, DEVIATIONS * noise) + size / 2) return false;
    return turnOn(from, Math.atan2(dy, dx)) <= to - from;
  };
  const on = line.members.filter((c) => arcs.some((arc) => isOn(c, arc)));
  return on.length >= COVERED * line.members.length;
}

function seedsAlong({ members }: Face): number[] {
  return Array.from({ length: TRIES }, (_, k) => members[Math.floor(((k + 0.5) / TRIES) * members.length)]);
}

/** Whether the points that an arc takes from lines, of as much as half a line, scatter clearly less across it. */
function isBetter(arc: CurvedFace, lines: readonly Face[]): boolean {
  const own = new Set(arc.members);
  let [covered, noise] = [0, 0];
  for (const line of lines) {
    const share = shareIn(line.members, own);
    covered += share;
    noise += share * line.noise;
  }
  return covered >= COVERED && noise >= BETTER * arc.noise * covered;
}

function shareIn(members: readonly number[], set: ReadonlySet<number>): number {
  return members.filter((c) => set.has(c)).length / members.length;
}
