import type { StageContext } from '../context.ts';
import { centroid, perimeter, pointInPolygon, signedArea } from '../geometry/rings.ts';
import type { Options } from '../params.ts';
import type { Polygon, Ring, Slice } from '../types.ts';
import { facingSideSeen } from './facing-side.ts';
import { outlineStructure } from './outline-points.ts';
import { groupPoints, pointsOf } from './point-groups.ts';
import { type FoundStructure, type StructureSearch, typeOf } from './structure.ts';
import { findWallFaces, type WallFaces } from './wall-faces.ts';

/** Cells are this many mean spacings wide: points one to two cells apart hang together. */
const CELL_SPACINGS = 4;
/** Clear of the walls, faces of one structure may stand this many times further apart. */
const STRUCTURE_CELLS = 3;
/** What comes nearer to a wall than so many spacings may hang together with it. */
const TOUCH_SPACINGS = 3;
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
/** What touches a wall stands free of it when points show this share of the side that faces the wall. */
const FACING_SHARE = 0.6;

/**
 * Secondary boundaries as the outer faces of groups of points that stand free of the walls.
 *
 * Ours: neither clusters nor filter. Points that the faces of the walls explain go; what is left hangs together in
 * groups. A group that comes near a wall is a structure when its side facing the wall is seen, else part of the wall.
 * `secondaryCount` only says how many are wanted: those clear of the walls first, then the largest, free-standing
 * pieces of wall last. O(n) but for the outlines.
 *
 * @returns clusters: 0 for walls and what was not taken, 1 … for the structures in order
 */
export function findDetachedGroups(
  slice: Slice,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): StructureSearch {
  const { xy, spacing } = slice;
  const clusters = new Uint8Array(xy.length / 2);
  if (spacing === 0) return { clusters, found: [] };
  const faces = findWallFaces(slice, options, context);
  context.progress(0.5);
  const candidates = findGroups(xy, spacing, faces).flatMap((group): Candidate[] => {
    const points = pointsOf(xy, group.members);
    const found = outlineStructure(points, faces.noise, options, context);
    if (!found || !isStructure(found.ring, primary)) return [];
    const { ring: outline, isOpen } = found;
    if (group.isTouching && (isOpen || isWallPiece(outline))) return [];
    if (group.isTouching && facingSideSeen(outline, points, faces) < FACING_SHARE) return [];
    return [{ ...group, outline, type: typeOf(outline, points), points: group.members.length }];
  });
  candidates.sort(byLikelihood);
  const found = candidates.slice(0, options.secondaryCount);
  found.forEach(({ members }, k) => {
    for (const i of members) clusters[i] = k + 1;
  });
  return { clusters, found };
}

interface Group {
  /** Numbers of its points in the slice. */
  readonly members: Uint32Array;
  /** Comes so near to a wall that it may be part of it. */
  readonly isTouching: boolean;
}

type Candidate = FoundStructure & Group;

/** Groups off the walls: those clear of them, parts of a structure joined, and those that touch them. */
function findGroups(xy: Float64Array, spacing: number, faces: WallFaces): Group[] {
  const heights = Float64Array.from({ length: xy.length / 2 }, (_, i) => faces.heightAt(xy[2 * i], xy[2 * i + 1]));
  const off = Uint32Array.from(heights.keys()).filter((i) => heights[i] > faces.reach);
  const cell = CELL_SPACINGS * spacing;
  const touch = faces.reach + TOUCH_SPACINGS * spacing;
  const touching: Group[] = [];
  const clear: number[] = [];
  for (const members of partition(xy, off, cell)) {
    if (members.length < FEWEST_IN_CLUMP) continue;
    if (members.some((i) => heights[i] <= touch)) touching.push({ members, isTouching: true });
    else clear.push(...members);
  }
  const free = partition(xy, Uint32Array.from(clear), STRUCTURE_CELLS * cell);
  return [...free.map((members) => ({ members, isTouching: false })), ...touching].filter(
    ({ members }) => members.length >= FEWEST_POINTS,
  );
}

/** The points numbered, parted into what hangs together. */
function partition(xy: Float64Array, numbers: Uint32Array, cell: number): Uint32Array[] {
  const { start, members } = groupPoints(pointsOf(xy, numbers), cell);
  return Array.from({ length: start.length - 1 }, (_, group) =>
    members.subarray(start[group], start[group + 1]).map((k) => numbers[k]),
  );
}

function isStructure(outline: Ring, primary: readonly Polygon[]): boolean {
  const [x, y] = centroid(outline);
  const isInside = primary.some((polygon) => pointInPolygon(x, y, polygon) > 0);
  return isInside && signedArea(outline) >= (LEAST_WIDTH * perimeter(outline)) / 2;
}

/** Structures before pieces of wall, clear of the walls before touching, then by area; of equals the one further left. */
function byLikelihood(a: Candidate, b: Candidate): number {
  const pieces = Number(isWallPiece(a.outline)) - Number(isWallPiece(b.outline));
  const touching = Number(a.isTouching) - Number(b.isTouching);
  return pieces || touching || signedArea(b.outline) - signedArea(a.outline) || a.outline[0] - b.outline[0];
}

function isWallPiece(outline: Ring): boolean {
  return signedArea(outline) < WALL_COMPACTNESS * perimeter(outline) ** 2;
}
