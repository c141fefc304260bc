import { CELLS_ACROSS } from './cell-table.ts';
import { meanSpacing } from './geometry/spacing.ts';
import { type CellSums, cellMeans, type Lattice, type LatticePoints, sumCells } from './lattice-sample.ts';
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
  const sums = sumCells(points, layLattice(points, edge, options.seed));
  const xy = cloud.isFlat && isSparse(sums, points, edge) ? seenFromAbove(points) : cellMeans(sums);
  return { xy, band, spacing: meanSpacing(xy) };
}

/** The lattice over the points' box, shifted by the seed; kilometres across, its cells grow so that all can be told apart. */
function layLattice({ positions, indices }: LatticePoints, wantedEdge: number, seed: number): Lattice {
  let minX = Number.POSITIVE_INFINITY;
  let minY = Number.POSITIVE_INFINITY;
  let maxX = Number.NEGATIVE_INFINITY;
  let maxY = Number.NEGATIVE_INFINITY;
  for (let k = 0; k < indices.length; k++) {
    const x = positions[3 * indices[k]];
    const y = positions[3 * indices[k] + 1];
    if (x < minX) minX = x;
    if (x > maxX) maxX = x;
    if (y < minY) minY = y;
    if (y > maxY) maxY = y;
  }
  const edge = Math.max(wantedEdge, Math.max(maxX - minX, maxY - minY) / (CELLS_ACROSS - 2));
  const random = createRandom(seed);
  minX -= random() * edge;
  minY -= random() * edge;
  const perMetre = 1 / edge;
  const columns = Math.floor((maxX - minX) * perMetre) + 1;
  const rows = Math.floor((maxY - minY) * perMetre) + 1;
  return { minX, minY, edge, perMetre, columns, rows };
}

function isSparse({ lattice, occupied }: CellSums, { indices }: LatticePoints, wantedEdge: number): boolean {
  const wanted = lattice.columns * lattice.rows * (lattice.edge / wantedEdge) ** 2;
  const isCoarse = lattice.edge > wantedEdge;
  return indices.length <= wanted && (isCoarse || indices.length <= FEW_A_CELL * occupied);
}

function seenFromAbove({ positions, indices }: LatticePoints): Float64Array {
  const xy = new Float64Array(2 * indices.length);
  for (let k = 0; k < indices.length; k++) {
    xy[2 * k] = positions[3 * indices[k]];
    xy[2 * k + 1] = positions[3 * indices[k] + 1];
  }
  return xy;
}
