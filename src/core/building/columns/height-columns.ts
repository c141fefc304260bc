import { CellTable } from '../../cell-table.ts';
import type { PointCloud } from '../../types.ts';
import type { StoreyHeights } from '../find-storeys.ts';
import { countBins, highestBin, MOST_BINS, setBin } from './bin-masks.ts';
import { overheadOf } from './overhead.ts';

/** Height of a bin, m: coarser than the voxels of a thinned cloud. */
const BIN = 0.1;
/** Floors and ceilings are found within this of their height, m: noise, tilt, sills, coves. */
export const PLANE_REACH = 0.08;
/** Height below a ceiling of the cleanest slice of a storey, m: above door heads and most cupboards. */
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
  /** Bins with points between floor and ceiling. */
  readonly hits: Uint8Array;
  readonly bins: number;
  readonly binsPerMetre: number;
  /** Height of the lowest bin's bottom, m, in the cloud's frame. */
  readonly low: number;
  /** Bins with points of each column; see `bin-masks.ts`. */
  readonly masks: Int32Array;
  /** Height of what hangs over the column, m, in the cloud's frame; NaN where nothing does. */
  readonly overhead: Float32Array;
  /** 1 where the column lies in a wall whose level top was seen from above. */
  readonly isWallTop: Uint8Array;
  /** 1 where the column has points on the floor; 2 where under the ceiling. */
  readonly planes: Uint8Array;
  /** Indices of the points between floor and ceiling, column by column. */
  readonly points: Uint32Array;
  /** First of each column; one entry more than columns. */
  readonly start: Uint32Array;
  /** Indices of the points that hang over the floor: on the storey's ceiling or a lowered one, column by column, likewise. */
  readonly overPoints: Uint32Array;
  readonly overStart: Uint32Array;
  /** Mean place of those, x, y each; NaN where there are none. */
  readonly overCentres: Float64Array;
}

/** Sorts a storey's points into columns. O(n). */
export function heightColumns(cloud: PointCloud, kept: Uint32Array, heights: StoreyHeights): HeightColumns {
  const { positions } = cloud;
  const size = columnSize(positions, kept, heights);
  const bins = heightBins(heights);
  const sorted = sortIntoColumns(positions, kept, heights, size);
  const { table } = sorted;
  const filled = fillBins(positions, sorted, heights, bins);
  const between = pointsByColumn(
    sorted,
    (i) => positions[3 * i + 2] >= bins.low && positions[3 * i + 2] < bins.high,
  );
  const { overhead, isWallTop } = overheadOf({
    ...filled,
    bins: bins.bins,
    table,
    size,
    heights,
    heightsAbove: topHeights(positions, sorted, filled, bins),
    endsAt: (c, z) => Math.abs(highestOf(positions, between, c) - z) <= PLANE_REACH,
  });
  // What hangs over no column is not a number, and no point is above that.
  const over = pointsByColumn(sorted, (i, c) => positions[3 * i + 2] > overhead[c] - PLANE_REACH);
  return {
    size,
    heights,
    count: table.count,
    table,
    centres: centresOf(positions, between),
    hits: Uint8Array.from(overhead, (_, c) => countBins(filled.masks, c, 0, bins.bins)),
    bins: bins.bins,
    binsPerMetre: bins.binsPerMetre,
    low: bins.low,
    masks: filled.masks,
    overhead,
    isWallTop,
    planes: filled.planes,
    points: between.points,
    start: between.start,
    overPoints: over.points,
    overStart: over.start,
    overCentres: centresOf(positions, over),
  };
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

/** The bins between floor and ceiling. */
interface HeightBins extends Pick<HeightColumns, 'bins' | 'binsPerMetre' | 'low'> {
  /** Height of the highest bin's top, m, in the cloud's frame. */
  readonly high: number;
}

function heightBins({ floor, ceiling, isOpenAbove }: StoreyHeights): HeightBins {
  const [low, high] = [floor + PLANE_REACH, isOpenAbove ? ceiling : ceiling - PLANE_REACH];
  const bins = Math.max(1, Math.min(MOST_BINS, Math.round((high - low) / BIN)));
  const binsPerMetre = bins / (high - low);
  return { low, high, bins, binsPerMetre };
}

/** The points of a storey, and the column of each. */
interface SortedPoints {
  readonly table: CellTable;
  readonly kept: Uint32Array;
  /** −1 for points of other storeys. */
  readonly columnOf: Int32Array;
}

function sortIntoColumns(
  positions: Float32Array,
  kept: Uint32Array,
  { floor, ceiling }: StoreyHeights,
  size: number,
): SortedPoints {
  const table = new CellTable(kept.length / 16);
  const columnOf = new Int32Array(kept.length).fill(-1);
  for (let k = 0; k < kept.length; k++) {
    const i = 3 * kept[k];
    const z = positions[i + 2];
    if (z < floor - PLANE_REACH || z > ceiling + PLANE_REACH) continue;
    columnOf[k] = table.add(Math.floor(positions[i] / size), Math.floor(positions[i + 1] / size), 0);
  }
  return { table, kept, columnOf };
}

type FilledBins = Pick<HeightColumns, 'masks' | 'planes'>;

function fillBins(
  positions: Float32Array,
  { table, kept, columnOf }: SortedPoints,
  { floor, isOpenAbove }: StoreyHeights,
  heightBins: HeightBins,
): FilledBins {
  const { low, high } = heightBins;
  const masks = new Int32Array(2 * table.count);
  const planes = new Uint8Array(table.count);
  for (let k = 0; k < kept.length; k++) {
    const column = columnOf[k];
    if (column < 0) continue;
    const z = positions[3 * kept[k] + 2];
    if (z < low) planes[column] |= Math.abs(z - floor) <= PLANE_REACH ? 1 : 0;
    else if (z < high) setBin(masks, column, binOf(heightBins, z));
    else if (!isOpenAbove) planes[column] |= 2;
  }
  return { masks, planes };
}

function binOf({ low, bins, binsPerMetre }: HeightBins, z: number): number {
  return Math.min(bins - 1, Math.floor((z - low) * binsPerMetre));
}

/** Mean height of each column's highest points, m: those of its two highest bins, over which noise spreads a surface. */
function topHeights(
  positions: Float32Array,
  { table, kept, columnOf }: SortedPoints,
  { masks }: FilledBins,
  heightBins: HeightBins,
): Float32Array {
  const sums = new Float32Array(table.count);
  const counts = new Uint32Array(table.count);
  for (let k = 0; k < kept.length; k++) {
    const column = columnOf[k];
    const z = positions[3 * kept[k] + 2];
    if (column < 0 || z < heightBins.low || z >= heightBins.high) continue;
    if (binOf(heightBins, z) < highestBin(masks, column) - 1) continue;
    sums[column] += z;
    counts[column]++;
  }
  return sums.map((sum, c) => sum / counts[c]);
}

type ColumnPoints = Pick<HeightColumns, 'points' | 'start'>;

/** Indices of the points that count, column by column. */
function pointsByColumn(
  { table, kept, columnOf }: SortedPoints,
  counts: (point: number, column: number) => boolean,
): ColumnPoints {
  const start = new Uint32Array(table.count + 1);
  const isOwn = (k: number) => columnOf[k] >= 0 && counts(kept[k], columnOf[k]);
  for (let k = 0; k < kept.length; k++) if (isOwn(k)) start[columnOf[k] + 1]++;
  for (let c = 0; c < table.count; c++) start[c + 1] += start[c];
  const points = new Uint32Array(start[table.count]);
  const next = start.slice(0, table.count);
  for (let k = 0; k < kept.length; k++) if (isOwn(k)) points[next[columnOf[k]]++] = kept[k];
  return { points, start };
}

/** Height of the highest point of a column between floor and ceiling, m; −∞ where it has none. */
function highestOf(positions: Float32Array, { points, start }: ColumnPoints, c: number): number {
  let highest = -Infinity;
  for (let k = start[c]; k < start[c + 1]; k++) highest = Math.max(highest, positions[3 * points[k] + 2]);
  return highest;
}

function centresOf(positions: Float32Array, { points, start }: ColumnPoints): Float64Array {
  const count = start.length - 1;
  const centres = new Float64Array(2 * count);
  for (let c = 0; c < count; c++) {
    for (let k = start[c]; k < start[c + 1]; k++) {
      centres[2 * c] += positions[3 * points[k]];
      centres[2 * c + 1] += positions[3 * points[k] + 1];
    }
    centres[2 * c] /= start[c + 1] - start[c];
    centres[2 * c + 1] /= start[c + 1] - start[c];
  }
  return centres;
}

/** The column at a place; −1 where there is none. */
export function columnAt({ table, size }: HeightColumns, x: number, y: number): number {
  return table.find(Math.floor(x / size), Math.floor(y / size), 0);
}

/** Whether floor or ceiling was seen in the column at a place. */
export function hasPlane(columns: HeightColumns, x: number, y: number): boolean {
  const c = columnAt(columns, x, y);
  return c >= 0 && columns.planes[c] !== 0;
}

/** The points between floor and ceiling of some columns, x, y each, told from an origin, m. */
export function pointsOf(
  { positions }: PointCloud,
  { points, start }: HeightColumns,
  columns: readonly number[],
  [x0, y0]: readonly [x: number, y: number] = [0, 0],
): Float64Array {
  let size = 0;
  for (const c of columns) size += start[c + 1] - start[c];
  const xy = new Float64Array(2 * size);
  let n = 0;
  for (const c of columns) {
    for (let k = start[c]; k < start[c + 1]; k++) {
      xy[n++] = positions[3 * points[k]] - x0;
      xy[n++] = positions[3 * points[k] + 1] - y0;
    }
  }
  return xy;
}

/** The bin that ends below a ceiling at height `z`. */
export function binAt({ low, binsPerMetre, bins }: HeightColumns, z: number): number {
  return Math.max(1, Math.min(bins, Math.round((z - PLANE_REACH - low) * binsPerMetre)));
}

/** Share of the bins that are filled in the slice below a ceiling at height `z`, `band` m high. */
export function topShare(
  columns: HeightColumns,
  masks: Int32Array,
  owner: number,
  z: number,
  band = TOP_BAND,
): number {
  const top = binAt(columns, z);
  const bottom = Math.max(0, top - Math.round(band * columns.binsPerMetre));
  return countBins(masks, owner, bottom, top) / Math.max(1, top - bottom);
}
