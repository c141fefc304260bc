import type { CellTable } from '../../cell-table.ts';
import type { StoreyHeights } from '../find-storeys.ts';
import { countBins, highestBin } from './bin-masks.ts';
import { connectedColumns, levelSurfaces } from './connected-columns.ts';

/** Lowest ceiling above the floor, m: under a lowered one, a stair or a slope. */
const LEAST_OVERHEAD = 2;
/** Bins below a ceiling that are empty, or a wall would be taken for one. */
const CLEAR_BINS = 3;
/** A lowered ceiling hangs lower than the storey by this at least, m: its frame and lamps need that, less is unevenness. */
const LEAST_DROP = 0.15;
/** Hanging surfaces smaller than this are door heads, beams and what stands seen from below, m². */
const SMALLEST = 1.5;
/** A point of the ceiling farther than this from such a surface, m, was seen where few are; nearer it is in a wall. */
const BESIDE_SURFACE = 0.2;
/** Neighbouring columns are of one surface up to this step, m. */
const LEVEL_STEP = 0.1;

/** What columns tell of what hangs over them. */
export interface ColumnTops {
  readonly table: CellTable;
  /** Edge of a column, m. */
  readonly size: number;
  readonly heights: StoreyHeights;
  readonly masks: Int32Array;
  /** Bins from floor to ceiling. */
  readonly bins: number;
  readonly planes: Uint8Array;
  /** Height of each column's highest points below the storey's ceiling, m; NaN where it has none. */
  readonly heightsAbove: Float32Array;
  /** Whether a column's highest points lie on a level, m. */
  readonly endsAt: (column: number, z: number) => boolean;
}

/** What hangs over columns. */
export interface Overhead {
  /** Height of the ceiling over each column, m, in the cloud's frame: the storey's, or a lowered one; NaN where none was seen. */
  readonly overhead: Float32Array;
  /** 1 for the columns over which a wall of a storey without ceiling ends in a level top, seen from above. */
  readonly isWallTop: Uint8Array;
}

/**
 * Tells ceilings, and tops of walls that look like them.
 *
 * A lowered ceiling is a level surface with clear space below that goes on over many columns, and from there over what stands
 * under it. O(columns + points of those it goes on over).
 */
export function overheadOf(tops: ColumnTops): Overhead {
  const overhead = candidates(tops);
  const isWallTop = new Uint8Array(overhead.length);
  // Without a ceiling, what lies level there are walls.
  const highest = tops.heights.isOpenAbove ? tops.heights.ceiling - LEAST_DROP : Infinity;
  const kept = new Float32Array(overhead.length).fill(Number.NaN);
  const small: number[][] = [];
  for (const surface of levelSurfaces(tops, overhead, LEVEL_STEP)) {
    if (surface.length * tops.size ** 2 < SMALLEST) {
      small.push(surface);
      continue;
    }
    for (const c of surface) {
      if (overhead[c] > highest) isWallTop[c] = 1;
      else kept[c] = overhead[c];
    }
  }
  const sparse = small.flat().filter((c) => isUnderCeiling(c, tops) && !isNear(c, kept, tops));
  for (const c of sparse) kept[c] = overhead[c];
  goOnOver(kept, tops);
  return { overhead: kept, isWallTop };
}

/** Whether a point of the storey's own ceiling hangs free over a column: far from a scanner they are too few to make a surface. */
function isUnderCeiling(c: number, { planes, masks, bins }: ColumnTops): boolean {
  return (planes[c] & 2) !== 0 && countBins(masks, c, bins - CLEAR_BINS, bins) === 0;
}

/** Whether a surface hangs near a column: one that goes on there would have joined it, so what is seen there is in a wall. */
function isNear(c: number, overhead: Float32Array, { table, size }: ColumnTops): boolean {
  const reach = Math.round(BESIDE_SURFACE / size);
  const [ix, iy] = table.coordinatesOf(c);
  for (let dy = -reach; dy <= reach; dy++) {
    for (let dx = -reach; dx <= reach; dx++) {
      const other = table.find(ix + dx, iy + dy, 0);
      if (other >= 0 && !Number.isNaN(overhead[other])) return true;
    }
  }
  return false;
}

/** Lets lowered ceilings go on over columns that end at their height, whatever else is in these. */
function goOnOver(overhead: Float32Array, { table, heights, endsAt }: ColumnTops): void {
  for (let seed = 0; seed < overhead.length; seed++) {
    if (!(overhead[seed] <= heights.ceiling - LEAST_DROP)) continue;
    connectedColumns({ table }, seed, 1, (c, from) => {
      if (!Number.isNaN(overhead[c]) || !endsAt(c, overhead[from])) return false;
      overhead[c] = overhead[from];
      return true;
    });
  }
}

function candidates({ heights, masks, planes, heightsAbove }: ColumnTops): Float32Array {
  const { floor, ceiling } = heights;
  return Float32Array.from(planes, (plane, c) => {
    if (plane & 2) return ceiling;
    // Noise spreads a surface over two bins.
    const lowest = highestBin(masks, c) - 1;
    const isClear = countBins(masks, c, lowest - CLEAR_BINS, lowest) === 0;
    return heightsAbove[c] >= floor + LEAST_OVERHEAD && isClear ? heightsAbove[c] : Number.NaN;
  });
}
