import type { Bounds } from './rings.ts';

/** Padding of a segment's span in cells: rounding must not make a segment miss a cell it touches. */
const PADDING = 1e-6;

/**
 * A uniform grid over segments between numbered points, for questions "what lies along this segment?".
 *
 * A segment is entered in every cell it passes. Nothing is ever taken out: who asks knows which segments still count.
 */
export class SegmentGrid {
  /** Entries the last {@link along} found: ends of each, in `u` and `v`. */
  found = new Int32Array(64);
  u = new Int32Array(256);
  v = new Int32Array(256);
  private readonly x: Float64Array;
  private readonly y: Float64Array;
  private readonly minX: number;
  private readonly minY: number;
  private readonly cell: number;
  private readonly columns: number;
  private readonly rows: number;
  private readonly head: Int32Array;
  private chain = new Int32Array(256);
  private size = 0;
  private firstColumn = 0;
  private lastColumn = 0;

  /** @param x, y coordinates of the points, which must lie in `bounds` */
  constructor(x: Float64Array, y: Float64Array, bounds: Bounds, cell: number) {
    this.x = x;
    this.y = y;
    this.minX = bounds.minX;
    this.minY = bounds.minY;
    this.cell = cell;
    this.columns = Math.floor((bounds.maxX - bounds.minX) / cell) + 1;
    this.rows = Math.floor((bounds.maxY - bounds.minY) / cell) + 1;
    this.head = new Int32Array(this.columns * this.rows).fill(-1);
  }

  add(u: number, v: number): void {
    const rowRange = this.rowsOf(u, v);
    for (let row = rowRange[0]; row <= rowRange[1]; row++) {
      this.spanInRow(u, v, row);
      for (let column = this.firstColumn; column <= this.lastColumn; column++) {
        this.enter(row * this.columns + column, u, v);
      }
    }
  }

  /** Finds the entries of all cells the segment passes, some more than once; their numbers go to `found`. */
  along(u: number, v: number): number {
    let count = 0;
    const rowRange = this.rowsOf(u, v);
    for (let row = rowRange[0]; row <= rowRange[1]; row++) {
      this.spanInRow(u, v, row);
      for (let column = this.firstColumn; column <= this.lastColumn; column++) {
        for (let entry = this.head[row * this.columns + column]; entry >= 0; entry = this.chain[entry]) {
          if (count === this.found.length) this.found = grown(this.found);
          this.found[count++] = entry;
        }
      }
    }
    return count;
  }

  /** Finds the entries of all cells within `reach` of a place along either axis; their numbers go to `found`. */
  around(x: number, y: number, reach: number): number {
    const firstRow = Math.max(0, Math.floor((y - reach - this.minY) / this.cell));
    const lastRow = Math.min(this.rows - 1, Math.floor((y + reach - this.minY) / this.cell));
    const firstColumn = Math.max(0, Math.floor((x - reach - this.minX) / this.cell));
    const lastColumn = Math.min(this.columns - 1, Math.floor((x + reach - this.minX) / this.cell));
    let count = 0;
    for (let row = firstRow; row <= lastRow; row++) {
      for (let column = firstColumn; column <= lastColumn; column++) {
        for (let entry = this.head[row * this.columns + column]; entry >= 0; entry = this.chain[entry]) {
          if (count === this.found.length) this.found = grown(this.found);
          this.found[count++] = entry;
        }
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

  private rowsOf(u: number, v: number): readonly [first: number, last: number] {
    const a = (this.y[u] - this.minY) / this.cell;
    const b = (this.y[v] - this.minY) / this.cell;
    return [
      Math.max(0, Math.floor(Math.min(a, b) - PADDING)),
      Math.min(this.rows - 1, Math.floor(Math.max(a, b) + PADDING)),
    ];
  }

  /** Columns the segment touches within a row, in cells. */
  private spanInRow(u: number, v: number, row: number): void {
    const ax = (this.x[u] - this.minX) / this.cell;
    const bx = (this.x[v] - this.minX) / this.cell;
    const ay = (this.y[u] - this.minY) / this.cell;
    const by = (this.y[v] - this.minY) / this.cell;
    let from = ax;
    let to = bx;
    if (ay !== by) {
      const slope = (bx - ax) / (by - ay);
      const enter = Math.max(Math.min(ay, by), row - PADDING);
      const leave = Math.min(Math.max(ay, by), row + 1 + PADDING);
      from = ax + (enter - ay) * slope;
      to = ax + (leave - ay) * slope;
    }
    const least = Math.max(Math.min(from, to), Math.min(ax, bx));
    const most = Math.min(Math.max(from, to), Math.max(ax, bx));
    this.firstColumn = Math.max(0, Math.floor(least - PADDING));
    this.lastColumn = Math.min(this.columns - 1, Math.floor(most + PADDING));
  }
}

function grown(values: Int32Array): Int32Array<ArrayBuffer> {
  const larger = new Int32Array(2 * values.length);
  larger.set(values);
  return larger;
}
