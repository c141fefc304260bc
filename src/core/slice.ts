import { meanSpacing } from './geometry/spacing.ts';
import { type CellSums, cellMeans, cellsCovered, type LatticePoints, sumCells } from './lattice-sample.ts';
import type { Options } from './params.ts';
import { createRandom } from './random.ts';
import type { PointCloud, Slice } from './types.ts';

/** `samplesPer50M2` counts points on this area, m² ([Stojanovic19] §4). */
const SAMPLE_AREA = 50;
/** A ready slice with up to as many points an occupied cell is kept whole: every point of it may be meant. */
const FEW_A_CELL = 2;

/**
 * Points of one level seen from above, uniformly down-sampled ([Stojanovic19] §4).
 *
 * A lattice over the plan with as many cells as points are wanted; of each cell one point stays, see
 * {@link cellMeans}, so the order of the points does not matter. The seed shifts the lattice. A ready slice below
 * the wanted density, over its box and along its walls, stays as it is. O(n).
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
  if (indices.length === 0) return { xy: new Float64Array(0), band, spacing: 0 };
  const points = { positions: cloud.positions, indices };
  const edge = Math.sqrt(SAMPLE_AREA / options.samplesPer50M2);
  const random = createRandom(options.seed);
  const cells = sumCells(points, edge, [random(), random()]);
  const xy = cloud.isFlat && isSparse(cells, points, edge) ? seenFromAbove(points) : cellMeans(cells);
  return { xy, band, spacing: meanSpacing(xy) };
}

function isSparse(cells: CellSums, { indices }: LatticePoints, wantedEdge: number): boolean {
  const { edge } = cells.lattice;
  const isCoarse = edge > wantedEdge;
  if (!isCoarse && indices.length > FEW_A_CELL * cells.occupied.length) return false;
  return indices.length <= cellsCovered(cells) * (edge / wantedEdge) ** 2;
}

function seenFromAbove({ positions, indices }: LatticePoints): Float64Array {
  const xy = new Float64Array(2 * indices.length);
  for (let k = 0; k < indices.length; k++) {
    xy[2 * k] = positions[3 * indices[k]];
    xy[2 * k + 1] = positions[3 * indices[k] + 1];
  }
  return xy;
}
