import { CellTable } from '../cell-table.ts';
import type { StageContext } from '../context.ts';
import { centroid, perimeter, pointInPolygon, signedArea } from '../geometry/rings.ts';
import type { Options } from '../params.ts';
import { joinTouchingCells } from '../touching-cells.ts';
import type { Polygon, Ring, Slice } from '../types.ts';
import { outlineStructure } from './outline-points.ts';
import {
  distanceToPolygons,
  type FoundStructure,
  pickPoints,
  type StructureSearch,
  typeOf,
} from './structure.ts';

/** Cells are this many mean spacings wide: points one to two cells apart hang together. */
const CELL_SPACINGS = 4;
/**
 * Points within this many cells of the primary boundary are wall, and so is whatever hangs together with
 * them.
 */
const WALL_CELLS = 2;
/** Clear of the walls, faces of one structure may stand this many times further apart. */
const STRUCTURE_CELLS = 3;
/** Smaller clumps are stray points, and smaller groups no structure. */
const FEWEST_IN_CLUMP = 4;
const FEWEST_POINTS = 8;
/** Thinner things are posts, poles and noise: area by half the perimeter, m. */
const LEAST_WIDTH = 0.05;
/**
 * Area by squared perimeter, 1/16 for a square: below this a group is a free-standing piece of wall (about 1
 * to 10).
 */
const WALL_COMPACTNESS = 0.02;

/**
 * Secondary boundaries as the outer faces of groups of points that stand free of the walls.
 *
 * Ours: neither clusters nor filter, so `secondaryCount` only says how many are wanted, the largest first,
 * free-standing pieces of wall last. O(n) but for the outlines.
 *
 * @returns clusters: 0 for walls and what was not taken, 1 … for the structures in order
 */
export function findDetachedGroups(
  { xy, spacing }: Slice,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): StructureSearch {
  const clusters = new Uint8Array(xy.length / 2);
  if (spacing === 0) return { clusters, found: [] };
  const cell = CELL_SPACINGS * spacing;
  const free = freePoints(xy, primary, cell);
  context.progress(0.5);
  const groupOf = groupPoints(free.xy, STRUCTURE_CELLS * cell);
  const { members, start } = groupMembers(free.xy, groupOf);
  const candidates: Candidate[] = [];
  for (let group = 0; group + 1 < start.length; group++) {
    const size = start[group + 1] - start[group];
    if (size < FEWEST_POINTS) continue;
    const points = members.slice(2 * start[group], 2 * start[group + 1]);
    const outline = outlineStructure(points, options, context);
    if (!outline || !isStructure(outline, primary)) continue;
    candidates.push({ group, outline, type: typeOf(outline, points), points: size });
  }
  candidates.sort(byLikelihood);
  const found = candidates.slice(0, options.secondaryCount);
  const clusterOf = new Map(found.map(({ group }, k) => [group, k + 1]));
  for (let k = 0; k < groupOf.length; k++) clusters[free.source[k]] = clusterOf.get(groupOf[k]) ?? 0;
  return { clusters, found };
}

interface Candidate extends FoundStructure {
  readonly group: number;
}

/** The points that do not hang together with the walls, without lone ones, and their numbers in the slice. */
function freePoints(xy: Float64Array, primary: readonly Polygon[], cell: number) {
  const groupOf = groupPoints(xy, cell);
  const { start } = groupMembers(xy, groupOf);
  const isWall = wallGroups(xy, groupOf, primary, WALL_CELLS * cell);
  const isFree = (i: number) => {
    const group = groupOf[i];
    return isWall[group] === 0 && start[group + 1] - start[group] >= FEWEST_IN_CLUMP;
  };
  const source = Uint32Array.from(groupOf.keys()).filter(isFree);
  return { xy: pickPoints(xy, isFree), source };
}

/** Group of each point: points in touching cells hang together. */
function groupPoints(xy: Float64Array, cell: number): Uint32Array {
  const table = new CellTable();
  const cellOf = new Uint32Array(xy.length / 2);
  for (let i = 0; i < cellOf.length; i++) {
    cellOf[i] = table.add(Math.floor(xy[2 * i] / cell), Math.floor(xy[2 * i + 1] / cell), 0);
  }
  const component = joinTouchingCells(table);
  return cellOf.map((at) => component[at]);
}

/** Points in the order of their groups, x, y each, and the first point of each group. */
function groupMembers(xy: Float64Array, groupOf: Uint32Array) {
  const groups = groupOf.reduce((most, group) => Math.max(most, group + 1), 0);
  const start = new Uint32Array(groups + 1);
  for (const group of groupOf) start[group + 1]++;
  for (let group = 0; group < groups; group++) start[group + 1] += start[group];
  const next = start.slice();
  const members = new Float64Array(xy.length);
  for (let i = 0; i < groupOf.length; i++) {
    const at = next[groupOf[i]]++;
    members[2 * at] = xy[2 * i];
    members[2 * at + 1] = xy[2 * i + 1];
  }
  return { members, start };
}

/** Groups with a point near or outside the primary boundary. */
function wallGroups(
  xy: Float64Array,
  groupOf: Uint32Array,
  primary: readonly Polygon[],
  reach: number,
): Uint8Array {
  const isWall = new Uint8Array(groupOf.length);
  for (let i = 0; i < groupOf.length; i++) {
    if (isWall[groupOf[i]] === 1) continue;
    const [x, y] = [xy[2 * i], xy[2 * i + 1]];
    const isInside = primary.some((polygon) => pointInPolygon(x, y, polygon) > 0);
    if (!isInside || distanceToPolygons(x, y, primary) <= reach) isWall[groupOf[i]] = 1;
  }
  return isWall;
}

function isStructure(outline: Ring, primary: readonly Polygon[]): boolean {
  const [x, y] = centroid(outline);
  const isInside = primary.some((polygon) => pointInPolygon(x, y, polygon) > 0);
  return isInside && signedArea(outline) >= (LEAST_WIDTH * perimeter(outline)) / 2;
}

/** Compact structures before pieces of wall, then by area; of equals the one further left. */
function byLikelihood(a: Candidate, b: Candidate): number {
  const pieces = Number(isWallPiece(a.outline)) - Number(isWallPiece(b.outline));
  return pieces || signedArea(b.outline) - signedArea(a.outline) || a.outline[0] - b.outline[0];
}

function isWallPiece(outline: Ring): boolean {
  return signedArea(outline) < WALL_COMPACTNESS * perimeter(outline) ** 2;
}
