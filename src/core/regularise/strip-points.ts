import type { PointGrid } from '../geometry/point-grid.ts';

/** Rounding may put a point into the cell beside the one its strip reaches, in cells. */
const ROUNDING = 1e-6;

/** A strip along a directed segment, in its own frame: `along` from its start, `across` to its left. */
export interface Strip {
  readonly x: number;
  readonly y: number;
  /** Unit direction. */
  readonly ux: number;
  readonly uy: number;
  readonly along: readonly [from: number, to: number];
  readonly across: readonly [from: number, to: number];
}

/** Points in a strip's own frame; the arrays are used again by the next strip. */
export class StripPoints {
  along = new Float64Array(256);
  across = new Float64Array(256);
  size = 0;
  private readonly grid: PointGrid;

  constructor(grid: PointGrid) {
    this.grid = grid;
  }

  /** Gathers the points in a strip, in the order of the grid. O(cells and points in the strip's rows). */
  gather(strip: Strip): void {
    this.size = 0;
    const { minX, minY, cell, columns, rows, start } = this.grid;
    const corners = cornersOf(strip);
    const low = Math.min(corners[1], corners[3], corners[5], corners[7]);
    const high = Math.max(corners[1], corners[3], corners[5], corners[7]);
    const firstRow = Math.max(0, Math.floor((low - minY) / cell));
    const lastRow = Math.min(rows - 1, Math.floor((high - minY) / cell));
    for (let row = firstRow; row <= lastRow; row++) {
      const span = extent(corners, minY + (row - ROUNDING) * cell, minY + (row + 1 + ROUNDING) * cell);
      if (span === null) continue;
      const first = Math.max(0, Math.floor((span[0] - minX) / cell - ROUNDING));
      const last = Math.min(columns - 1, Math.floor((span[1] - minX) / cell + ROUNDING));
      if (first > last) continue;
      this.take(strip, start[row * columns + first], start[row * columns + last + 1]);
    }
  }

  private take({ x, y, ux, uy, along, across }: Strip, from: number, to: number): void {
    for (let k = from; k < to; k++) {
      const dx = this.grid.x[k] - x;
      const dy = this.grid.y[k] - y;
      const a = dx * ux + dy * uy;
      const b = dy * ux - dx * uy;
      if (a < along[0] || a > along[1] || b < across[0] || b > across[1]) continue;
      if (this.size === this.along.length) this.grow();
      this.along[this.size] = a;
      this.across[this.size++] = b;
    }
  }

  private grow(): void {
    const [along, across] = [this.along, this.across];
    this.along = new Float64Array(2 * along.length);
    this.across = new Float64Array(2 * across.length);
    this.along.set(along);
    this.across.set(across);
  }
}

/** Corners in order, x, y each. */
function cornersOf({ x, y, ux, uy, along, across }: Strip): Float64Array {
  const corners = new Float64Array(8);
  for (let k = 0; k < 4; k++) {
    const a = along[k === 0 || k === 3 ? 0 : 1];
    const b = across[k < 2 ? 0 : 1];
    corners[2 * k] = x + a * ux - b * uy;
    corners[2 * k + 1] = y + a * uy + b * ux;
  }
  return corners;
}

/** Least and greatest x of a strip between two heights y; null where it does not reach. */
function extent(corners: Float64Array, low: number, high: number): readonly [number, number] | null {
  let least = Number.POSITIVE_INFINITY;
  let most = Number.NEGATIVE_INFINITY;
  for (let k = 0; k < 8; k += 2) {
    const ax = corners[k];
    const ay = corners[k + 1];
    const bx = corners[(k + 2) & 7];
    const by = corners[(k + 3) & 7];
    if (Math.max(ay, by) < low || Math.min(ay, by) > high) continue;
    // The part of this side between the heights.
    const slope = ay === by ? 0 : (bx - ax) / (by - ay);
    const enter = ay === by ? ax : ax + (Math.min(Math.max(ay, low), high) - ay) * slope;
    const leave = ay === by ? bx : ax + (Math.min(Math.max(by, low), high) - ay) * slope;
    least = Math.min(least, enter, leave);
    most = Math.max(most, enter, leave);
  }
  return least > most ? null : [least, most];
}
