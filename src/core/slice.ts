import { CellTable } from './cell-table.ts';
import { boundsOf } from './geometry/rings.ts';
import { meanSpacing } from './geometry/spacing.ts';
import type { Options } from './params.ts';
import { createRandom } from './random.ts';
import type { PointCloud, Slice } from './types.ts';

/** `samplesPer50M2` counts points on this area, m² ([Stojanovic19] §4). */
const SAMPLE_AREA = 50;

/**
 * Points of one level seen from above, uniformly down-sampled ([Stojanovic19] §4).
 *
 * A lattice over the plan with as many cells as points are wanted; of each cell the point nearest its middle
 * stays, so the order of the points does not matter. The seed shifts the lattice. A ready slice below the
 * wanted density stays as it is. O(n).
 *
 * @param indices points of the level
 * @param band heights above the floor, m
 */
export function makeSlice(
  cloud: PointCloud,
  indices: Uint32Array,
  band: readonly [low: number, high: number],
  options: Options,
): Slice {
  const all = seenFromAbove(cloud, indices);
  const { minX, minY, maxX, maxY } = boundsOf(all);
  const wanted = ((maxX - minX) * (maxY - minY) * options.samplesPer50M2) / SAMPLE_AREA;
  const isSparse = cloud.isFlat && indices.length <= wanted;
  const xy = isSparse ? all : sampleLattice(all, minX, minY, options);
  return { xy, band, spacing: meanSpacing(xy) };
}

function seenFromAbove({ positions }: PointCloud, indices: Uint32Array): Float64Array {
  const xy = new Float64Array(2 * indices.length);
  for (let k = 0; k < indices.length; k++) {
    xy[2 * k] = positions[3 * indices[k]];
    xy[2 * k + 1] = positions[3 * indices[k] + 1];
  }
  return xy;
}

/** One point a lattice cell, in lexicographic order of the cells' rows and columns. */
function sampleLattice(
  xy: Float64Array,
  minX: number,
  minY: number,
  { samplesPer50M2, seed }: Options,
): Float64Array {
  const edge = Math.sqrt(SAMPLE_AREA / samplesPer50M2);
  const random = createRandom(seed);
  const [x0, y0] = [minX - random() * edge, minY - random() * edge];
  const table = new CellTable();
  const chosen: number[] = [];
  const distances: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    const [u, v] = [(xy[i] - x0) / edge, (xy[i + 1] - y0) / edge];
    const cell = table.add(Math.floor(u), Math.floor(v), 0);
    const distance = Math.hypot(u - Math.floor(u) - 0.5, v - Math.floor(v) - 0.5);
    if (cell < chosen.length && !isBetter(xy, i, distance, chosen[cell], distances[cell])) continue;
    chosen[cell] = i;
    distances[cell] = distance;
  }
  return sortedPoints(xy, chosen);
}

/** Nearer the middle of the cell; of equals the one further left, then further down. */
function isBetter(
  xy: Float64Array,
  i: number,
  distance: number,
  other: number,
  otherDistance: number,
): boolean {
  if (distance !== otherDistance) return distance < otherDistance;
  return xy[i] !== xy[other] ? xy[i] < xy[other] : xy[i + 1] < xy[other + 1];
}

function sortedPoints(xy: Float64Array, chosen: readonly number[]): Float64Array {
  const order = [...chosen].sort((a, b) => xy[a] - xy[b] || xy[a + 1] - xy[b + 1]);
  const sorted = new Float64Array(2 * order.length);
  for (let k = 0; k < order.length; k++) {
    sorted[2 * k] = xy[order[k]];
    sorted[2 * k + 1] = xy[order[k] + 1];
  }
  return sorted;
}
