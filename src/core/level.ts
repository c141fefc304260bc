import type { StageContext } from './context.ts';
import { FloorPlanError } from './errors.ts';
import { FEWEST_POINTS } from './frame/check-spread.ts';
import type { LevelChoice } from './param-rows.ts';
import type { Options } from './params.ts';
import { DEVIATION_BY_MEDIAN, medianOf } from './robust-scale.ts';
import type { Level, PointCloud } from './types.ts';

/** Reach around a floor or ceiling plane in which its own noise is measured, m. */
const PLANE_LOOK = 0.1;
/** Points within this many deviations of a plane belong to it … */
const PLANE_DEVIATIONS = 3;
/** … and at least those within this, m: skirting, door sills and the voxels of a thinned cloud. */
const LEAST_TOLERANCE = 0.03;

/** The height levels of a cloud and the points of the one chosen. */
export interface ChosenLevel {
  /** The three, lowest first. */
  readonly levels: readonly Level[];
  /** Which of them; null for a height band of one's own. */
  readonly chosen: 0 | 1 | 2 | null;
  /** Heights above the floor, m. */
  readonly band: readonly [low: number, high: number];
  /** Indices of its points in the cloud, in the order given. */
  readonly indices: Uint32Array;
}

/**
 * Splits a cloud into three levels and chooses one ([Stojanovic19] §3).
 *
 * Reference heights are the least, mean and greatest height of the points; each point belongs to the nearest,
 * so the cuts lie halfway between. Points of the floor and ceiling planes are left out before (§3.1), unless
 * `keepFloorAndCeiling`. `levelRule` takes the level with the most points per m² of its bounding box, or, as
 * the paper does, the most points. A flat cloud has all points in the middle level, whatever `level` says.
 * O(n).
 *
 * @param kept indices of the points that are no outliers
 * @throws input/too-few-points when the level chosen holds fewer than three points
 */
export function chooseLevel(
  cloud: PointCloud,
  kept: Uint32Array,
  options: Options,
  context: StageContext,
): ChosenLevel {
  if (cloud.isFlat) return flatLevel(cloud, kept);
  const base = storeyRange(cloud, kept).floor;
  const used = options.keepFloorAndCeiling ? kept : leaveOutPlanes(cloud, kept, context);
  const { cuts, low, high } = referenceCuts(cloud, used);
  const edges = [low, ...cuts, high].map((z) => z - base);
  const measured = [0, 1, 2].map((k) => {
    const points = pointsBetween(
      cloud,
      used,
      k === 0 ? -Infinity : cuts[k - 1],
      k === 2 ? Infinity : cuts[k],
    );
    return { points, low: edges[k], high: edges[k + 1], densityPerM2: density(cloud, points) };
  });
  const band = ownBand(options.level);
  const chosen = band ? null : pick(measured, options);
  const indices =
    chosen === null ? pointsBetween(cloud, used, base + band![0], base + band![1]) : measured[chosen].points;
  const bounds = band ?? ([measured[chosen!].low, measured[chosen!].high] as const);
  if (indices.length < FEWEST_POINTS) throw emptyLevel(bounds, indices.length);
  const levels = measured.map(({ points, ...level }, k) => ({
    ...level,
    points: points.length,
    chosen: k === chosen,
  }));
  return { levels, chosen, band: bounds, indices };
}

/**
 * Heights between which a storey stands, m: its floor and ceiling planes, or where there are none the lowest
 * and highest point that is no outlier.
 */
export function storeyRange(
  { positions, floor, ceiling }: PointCloud,
  kept: Uint32Array,
): { readonly floor: number; readonly ceiling: number } {
  let low = Infinity;
  let high = -Infinity;
  for (const i of kept) {
    low = Math.min(low, positions[3 * i + 2]);
    high = Math.max(high, positions[3 * i + 2]);
  }
  return { floor: floor ?? low, ceiling: ceiling ?? high };
}

function flatLevel(cloud: PointCloud, kept: Uint32Array): ChosenLevel {
  const empty: Level = { low: 0, high: 0, points: 0, densityPerM2: 0, chosen: false };
  const middle = { ...empty, points: kept.length, densityPerM2: density(cloud, kept), chosen: true };
  return { levels: [empty, middle, empty], chosen: 1, band: [0, 0], indices: kept };
}

function leaveOutPlanes(cloud: PointCloud, kept: Uint32Array, context: StageContext): Uint32Array {
  const { positions } = cloud;
  let used = kept;
  for (const plane of [cloud.floor, cloud.ceiling]) {
    if (plane === null) continue;
    const tolerance = planeTolerance(positions, kept, plane);
    used = used.filter((i) => Math.abs(positions[3 * i + 2] - plane) > tolerance);
  }
  // Below the floor and above the ceiling only reflections are left.
  used = used.filter((i) => positions[3 * i + 2] > (cloud.floor ?? -Infinity));
  used = used.filter((i) => positions[3 * i + 2] < (cloud.ceiling ?? Infinity));
  if (used.length >= FEWEST_POINTS) return used;
  context.warn({
    code: 'level/only-planes',
    message: 'The scan holds hardly more than floor and ceiling; their points are kept.',
    hint: 'Check that walls were scanned.',
  });
  return kept;
}

/** Distance from a plane, m, up to which points belong to it, from the noise of the points around it. */
function planeTolerance(positions: Float32Array, kept: Uint32Array, plane: number): number {
  const distances: number[] = [];
  for (const i of kept) {
    const distance = Math.abs(positions[3 * i + 2] - plane);
    if (distance <= PLANE_LOOK) distances.push(distance);
  }
  if (distances.length === 0) return LEAST_TOLERANCE;
  const deviation = DEVIATION_BY_MEDIAN * medianOf(Float64Array.from(distances));
  return Math.max(LEAST_TOLERANCE, Math.min(PLANE_LOOK, PLANE_DEVIATIONS * deviation));
}

function referenceCuts({ positions }: PointCloud, used: Uint32Array) {
  let low = Infinity;
  let high = -Infinity;
  let sum = 0;
  for (const i of used) {
    const z = positions[3 * i + 2];
    low = Math.min(low, z);
    high = Math.max(high, z);
    sum += z;
  }
  const mean = sum / used.length;
  return { low, high, cuts: [(low + mean) / 2, (mean + high) / 2] as const };
}

/** Points from `low` up to but without `high`. */
function pointsBetween({ positions }: PointCloud, used: Uint32Array, low: number, high: number): Uint32Array {
  return used.filter((i) => positions[3 * i + 2] >= low && positions[3 * i + 2] < high);
}

/** Points per m² of the axis-aligned bounding box seen from above; 0 where that has no area. */
function density({ positions }: PointCloud, indices: Uint32Array): number {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const i of indices) {
    minX = Math.min(minX, positions[3 * i]);
    maxX = Math.max(maxX, positions[3 * i]);
    minY = Math.min(minY, positions[3 * i + 1]);
    maxY = Math.max(maxY, positions[3 * i + 1]);
  }
  const area = (maxX - minX) * (maxY - minY);
  return indices.length > 0 && area > 0 ? indices.length / area : 0;
}

function ownBand(level: LevelChoice): readonly [number, number] | null {
  if (!level.includes(':')) return null;
  const [low, high] = level.split(':').map(Number);
  return [low, high];
}

function pick(
  levels: readonly { readonly points: Uint32Array; readonly densityPerM2: number }[],
  { level, levelRule }: Options,
): 0 | 1 | 2 {
  if (level !== 'auto') return Number(level) as 0 | 1 | 2;
  const value = (k: number) => (levelRule === 'count' ? levels[k].points.length : levels[k].densityPerM2);
  return ([0, 1, 2] as const).reduce((best, k) => (value(k) > value(best) ? k : best));
}

function emptyLevel([low, high]: readonly [number, number], points: number): FloorPlanError {
  const band = `${Number(low.toPrecision(3))} to ${Number(high.toPrecision(3))} m above the floor`;
  return new FloorPlanError(
    'input/too-few-points',
    `level: expected at least ${FEWEST_POINTS} points from ${band}, found ${points}`,
    {
      hint: 'Choose another level or a wider height band.',
      detail: { option: 'level', low, high, points },
    },
  );
}
