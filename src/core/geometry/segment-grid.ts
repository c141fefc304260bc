import type { Bounds } from './rings.ts';

/** Padding of a segment's span in cells: rounding must not make a segment miss a cell it touches. */
const PADDING = 1e-6;
/** Room for so many entries of each point at first. */
const ENTRIES = 2;

/** A cell edge that makes as many cells as segments: a long one then passes about √n of them. */
export function cellFor({ minX, minY, maxX, maxY }: Bounds, segments: number): number {
  const [width, height] = [maxX - minX, maxY - minY];
  return Math.max(Math.sqrt((width * height) / segments), Math.max(width, height) / segments) || 1;
}

/**
 * A uniform grid over segments between numbered points, for questions "what lies along this segment?".
 *
 * A segment is entered in every cell it passes. Nothing is ever taken out: who asks knows which segments still count.
 */
export class SegmentGrid {
  /** Entries the last {@link along} or {@link around} found: ends of each, in `u` and `v`. */
  found = new Int32Array(64);
  u: Int32Array;
  v: Int32Array;
  private readonly x: Float64Array;
  private readonly y: Float64Array;
  private readonly minX: number;
  private readonly minY: number;
  private readonly cellsPerMetre: number;
  private readonly columns: number;
  private readonly rows: number;
  private readonly head: Int32Array;
  private chain: Int32Array;
  private size = 0;
  // The segment at hand, in cells, and the cells of it at hand.
  private ax = 0;
  private ay = 0;
  private bx = 0;
  private by = 0;
  /** Columns a row. */
  private slope = 0;
  private firstRow = 0;
  private lastRow = 0;
  private firstColumn = 0;
  private lastColumn = 0;

  /** @param x, y coordinates of the points, which must lie in `bounds` */
  constructor(x: Float64Array, y: Float64Array, bounds: Bounds, cell: number) {
    this.x = x;
    this.y = y;
    [this.u, this.v, this.chain] = [0, 0, 0].map(() => new Int32Array(ENTRIES * x.length));
    this.minX = bounds.minX;
    this.minY = bounds.minY;
    this.cellsPerMetre = 1 / cell;
    this.columns = Math.floor((bounds.maxX - bounds.minX) / cell) + 1;
    this.rows = Math.floor((bounds.maxY - bounds.minY) / cell) + 1;
    this.head = new Int32Array(this.columns * this.rows).fill(-1);
  }

  add(u: number, v: number): void {
    this.take(u, v);
    for (let row = this.firstRow; row <= this.lastRow; row++) {
      this.spanInRow(row);
      for (let column = this.firstColumn; column <= this.lastColumn; column++) {
        this.enter(row * this.columns + column, u, v);
      }
    }
  }

  /** Finds the entries of all cells the segment passes, some more than once; their numbers go to `found`. */
  along(u: number, v: number): number {
    this.take(u, v);
    let count = 0;
    for (let row = this.firstRow; row <= this.lastRow; row++) {
      this.spanInRow(row);
      count = this.collect(row, count);
    }
    return count;
  }

  /** Finds the entries of all cells within `reach` of a place along either axis; their numbers go to `found`. */
  around(x: number, y: number, reach: number): number {
    const { cellsPerMetre } = this;
    const firstRow = Math.max(0, Math.floor((y - reach - this.minY) * cellsPerMetre));
    const lastRow = Math.min(this.rows - 1, Math.floor((y + reach - this.minY) * cellsPerMetre));
    this.firstColumn = Math.max(0, Math.floor((x - reach - this.minX) * cellsPerMetre));
    this.lastColumn = Math.min(this.columns - 1, Math.floor((x + reach - this.minX) * cellsPerMetre));
    let count = 0;
    for (let row = firstRow; row <= lastRow; row++) count = this.collect(row, count);
    return count;
  }

  /** Adds the entries of the columns at hand to those found. */
  private collect(row: number, before: number): number {
    const { head, chain } = this;
    const last = row * this.columns + this.lastColumn;
    let { found } = this;
    let count = before;
    for (let cell = row * this.columns + this.firstColumn; cell <= last; cell++) {
      for (let entry = head[cell]; entry >= 0; entry = chain[entry]) {
        if (count === found.length) {
          found = grown(found);
          this.found = found;
        }
        found[count++] = entry;
      }
    }
    return count;
  }

  private enter(cell: number, u: number, v: number): void {
    if (this.size === this.chain.length) {
      this.chain = grown(this.chain);
      this.u = grown(this.u);
      this.v = grown(this.v);
    }
    this.u[this.size] = u;
    this.v[this.size] = v;
    this.chain[this.size] = this.head[cell];
    this.head[cell] = this.size++;
  }

  /** Takes a segment at hand, and the rows it passes. */
  private take(u: number, v: number): void {
    const { x, y, minX, minY, cellsPerMetre } = this;
    this.ax = (x[u] - minX) * cellsPerMetre;
    this.ay = (y[u] - minY) * cellsPerMetre;
    this.bx = (x[v] - minX) * cellsPerMetre;
    this.by = (y[v] - minY) * cellsPerMetre;
    this.slope = (this.bx - this.ax) / (this.by - this.ay);
    this.firstRow = Math.max(0, Math.floor(Math.min(this.ay, this.by) - PADDING));
    this.lastRow = Math.min(this.rows - 1, Math.floor(Math.max(this.ay, this.by) + PADDING));
  }

  /** Takes the columns at hand that the segment touches within a row. */
  private spanInRow(row: number): void {
    const { ax, ay, bx, by } = this;
    let least = Math.min(ax, bx);
    let most = Math.max(ax, bx);
    if (this.firstRow < this.lastRow && ay !== by) {
      const from = ax + (Math.max(Math.min(ay, by), row - PADDING) - ay) * this.slope;
      const to = ax + (Math.min(Math.max(ay, by), row + 1 + PADDING) - ay) * this.slope;
      least = Math.max(Math.min(from, to), least);
      most = Math.min(Math.max(from, to), most);
    }
    this.firstColumn = Math.max(0, Math.floor(least - PADDING));
    this.lastColumn = Math.min(this.columns - 1, Math.floor(most + PADDING));
  }
}

function grown(values: Int32Array): Int32Array<ArrayBuffer> {
  const larger = new Int32Array(2 * values.length);
  larger.set(values);
  return larger;
}
