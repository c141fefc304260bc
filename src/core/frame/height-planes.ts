import { CellTable } from '../cell-table.ts';
import { medianOf } from '../robust-scale.ts';
import type { Vec3 } from '../types.ts';
import type { SurfacePatches } from './surface-patches.ts';

/** Height bins a patch edge: a plane seen by noisy patches fits into three neighbouring bins. */
const BINS_A_PATCH = 6;
/** Planes smaller than this share of the largest are table tops, sills and steps. */
const STRONG_SHARE = 0.25;
/** A floor has no more than this share of the cloud's voxels below it, a ceiling above it. */
const BEYOND_SHARE = 0.1;
/**
 * Floor and ceiling are at least this share of the cloud's height apart; closer ones are steps of one of
 * them.
 */
const GAP_SHARE = 0.5;
const TRIM = 0.02;
/** Patches within this many edges of a plane belong to it when its two sides are compared. */
const PLANE_REACH = 1.5;

/** A horizontal plane of the cloud. */
export interface HeightPlane {
  /** Along the up vector from the positions' origin, source units. */
  readonly height: number;
  /** Area that its patches cover, square source units. */
  readonly area: number;
}

/** The planes across one direction, strongest first. */
export interface HeightPlanes {
  readonly planes: readonly HeightPlane[];
  /** Strong planes, lowest first. */
  readonly strong: readonly HeightPlane[];
  readonly floor: HeightPlane | null;
  readonly ceiling: HeightPlane | null;
  /** Of the inner 96 % of heights. */
  readonly range: readonly [low: number, high: number];
}

/**
 * Planes perpendicular to `up`: peaks of the area-weighted histogram of heights.
 *
 * Only patches whose normal is within the cone count, so walls do not blur the histogram. Floor and ceiling
 * are the lowest and the highest strong plane, unless much of the cloud lies beyond: a table is no floor, a
 * mezzanine no ceiling.
 *
 * @param up unit vector, source axes
 * @param minCosine cosine of the cone's half angle
 */
export function findHeightPlanes(patches: SurfacePatches, up: Vec3, minCosine: number): HeightPlanes {
  const heights = heightsAlong(patches, up);
  const members = Uint32Array.from(heights.keys())
    .filter((i) => Math.abs(alignment(patches, i, up)) >= minCosine)
    .sort((a, b) => heights[a] - heights[b]);
  const planes = peaksOf(patches, up, heights, members);
  const least = STRONG_SHARE * (planes[0]?.area ?? 0);
  const strong = planes.filter(({ area }) => area >= least).sort((a, b) => a.height - b.height);
  const floor = strong[0] ?? null;
  const ceiling = strong.at(-1) ?? null;
  const reach = PLANE_REACH * patches.size;
  const below = floor ? heights.filter((h) => h < floor.height - reach).length : 0;
  const above = ceiling ? heights.filter((h) => h > ceiling.height + reach).length : 0;
  const most = BEYOND_SHARE * patches.count;
  const range = rangeOf(heights);
  const isFarApart = (ceiling?.height ?? 0) - (floor?.height ?? 0) >= GAP_SHARE * (range[1] - range[0]);
  const isFloor = below <= most && (isFarApart || below <= above);
  const isCeiling = above <= most && (isFarApart || above < below);
  return { planes, strong, floor: isFloor ? floor : null, ceiling: isCeiling ? ceiling : null, range };
}

function rangeOf(heights: Float64Array): [low: number, high: number] {
  if (heights.length === 0) return [0, 0];
  const sorted = heights.slice().sort();
  const trimmed = Math.floor(sorted.length * TRIM);
  return [sorted[trimmed], sorted[sorted.length - 1 - trimmed]];
}

/** Heights of all patches along `up`. */
export function heightsAlong({ count, centroids }: SurfacePatches, [x, y, z]: Vec3): Float64Array {
  const heights = new Float64Array(count);
  for (let i = 0; i < count; i++) {
    heights[i] = centroids[3 * i] * x + centroids[3 * i + 1] * y + centroids[3 * i + 2] * z;
  }
  return heights;
}

/** Cosine between a patch's normal and a unit vector; 0 for a patch that is no plane. */
export function alignment({ normals }: SurfacePatches, patch: number, [x, y, z]: Vec3): number {
  return normals[3 * patch] * x + normals[3 * patch + 1] * y + normals[3 * patch + 2] * z;
}

/** Planes by size, from the three neighbouring bins that hold most patches, again and again. */
function peaksOf(
  patches: SurfacePatches,
  up: Vec3,
  heights: Float64Array,
  members: Uint32Array,
): HeightPlane[] {
  if (members.length === 0) return [];
  const bin = patches.size / BINS_A_PATCH;
  const low = heights[members[0]];
  const starts = new Uint32Array(Math.floor((heights[members[members.length - 1]] - low) / bin) + 2);
  for (const i of members) starts[Math.floor((heights[i] - low) / bin) + 1]++;
  for (let b = 1; b < starts.length; b++) starts[b] += starts[b - 1];
  const planes = greedyPeaks(members.length, starts).map(({ begin, end }) => {
    const own = members.subarray(begin, end);
    const height = medianOf(Float64Array.from(own, (i) => heights[i]));
    return { height, area: columnsOf(patches, up, own) * patches.size ** 2 };
  });
  return planes.sort((a, b) => b.area - a.area || a.height - b.height);
}

/** Columns of voxels along `up` that patches fill: a plane cut by a voxel face is one plane, not two. */
function columnsOf({ centroids, size }: SurfacePatches, up: Vec3, own: Uint32Array): number {
  // The two source axes nearest to the plane part it into columns as well as any.
  const steepest = [0, 1, 2].reduce((a, b) => (Math.abs(up[b]) > Math.abs(up[a]) ? b : a));
  const [u, v] = [(steepest + 1) % 3, (steepest + 2) % 3];
  const columns = new CellTable(own.length);
  for (const i of own)
    columns.add(Math.floor(centroids[3 * i + u] / size), Math.floor(centroids[3 * i + v] / size), 0);
  return columns.count;
}

interface Run {
  readonly begin: number;
  readonly end: number;
}

function greedyPeaks(members: number, starts: Uint32Array): Run[] {
  const bins = starts.length - 1;
  const windows: Run[] = [];
  for (let b = 0; b < bins; b++) {
    const run = { begin: starts[Math.max(0, b - 1)], end: starts[Math.min(bins, b + 2)] };
    if (run.end > run.begin) windows.push(run);
  }
  windows.sort((a, b) => b.end - b.begin - (a.end - a.begin) || a.begin - b.begin);
  const isTaken = new Uint8Array(members);
  const peaks: Run[] = [];
  for (const { begin, end } of windows) {
    if (isTaken.subarray(begin, end).some((taken) => taken === 1)) continue;
    isTaken.fill(1, begin, end);
    peaks.push({ begin, end });
  }
  return peaks;
}
