import { CellTable } from '../cell-table.ts';

/** Height bins of the histogram, m: finer than any slab, coarser than a level floor's noise. */
export const BIN = 0.02;
/** Half width in bins over which a surface's area is gathered: 5 cm of noise, sills and tilt. */
export const REACH = 2;
/** Cells that a height bin's area is counted in, m: coarser than a thinned cloud's voxels … */
const AREA_CELL = 0.1;
/** … and, so many of them wide, those in which something is looked for above and below: sparse scans leave cells empty. */
const WIDE = 4;

export interface HeightAreas {
  /** Where the lowest bin begins, m. */
  readonly low: number;
  /** Cells with points, a bin. */
  readonly areas: Float64Array;
  /** Those of them with other points far above or below. */
  readonly enclosed: Float64Array;
}

/** Histogram of horizontal area over height; cells are enclosed by points `far` (m) above or below. O(n). */
export function areaByHeight(positions: Float32Array, kept: Uint32Array, far: number): HeightAreas {
  let [low, high] = [Infinity, -Infinity];
  for (const i of kept) {
    low = Math.min(low, positions[3 * i + 2]);
    high = Math.max(high, positions[3 * i + 2]);
  }
  const areas = new Float64Array(Math.floor((high - low) / BIN) + 1);
  const cells = new CellTable(kept.length / 4);
  for (const i of kept) {
    const bin = Math.floor((positions[3 * i + 2] - low) / BIN);
    const before = cells.count;
    cells.add(Math.floor(positions[3 * i] / AREA_CELL), Math.floor(positions[3 * i + 1] / AREA_CELL), bin);
    if (cells.count > before) areas[bin]++;
  }
  return { low, areas, enclosed: enclosedCells(cells, areas.length, far / BIN) };
}

/** Cells a bin that have others so many bins above or below. O(cells). */
function enclosedCells(cells: CellTable, bins: number, far: number): Float64Array {
  const wide = new CellTable(cells.count / WIDE);
  const wideOf = new Uint32Array(cells.count);
  const [lowest, highest]: [number[], number[]] = [[], []];
  for (let cell = 0; cell < cells.count; cell++) {
    const [ix, iy, bin] = cells.coordinatesOf(cell);
    const w = wide.add(Math.floor(ix / WIDE), Math.floor(iy / WIDE), 0);
    wideOf[cell] = w;
    lowest[w] = Math.min(lowest[w] ?? bin, bin);
    highest[w] = Math.max(highest[w] ?? bin, bin);
  }
  const enclosed = new Float64Array(bins);
  for (let cell = 0; cell < cells.count; cell++) {
    const [, , bin] = cells.coordinatesOf(cell);
    const w = wideOf[cell];
    if (highest[w] - bin >= far || bin - lowest[w] >= far) enclosed[bin]++;
  }
  return enclosed;
}

export interface Peak {
  readonly bin: number;
  /** Cells with points, less what walls alone give. */
  readonly area: number;
  /** Share of its cells with others far above or below. */
  readonly enclosed: number;
}

/** Bins that hold more than any other within reach, and twice what walls alone give. */
export function peaksOf({ areas, enclosed }: HeightAreas): Peak[] {
  const gathered = gather(areas);
  const inside = gather(enclosed);
  const walls = Float64Array.from(gathered).sort()[gathered.length >> 1];
  const peaks: Peak[] = [];
  for (let bin = 0; bin < areas.length; bin++) {
    const area = gathered[bin] - walls;
    if (area < walls) continue;
    let isHighest = true;
    for (let k = Math.max(0, bin - 2 * REACH); k <= Math.min(areas.length - 1, bin + 2 * REACH); k++) {
      if (gathered[k] > gathered[bin] || (gathered[k] === gathered[bin] && k < bin)) isHighest = false;
    }
    if (isHighest) peaks.push({ bin, area, enclosed: inside[bin] / gathered[bin] });
  }
  return peaks;
}

/** Sums over the bins within reach of each. */
function gather(areas: Float64Array): Float64Array {
  return areas.map((_, bin) => {
    let sum = 0;
    for (let k = Math.max(0, bin - REACH); k <= Math.min(areas.length - 1, bin + REACH); k++) sum += areas[k];
    return sum;
  });
}
