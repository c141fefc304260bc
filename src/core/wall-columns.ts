import { bitCount } from './bit-count.ts';
import { CellTable } from './cell-table.ts';
import type { StageContext } from './context.ts';
import { type ChosenLevel, storeyRange } from './level.ts';
import type { Options } from './params.ts';
import type { PointCloud } from './types.ts';

/**
 * Side of a column, m: with its neighbours it spans 9 cm, the noisy face of a wall but hardly of the reveal behind it.
 * Mean footprint IoU over ten simulated scans (4 and 5 cm voxels): 0.924 with 5 cm, 0.935 with 3 cm, 0.936 with 2 cm.
 */
const COLUMN = 0.03;
/** Steps of height in which a column is looked at, m: coarser than the voxels of a thinned cloud. */
const STEP = 0.1;
/** Bits of a mask. */
const MOST_STEPS = 31;
/** Less room than this above the level tells nothing, m. */
const LEAST_ROOM = 3 * STEP;
/** A filter that leaves less than this share has met a scan without upper walls, and is not used. */
const LEAST_SHARE = 0.1;

/** Points of walls and the heights they were taken from, m above the floor. */
export type WallPoints = Pick<ChosenLevel, 'indices' | 'band'>;

/**
 * Points of a level over which a wall stands, and of that wall up to the ceiling.
 *
 * Ours. A wall goes on above the level; the reveals of windows and doors end at their lintel, furniture below it. So the
 * outline keeps to the walls' inner face where a window would pull it out to the glass, and the lintel closes the gap that
 * a window leaves in the level. A point counts when, in the columns around it, points are found in at least `wallReach` of
 * the steps between the level and the ceiling. O(n).
 *
 * Without the points above the level, ten simulated scans had the same footprint IoU within 0.005, but for an office whose
 * window front was open: 0.942 against 0.997.
 *
 * @param kept indices of the points that are no outliers
 */
export function findWallPoints(
  cloud: PointCloud,
  kept: Uint32Array,
  { indices, band }: ChosenLevel,
  { wallReach }: Options,
  context: Pick<StageContext, 'warn'>,
): WallPoints {
  const { floor, ceiling } = storeyRange(cloud, kept);
  const low = floor + band[1];
  if (cloud.isFlat || wallReach === 0 || ceiling - low < LEAST_ROOM) return { indices, band };
  const { positions } = cloud;
  const columns = columnMasks(positions, kept, low, ceiling);
  const least = wallReach * columns.steps;
  const isWall = (i: number) => bitCount(columns.around(positions[3 * i], positions[3 * i + 1])) >= least;
  const standing = indices.filter(isWall);
  if (standing.length < LEAST_SHARE * indices.length) {
    context.warn({
      code: 'slice/no-upper-walls',
      message:
        'Hardly anything was scanned above the level, so furniture and window reveals may be in the outline.',
      hint: 'Pick a level that shows the walls best.',
    });
    return { indices, band };
  }
  // The topmost step is the ceiling's.
  const top = ceiling - STEP;
  const above = kept.filter((i) => positions[3 * i + 2] >= low && positions[3 * i + 2] < top && isWall(i));
  return { indices: joined(standing, above), band: [band[0], top - floor] };
}

function joined(a: Uint32Array, b: Uint32Array): Uint32Array {
  const both = new Uint32Array(a.length + b.length);
  both.set(a);
  both.set(b, a.length);
  return both;
}

interface Columns {
  readonly steps: number;
  /** Steps with points in the column of a place or one of its eight neighbours, a bit each. */
  around(x: number, y: number): number;
}

function columnMasks(positions: Float32Array, kept: Uint32Array, low: number, high: number): Columns {
  const steps = Math.min(MOST_STEPS, Math.floor((high - low) / STEP));
  const height = (high - low) / steps;
  const table = new CellTable();
  const masks: number[] = [];
  for (const i of kept) {
    const step = Math.floor((positions[3 * i + 2] - low) / height);
    if (step < 0 || step >= steps) continue;
    const ix = Math.floor(positions[3 * i] / COLUMN);
    const column = table.add(ix, Math.floor(positions[3 * i + 1] / COLUMN), 0);
    masks[column] = (masks[column] ?? 0) | (1 << step);
  }
  const wide = spread(table, masks);
  return {
    steps,
    around: (x, y) => wide.masks[wide.table.find(Math.floor(x / COLUMN), Math.floor(y / COLUMN), 0)] ?? 0,
  };
}

/** Gives each column's mask to its neighbours: once a column, of which there are far fewer than points. */
function spread(columns: CellTable, own: readonly number[]): { table: CellTable; masks: readonly number[] } {
  const table = new CellTable(2 * columns.count);
  const masks: number[] = [];
  for (let column = 0; column < columns.count; column++) {
    const [ix, iy] = columns.coordinatesOf(column);
    for (let dy = -1; dy <= 1; dy++) {
      for (let dx = -1; dx <= 1; dx++) {
        const near = table.add(ix + dx, iy + dy, 0);
        masks[near] = (masks[near] ?? 0) | own[column];
      }
    }
  }
  return { table, masks };
}
