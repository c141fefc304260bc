import { DEVIATION_BY_MEDIAN, medianOf } from '../robust-scale.ts';
import type { PointCloud } from '../types.ts';
import { areaByHeight, BIN, type HeightAreas, type Peak, peaksOf, REACH } from './height-areas.ts';

/** Lowest clear height of a storey, m: a cellar. */
const LEAST_HEIGHT = 1.9;
/** A level with less than this share of the most enclosed one's enclosure lies outdoors. */
const LEAST_ENCLOSED = 0.5;
/** … among those with this share of the most area enclosed: smaller ones tell nothing. */
const TELLING_SHARE = 0.3;
/** A floor has at least this share of the area of the largest: smaller ones are landings and galleries. */
const LEAST_FLOOR_SHARE = 0.3;
/** A ceiling's share; suspended ones and beams leave little of it. */
const LEAST_CEILING_SHARE = 0.1;
/** Thickest slab with what hangs below it, m: ducts over the ceiling of an office; less than a storey. */
const THICKEST_SLAB = 1.8;

/** A plane's height is refined so often, from points within so many deviations of it, at least within LEAST_REACH, m. */
const REFINEMENTS = 3;
const DEVIATIONS = 2;
const LEAST_REACH = 0.003;
/** Points that tell a median at most. */
const SAMPLE = 10_000;

/** Walls without a ceiling, or without a floor, are looked for so far from the other, past most furniture, m … */
const WALLS_FROM = 1.2;
/** … and end where less than this share of them is left. */
const END_SHARE = 0.5;

/** Heights between which a storey stands, m, in the cloud's frame. */
export interface StoreyHeights {
  /** Where none was seen, the lowest points of the walls. */
  readonly floor: number;
  /** The highest ceiling; where none was seen, the tops of the walls. */
  readonly ceiling: number;
  /** No ceiling was seen. */
  readonly isOpenAbove?: true;
  /** No floor was seen. */
  readonly isOpenBelow?: true;
}

/**
 * The storeys of a building, lowest first, from a histogram of horizontal area over height.
 *
 * A height bin counts the cells of the plan it has points in, so that floors and ceilings, not walls or dense patches,
 * are its peaks. A floor starts a storey where {@link LEAST_HEIGHT} is clear above it and a ceiling or nothing
 * is below it. O(n).
 *
 * @param kept indices of the points that are no outliers
 */
export function findStoreys(cloud: PointCloud, kept: Uint32Array): readonly StoreyHeights[] {
  const heightAreas = areaByHeight(cloud.positions, kept, LEAST_HEIGHT);
  const { low } = heightAreas;
  const heightAt = (bin: number) => low + (bin + 0.5) * BIN;
  const peaks = withoutOutdoors(peaksOf(heightAreas));
  if (peaks.length === 0) return [];
  const largest = Math.max(...peaks.map(({ area }) => area));
  const surfaces = peaks.filter(({ area }) => area >= LEAST_CEILING_SHARE * largest);
  const top = heightAt(surfaces[surfaces.length - 1].bin);
  const floors: number[] = [];
  for (const { bin, area } of surfaces) {
    const z = heightAt(bin);
    if (area < LEAST_FLOOR_SHARE * largest || top - z < LEAST_HEIGHT) continue;
    const below = floors[floors.length - 1];
    const hasCeilingBelow = surfaces.some(
      (other) =>
        other.bin < bin &&
        z - heightAt(other.bin) <= THICKEST_SLAB &&
        heightAt(other.bin) - below >= LEAST_HEIGHT,
    );
    if (floors.length === 0 || hasCeilingBelow) floors.push(z);
  }
  if (floors.length === 0) return openStorey(cloud, kept, heightAreas, peaks);
  return floors.map((floor, i) => {
    const next = floors[i + 1] ?? Infinity;
    const above = surfaces.filter(({ bin }) => heightAt(bin) >= floor + LEAST_HEIGHT && heightAt(bin) < next);
    const highest = above[above.length - 1];
    return {
      floor: refined(cloud.positions, kept, floor),
      ceiling: refined(cloud.positions, kept, heightAt(highest.bin)),
    };
  });
}

/**
 * The levels that have something far above or below them: grounds seen through windows have not.
 *
 * Without a ceiling a floor still has its walls, so shares are compared with the best one's.
 */
function withoutOutdoors(peaks: readonly Peak[]): Peak[] {
  const enclosed = ({ area, enclosed }: Peak) => area * enclosed;
  const most = Math.max(...peaks.map(enclosed));
  const telling = peaks.filter((peak) => enclosed(peak) >= TELLING_SHARE * most);
  const best = Math.max(...telling.map((peak) => peak.enclosed));
  return peaks.filter((peak) => peak.enclosed >= LEAST_ENCLOSED * best);
}

/**
 * A floor with walls but no ceiling over it, or a ceiling with walls but no floor below: they end where hardly any point
 * is farther.
 */
function openStorey(
  { positions }: PointCloud,
  kept: Uint32Array,
  { low, areas }: HeightAreas,
  peaks: readonly Peak[],
): readonly StoreyHeights[] {
  const { bin } = peaks.reduce((best, peak) => (peak.area > best.area ? peak : best));
  const [above, below] = [1, -1].map((way) => wallsFrom(areas, bin, way));
  const far = above.area > below.area ? above : below;
  if (Math.abs(far.end - bin) * BIN < LEAST_HEIGHT) return [];
  const level = refined(positions, kept, low + (bin + 0.5) * BIN);
  const end = low + (far.end + (far === above ? 1 : 0)) * BIN;
  return far === above
    ? [{ floor: level, ceiling: end, isOpenAbove: true }]
    : [{ floor: end, ceiling: level, isOpenBelow: true }];
}

/** Cells of the walls that stand on or hang from a level, and the bin in which they end. */
function wallsFrom(areas: Float64Array, bin: number, way: number): { area: number; end: number } {
  const at = (height: number) => bin + way * Math.round(height / BIN);
  const middle: number[] = [];
  for (let k = at(WALLS_FROM); k !== at(LEAST_HEIGHT); k += way) middle.push(areas[k] ?? 0);
  const usual = medianOf(Float64Array.from(middle));
  let end = way > 0 ? areas.length - 1 : 0;
  while (end !== bin && areas[end] < Math.max(1, END_SHARE * usual)) end -= way;
  return { area: usual, end };
}

/** Median height of the points around a peak, looked at ever more closely. */
function refined(positions: Float32Array, kept: Uint32Array, height: number): number {
  let [middle, reach] = [height, (REACH + 1) * BIN];
  // No round moves farther than its reach.
  const around = kept.filter((i) => Math.abs(positions[3 * i + 2] - height) <= REFINEMENTS * reach);
  for (let round = 0; round < REFINEMENTS; round++) {
    const near = around.filter((i) => Math.abs(positions[3 * i + 2] - middle) <= reach);
    if (near.length === 0) break;
    // Points are sorted by cell, so a stride takes an even sample.
    const stride = Math.ceil(near.length / SAMPLE);
    const heights = Float64Array.from(
      { length: Math.ceil(near.length / stride) },
      (_, k) => positions[3 * near[k * stride] + 2],
    );
    middle = medianOf(heights);
    const deviation = DEVIATION_BY_MEDIAN * medianOf(heights.map((z) => Math.abs(z - middle)));
    reach = Math.min(reach, Math.max(LEAST_REACH, DEVIATIONS * deviation));
  }
  return middle;
}
