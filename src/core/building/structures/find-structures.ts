import { combine } from '../../geometry/areas.ts';
import { circleThrough } from '../../geometry/circle.ts';
import { withArcs } from '../../geometry/ring-arcs.ts';
import { boundsOf, pointInRing, signedArea } from '../../geometry/rings.ts';
import { distanceToRing } from '../../secondary/structure.ts';
import type { Polygon, Ring, SecondaryBoundary } from '../../types.ts';
import { hasBin } from '../columns/bin-masks.ts';
import { connectedColumns } from '../columns/connected-columns.ts';
import { type HeightColumns, pointsOf, topShare } from '../columns/height-columns.ts';
import type { LocalCeiling } from '../columns/local-ceiling.ts';
import { sizeOf, structureShape, THINNEST } from './structure-shape.ts';
import { seenAround } from './structure-surroundings.ts';
import { type StructureSite, wholeOutline } from './whole-structure.ts';

/** A structure stands this far off the walls, m: nearer, it is a part of them … */
const OFF_WALL = 0.12;
/** … unless floor or ceiling was seen along so much of the way around it: then the wall there is none. */
const ALL_AROUND = 0.85;
/** It reaches above cupboards: so many of the bins just below the ceiling have points … */
const TOP_SHARE = 0.5;
/** … its columns together over so much of the whole height … */
const LEAST_STANDING = 0.6;
/** … and each of its columns in so many of all bins. */
const LEAST_HITS = 0.3;
/** Larger ones, m², are shafts and cores. */
const LARGEST_COLUMN = 1.5;
/** Wider groups, m, are walls. */
const WIDEST = 4;
/** Fewest columns of the grid that make one. */
const FEWEST = 3;
/** Columns of the grid no farther apart than this, m, are of one structure. */
const TOUCH = 0.15;

/**
 * Structures that stand from floor to ceiling within rooms: columns and shafts.
 *
 * Ours. What hangs together and reaches the ceiling, apart from the walls, is drawn by the circle or rectangle its faces lie
 * on; a face whose back no scanner saw is taken for a square's. It counts where floor and ceiling were seen around it and not
 * within: over cupboards and behind leaves of doors the ceiling goes on.
 */
export function findStructures(
  site: StructureSite,
  ceiling: LocalCeiling,
  rooms: readonly Polygon[],
): SecondaryBoundary[] {
  const { cloud, columns } = site;
  const found = freeGroups(columns, ceiling).flatMap((group) => {
    if (group.length < FEWEST || !isUpright(columns, group)) return [];
    return candidateOf(site, rooms, pointsOf(cloud, columns, group)) ?? [];
  });
  return joinedWhereTheyMeet(site, rooms, found).map(({ outline, xy }) => ({
    outline: withOwnCircle(outline),
    operation: 'subtract',
    type: signedArea(outline) <= LARGEST_COLUMN ? 'column' : 'shaft',
    points: xy.length / 2,
  }));
}

/**
 * Groups of columns of the grid that hang together just below the ceiling, as far as they stand; walls, whose lintels hang on
 * them, are too wide.
 */
function freeGroups(columns: HeightColumns, ceiling: LocalCeiling): number[][] {
  const { centres, size, hits, bins, masks } = columns;
  const open = new Set<number>();
  for (let c = 0; c < columns.count; c++) {
    const z = ceiling.at(centres[2 * c], centres[2 * c + 1]);
    if (hits[c] >= 2 && topShare(columns, masks, c, z) >= TOP_SHARE) open.add(c);
  }
  const touch = Math.max(TOUCH, size);
  const reach = Math.ceil(touch / size);
  return [...open].flatMap((first) => {
    if (!open.delete(first)) return [];
    const group = connectedColumns(columns, first, reach, (c, from) => {
      const away = Math.hypot(centres[2 * c] - centres[2 * from], centres[2 * c + 1] - centres[2 * from + 1]);
      return away <= touch && open.delete(c);
    });
    const { minX, minY, maxX, maxY } = boundsOf(group.flatMap((c) => [centres[2 * c], centres[2 * c + 1]]));
    if (Math.max(maxX - minX, maxY - minY) > WIDEST) return [];
    return [group.filter((c) => hits[c] >= LEAST_HITS * bins)];
  });
}

/** Whether columns together have points over much of the whole height. */
function isUpright({ masks, bins }: HeightColumns, group: readonly number[]): boolean {
  let standing = 0;
  for (let bin = 0; bin < bins; bin++) if (group.some((c) => hasBin(masks, c, bin))) standing++;
  return standing >= LEAST_STANDING * bins;
}

interface Candidate {
  readonly outline: Ring;
  /** The points of its faces, x, y each, m. */
  readonly xy: Float64Array;
}

function candidateOf(site: StructureSite, rooms: readonly Polygon[], xy: Float64Array): Candidate | null {
  const shape = structureShape(xy, site.noise);
  const outline = shape && wholeOutline(site, shape);
  if (outline === null) return null;
  // A face alone near a wall is a bay's side.
  const isFace = shape?.rectangle && Math.min(...sizeOf(shape.rectangle)) < THINNEST;
  const isFree =
    isOffWalls(outline, rooms) ||
    (!isFace && isInRooms(outline, rooms) && seenAround(site.columns, outline) >= ALL_AROUND);
  return isFree ? { outline, xy } : null;
}

/** Structures that overlap are the sides of one. */
function joinedWhereTheyMeet(
  site: StructureSite,
  rooms: readonly Polygon[],
  found: readonly Candidate[],
): Candidate[] {
  const kept: Candidate[] = [];
  for (const candidate of found) {
    const at = kept.findIndex(({ outline }) => overlap(outline, candidate.outline));
    if (at < 0) {
      kept.push(candidate);
      continue;
    }
    const xy = Float64Array.from([...kept[at].xy, ...candidate.xy]);
    kept[at] =
      candidateOf(site, rooms, xy) ?? [kept[at], candidate].sort((a, b) => b.xy.length - a.xy.length)[0];
  }
  return kept;
}

function overlap(a: Ring, b: Ring): boolean {
  return combine('intersection', [{ outer: a, holes: [] }], [{ outer: b, holes: [] }]).length > 0;
}

/** The area of an outline; a circle tells that it is one. */
function withOwnCircle(outer: Ring): Polygon {
  const circle = circleThrough(outer);
  return withArcs({ outer, holes: [] }, circle ? [circle] : []);
}

/** Whether an outline lies in one of the rooms, and nowhere at its walls. */
function isOffWalls(outline: Ring, rooms: readonly Polygon[]): boolean {
  return rooms.some(
    ({ outer }) =>
      everyVertex(
        outline,
        (x, y) => pointInRing(x, y, outer) > 0 && distanceToRing(x, y, outer) >= OFF_WALL,
      ) &&
      everyVertex(
        outer,
        (x, y) => pointInRing(x, y, outline) < 0 && distanceToRing(x, y, outline) >= OFF_WALL,
      ),
  );
}

/** Whether an outline reaches into one of the rooms. */
function isInRooms(outline: Ring, rooms: readonly Polygon[]): boolean {
  return rooms.some(
    ({ outer }) =>
      !everyVertex(outline, (x, y) => pointInRing(x, y, outer) < 0 && distanceToRing(x, y, outer) > OFF_WALL),
  );
}

function everyVertex(ring: Ring, holds: (x: number, y: number) => boolean): boolean {
  for (let i = 0; i < ring.length; i += 2) if (!holds(ring[i], ring[i + 1])) return false;
  return true;
}
