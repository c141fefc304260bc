import type { StageContext } from '../context.ts';
import { convexHull } from '../geometry/convex-hull.ts';
import { centroid, perimeter, pointInPolygon, signedArea } from '../geometry/rings.ts';
import type { Options } from '../params.ts';
import type { Polygon, Ring, Slice } from '../types.ts';
import { facingShare } from './facing-share.ts';
import { isFilled } from './filled.ts';
import { leastWidth } from './hull-boxes.ts';
import { cutGroup, groupOffWalls, type OffWallGroup } from './off-wall-groups.ts';
import { outlineStructure, type StructureOutline } from './outline-structure.ts';
import { pointsOf } from './point-groups.ts';
import { type FoundStructure, isWallPiece, type StructureSearch, typeOf } from './structure.ts';
import { findWallFaces, type WallFaces } from './wall-faces.ts';

/** Smaller groups are no structure. */
const FEWEST_POINTS = 8;
/** Thinner things are posts and poles, as what is thinner than the reach of a face is noise: area by half the perimeter, m. */
const LEAST_WIDTH = 0.05;
/** Points of faces lie no further apart than this many mean spacings, taken over the whole outline: else they are strays. */
const LARGEST_GAP_SPACINGS = 4;
/** Narrower things, m, are at a wall the end of a partition, 10 to 15 cm thick, and in a room seldom columns. */
const LEAST_CERTAIN_WIDTH = 0.2;
/** What touches a wall stands free of it when points show this share of the side that faces the wall. */
const FACING_SHARE = 0.6;

/** What candidates are judged by. */
interface Surroundings {
  readonly slice: Slice;
  readonly primary: readonly Polygon[];
  readonly faces: WallFaces;
  readonly options: Options;
  readonly context: StageContext;
}

interface Candidate extends FoundStructure, Pick<StructureOutline, 'completion'> {
  readonly group: OffWallGroup;
  readonly isFilled: boolean;
  readonly isSparse: boolean;
}

/**
 * Secondary boundaries as the outer faces of groups of points that stand free of the walls.
 *
 * Ours: neither clusters nor stroke. Points that the walls' faces explain go; what is left hangs together in groups.
 * A group that comes near a wall is a structure when points show its side facing the wall: what grows out of the wall
 * has none there. What only points beside the wall tie to it is cut free first. `secondaryCount` says how many are wanted: those clear of the walls first, then the largest,
 * strays and free-standing pieces of wall last; `auto` takes those that are certain. O(n) but for the outlines.
 *
 * @returns clusters: 0 for walls and what was not taken, 1 … for the structures in order
 */
export function findDetachedGroups(
  slice: Slice,
  primary: readonly Polygon[],
  options: Options,
  context: StageContext,
): StructureSearch {
  const clusters = new Uint8Array(slice.xy.length / 2);
  if (slice.spacing === 0) return { clusters, found: [], wanted: 0 };
  const faces = findWallFaces(slice, options, context);
  context.progress(0.5);
  const surroundings = { slice, primary, faces, options, context };
  const candidates = groupOffWalls(slice, faces).flatMap((group) => candidatesOf(group, surroundings));
  candidates.sort(byLikelihood);
  const { secondaryCount } = options;
  const structures = secondaryCount === 'auto' ? candidates.filter(isCertain) : candidates;
  const wanted = secondaryCount === 'auto' ? structures.length : secondaryCount;
  const found = structures.slice(0, wanted);
  found.forEach(({ group }, k) => {
    for (const i of group.members) clusters[i] = Math.min(255, k + 1);
  });
  return { clusters, found, wanted };
}

/** The structure a group is, or those in it once it is cut from the wall. */
function candidatesOf(group: OffWallGroup, surroundings: Surroundings): Candidate[] {
  const whole = candidateOf(group, surroundings);
  if (whole) return [whole];
  if (group.place !== 'touching') return [];
  const parts = cutGroup(group, surroundings.slice, surroundings.faces);
  return parts.flatMap((part) => candidateOf(part, surroundings) ?? []);
}

function candidateOf(group: OffWallGroup, surroundings: Surroundings): Candidate | null {
  const { slice, primary, faces, options, context } = surroundings;
  if (group.members.length < FEWEST_POINTS) return null;
  const points = pointsOf(slice.xy, group.members);
  const found = outlineStructure({ ...slice, xy: points }, faces.noise, options, context);
  if (!found || !isWithin(found.outline, primary)) return null;
  const { outline, completion } = found;
  if (widthOf(outline) < Math.max(LEAST_WIDTH, faces.reach)) return null;
  if (group.place !== 'clear' && (completion !== 'none' || isThin(outline))) return null;
  if (group.place === 'touching' && facingShare(outline, points, faces) < FACING_SHARE) return null;
  const type = typeOf(outline, points);
  return {
    group,
    completion,
    outline,
    type,
    points: group.members.length,
    isFilled: isFilled(outline, points),
    isSparse: perimeter(outline) > LARGEST_GAP_SPACINGS * slice.spacing * group.members.length,
  };
}

function isWithin(outline: Ring, primary: readonly Polygon[]): boolean {
  const [x, y] = centroid(outline);
  return primary.some((polygon) => pointInPolygon(x, y, polygon) > 0);
}

function widthOf(outline: Ring): number {
  return (2 * signedArea(outline)) / perimeter(outline);
}

/**
 * Faces around a hollow: no pole, no piece of wall, no strays, nothing filled with points, which may be furniture, and no
 * side made up but of a column: larger things open to one side are partitions.
 */
function isCertain({ outline, completion, type, isFilled, isSparse }: Candidate): boolean {
  if (isThin(outline) || isFilled || isSparse) return false;
  return completion === 'none' || (completion === 'shape' && type === 'column');
}

/**
 * Structures before pieces of wall, faces before strays, clear of the walls before touching, then by area; of equals the one
 * further left.
 */
function byLikelihood(a: Candidate, b: Candidate): number {
  const pieces = Number(isWallPiece(a.outline)) - Number(isWallPiece(b.outline));
  const strays = Number(a.isSparse) - Number(b.isSparse);
  const atWall = Number(a.group.place !== 'clear') - Number(b.group.place !== 'clear');
  return (
    pieces || strays || atWall || signedArea(b.outline) - signedArea(a.outline) || a.outline[0] - b.outline[0]
  );
}

/** Whether it may be a piece of a wall. */
function isThin(outline: Ring): boolean {
  return isWallPiece(outline) || leastWidth(convexHull(outline)) < LEAST_CERTAIN_WIDTH;
}
