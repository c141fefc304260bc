import { CellTable } from '../cell-table.ts';
import type { PointCloud } from '../types.ts';
import type { StoreyHeights } from './find-storeys.ts';

/** Height of a bin, m: coarser than the voxels of a thinned cloud. */
const BIN = 0.1;
/** Bits of a column's mask. */
const MOST_BINS = 62;
const WORD = 31;
/** Floors and ceilings are found within this of their height, m: noise, tilt, sills, coves. */
const PLANE_REACH = 0.08;
/** Height below the ceiling of the cleanest slice of a storey, m: above door heads and cupboards. */
const TOP_BAND = 0.45;
/** Columns are so many times as wide as points are apart, within limits in m. */
const SPACINGS = 1.25;
const NARROWEST = 0.05;
const WIDEST = 0.15;

/** The points of a storey in columns of a square grid seen from above. */
export interface HeightColumns {
  /** Edge of a column, m. */
  readonly size: number;
  readonly heights: StoreyHeights;
  readonly count: number;
  readonly table: CellTable;
  /** Mean place of the column's points between floor and ceiling, x, y each; NaN where it has none. */
  readonly centres: Float64Array;
  /** Bins with points between floor and ceiling, and of those in the top band. */
  readonly hits: Uint8Array;
  readonly topHits: Uint8Array;
  readonly bins: number;
  readonly binsPerMetre: number;
  /** Height of the lowest bin's bottom, m, in the cloud's frame. */
  readonly low: number;
  readonly topBins: number;
  /** Two words a column, a bit a bin with points. */
  readonly masks: Int32Array;
  /** Height of what hangs over the column, m, in the cloud's frame; NaN where nothing does. */
  readonly overhead: Float32Array;
  /** 1 where the column has points on the floor; 2 where under the ceiling. */
  readonly planes: Uint8Array;
  /** Indices of the points between floor and ceiling, column by column. */
  readonly points: Uint32Array;
  /** First of each column; one entry more than columns. */
  readonly start: Uint32Array;
  /** Indices of the points that hang over the floor: on the storey's ceiling or a lowered one, column by column, likewise. */
  readonly overPoints: Uint32Array;
  readonly overStart: Uint32Array;
}

/** Sorts a storey's points into columns. O(n). */
export function heightColumns(cloud: PointCloud, kept: Uint32Array, heights: StoreyHeights): HeightColumns {
  const { positions } = cloud;
  const size = columnSize(positions, kept, heights);
  const low = heights.floor + PLANE_REACH;
  const high = heights.ceiling - PLANE_REACH;
  const bins = Math.max(1, Math.min(MOST_BINS, Math.round((high - low) / BIN)));
  const binsPerMetre = bins / (high - low);
  const topBins = Math.max(1, Math.min(bins, Math.round(TOP_BAND * binsPerMetre)));
  const table = new CellTable(kept.length / 16);
  const columnOf = new Int32Array(kept.length).fill(-1);
  for (let k = 0; k < kept.length; k++) {
    const i = 3 * kept[k];
    const z = positions[i + 2];
    if (z < heights.floor - PLANE_REACH || z > heights.ceiling + PLANE_REACH) continue;
    columnOf[k] = table.add(Math.floor(positions[i] / size), Math.floor(positions[i + 1] / size), 0);
  }
  const count = table.count;
  const masks = new Int32Array(2 * count);
  const planes = new Uint8Array(count);
  const start = new Uint32Array(count + 1);
  const centres = new Float64Array(2 * count);
  for (let k = 0; k < kept.length; k++) {
    const column = columnOf[k];
    if (column < 0) continue;
    const i = 3 * kept[k];
    const z = positions[i + 2];
    if (z < low) planes[column] |= Math.abs(z - heights.floor) <= PLANE_REACH ? 1 : 0;
    else if (z >= high) planes[column] |= 2;
    else {
      const bin = Math.min(bins - 1, Math.floor((z - low) * binsPerMetre));
      masks[2 * column + (bin < WORD ? 0 : 1)] |= 1 << (bin % WORD);
      start[column + 1]++;
      centres[2 * column] += positions[i];
      centres[2 * column + 1] += positions[i + 1];
    }
  }
  const hits = new Uint8Array(count);
  const topHits = new Uint8Array(count);
  for (let c = 0; c < count; c++) {
    centres[2 * c] /= start[c + 1];
    centres[2 * c + 1] /= start[c + 1];
    hits[c] = bitCount(masks[2 * c]) + bitCount(masks[2 * c + 1]);
    for (let bin = bins - topBins; bin < bins; bin++) {
      topHits[c] += (masks[2 * c + (bin < WORD ? 0 : 1)] >>> (bin % WORD)) & 1;
    }
  }
  const overhead = overheads(masks, planes, heights, { low, binsPerMetre });
  const overStart = new Uint32Array(count + 1);
  const isOver = (column: number, z: number) =>
    !Number.isNaN(overhead[column]) && z > overhead[column] - OVER_REACH;
  for (let k = 0; k < kept.length; k++) {
    const column = columnOf[k];
    if (column >= 0 && isOver(column, positions[3 * kept[k] + 2])) overStart[column + 1]++;
  }
  for (let c = 0; c < count; c++) start[c + 1] += start[c];
  for (let c = 0; c < count; c++) overStart[c + 1] += overStart[c];
  const points = new Uint32Array(start[count]);
  const overPoints = new Uint32Array(overStart[count]);
  const next = start.slice(0, count);
  const overNext = overStart.slice(0, count);
  for (let k = 0; k < kept.length; k++) {
    const column = columnOf[k];
    if (column < 0) continue;
    const z = positions[3 * kept[k] + 2];
    if (z >= low && z < high) points[next[column]++] = kept[k];
    if (isOver(column, z)) overPoints[overNext[column]++] = kept[k];
  }
  return {
    size,
    heights,
    count,
    table,
    centres,
    hits,
    topHits,
    bins,
    binsPerMetre,
    low,
    topBins,
    masks,
    overhead,
    planes,
    points,
    start,
    overPoints,
    overStart,
  };
}

/** Lowest height of a lowered ceiling above the floor, m: door heads and most cupboards are below. */
const LEAST_OVERHEAD = 2.3;
/** Points within this of what hangs over a column are on it, m. */
const OVER_REACH = 0.1;
/** Bins below a ceiling that are empty, or a wall would be taken for one. */
const CLEAR_BINS = 3;

/** A column's ceiling: that of the storey, or its highest bin if some below are clear. */
function overheads(
  masks: Int32Array,
  planes: Uint8Array,
  { floor, ceiling }: StoreyHeights,
  { low, binsPerMetre }: { readonly low: number; readonly binsPerMetre: number },
): Float32Array {
  return Float32Array.from(planes, (plane, c) => {
    if (plane & 2) return ceiling;
    const highest =
      masks[2 * c + 1] !== 0 ? WORD + 31 - Math.clz32(masks[2 * c + 1]) : 31 - Math.clz32(masks[2 * c]);
    const z = low + (highest + 0.5) / binsPerMetre;
    if (z < floor + LEAST_OVERHEAD) return Number.NaN;
    for (let bin = highest - CLEAR_BINS; bin < highest; bin++) if (hasBin(masks, c, bin)) return Number.NaN;
    return z;
  });
}

/** The bin that ends below a ceiling at height `z`. */
export function binAt({ low, binsPerMetre, bins }: HeightColumns, z: number): number {
  return Math.max(1, Math.min(bins, Math.round((z - PLANE_REACH - low) * binsPerMetre)));
}

/** Whether a column has points in a bin. */
export function hasBin(masks: Int32Array, column: number, bin: number): boolean {
  return bin >= 0 && ((masks[2 * column + (bin < WORD ? 0 : 1)] >>> (bin % WORD)) & 1) === 1;
}

/** From how far apart points lie on the floor, where cells of 10 cm have any. */
function columnSize(positions: Float32Array, kept: Uint32Array, { floor, ceiling }: StoreyHeights): number {
  const cells = new CellTable();
  let points = 0;
  for (const i of kept) {
    const z = positions[3 * i + 2];
    if (Math.abs(z - floor) > PLANE_REACH && Math.abs(z - ceiling) > PLANE_REACH) continue;
    cells.add(
      Math.floor(positions[3 * i] / BIN),
      Math.floor(positions[3 * i + 1] / BIN),
      z < (floor + ceiling) / 2 ? 0 : 1,
    );
    points++;
  }
  const spacing = Math.sqrt((cells.count * BIN * BIN) / Math.max(1, points));
  return Math.min(WIDEST, Math.max(NARROWEST, SPACINGS * spacing));
}

function bitCount(mask: number): number {
  let rest = mask;
  let bits = 0;
  for (; rest !== 0; bits++) rest &= rest - 1;
  return bits;
}

/** Whether floor or ceiling was seen in the column at a place. */
export function hasPlane({ table, size, planes }: HeightColumns, x: number, y: number): boolean {
  const c = table.find(Math.floor(x / size), Math.floor(y / size), 0);
  return c >= 0 && planes[c] !== 0;
}
