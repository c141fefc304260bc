import { boundsOf, perimeter, pointInRing, signedArea } from '../geometry/rings.ts';
import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { ClusterSearch, Ring, SecondaryBoundary } from '../types.ts';

/** A structure whose bounding box has no longer side than this, m, may be a column. */
const LONGEST_COLUMN = 1.5;
/**
 * A structure with at most this share of its points off its outline looks solid: only its faces were scanned.
 */
const SOLID_SHARE = 0.2;
/** Points within this share of the shorter side of an outline lie on it. */
const FACE_SHARE = 0.25;
/**
 * Area by squared perimeter, 1/16 for a square: below this a structure is a free-standing piece of wall (about 1
 * to 6).
 */
const WALL_COMPACTNESS = 0.03;

/** A structure found in a slice. */
export interface FoundStructure {
  /** Simple, counter-clockwise. */
  readonly outline: Ring;
  readonly type: SecondaryBoundary['type'];
  readonly points: number;
}

export interface StructureSearch {
  /** Cluster of each slice point. */
  readonly clusters: Uint8Array;
  /** How many were asked for, or proposed. */
  readonly wanted: number;
  readonly found: readonly FoundStructure[];
  /** How the paper's method came to them. */
  readonly searches?: readonly ClusterSearch[];
}

/**
 * What a structure is: a column when small and seen from outside only, a shaft when large and seen from
 * outside only, other (a cubicle, furniture) when points lie inside.
 */
export function typeOf(outline: Ring, xy: Float64Array): SecondaryBoundary['type'] {
  const { minX, minY, maxX, maxY } = boundsOf(outline);
  const face = FACE_SHARE * Math.min(maxX - minX, maxY - minY);
  let inside = 0;
  for (let i = 0; i < xy.length; i += 2) {
    if (pointInRing(xy[i], xy[i + 1], outline) > 0 && distanceToRing(xy[i], xy[i + 1], outline) > face)
      inside++;
  }
  if (inside > (SOLID_SHARE * xy.length) / 2) return 'other';
  return Math.max(maxX - minX, maxY - minY) <= LONGEST_COLUMN ? 'column' : 'shaft';
}

/** Whether an outline is as long and thin, or as ragged, as a piece of a wall. */
export function isWallPiece(outline: Ring): boolean {
  return signedArea(outline) < WALL_COMPACTNESS * perimeter(outline) ** 2;
}

/** Distance from a point to the nearest edge of a ring. */
export function distanceToRing(x: number, y: number, ring: Ring): number {
  let least = Infinity;
  let j = ring.length - 2;
  for (let i = 0; i < ring.length; j = i, i += 2) {
    least = Math.min(least, squaredDistanceToSegment(x, y, ring[j], ring[j + 1], ring[i], ring[i + 1]));
  }
  return Math.sqrt(least);
}

/** The points named, x, y each. */
export function pickPoints(xy: Float64Array, isPicked: (i: number) => boolean): Float64Array {
  const picked = new Float64Array(xy.length);
  let count = 0;
  for (let i = 0; i < xy.length / 2; i++) {
    if (!isPicked(i)) continue;
    picked[count++] = xy[2 * i];
    picked[count++] = xy[2 * i + 1];
  }
  return picked.slice(0, count);
}
