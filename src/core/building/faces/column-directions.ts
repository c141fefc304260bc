import { Moments } from '../../geometry/moments.ts';
import type { HeightColumns } from '../columns/height-columns.ts';

/** Reach of the look around a column, m: the side of a slender column is about that long. */
const REACH = 0.3;
/** Half width of a line of columns, m: less than half of a thin wall's thickness. */
const HALF_WIDTH = 0.03;
/** Directions tried over half a turn. */
const DIRECTIONS = 36;
/** Columns make a line when so many of the places along it, out of those within half the reach, have one. */
const LEAST_FILLED = 0.6;

/** Lines that columns make with those around them. */
export interface ColumnDirections {
  /** Direction of the normal, 0 to π; NaN where a column and its neighbours make no line. */
  readonly angle: Float64Array;
  /** Length of columns in that line, m: what a seed is chosen by. */
  readonly support: Float64Array;
}

/**
 * The line that each of some columns makes with those of them around it.
 *
 * The direction whose narrow strip through the column holds most neighbours, then the main axis of that strip: both faces of
 * a thin wall lie within reach, and a covariance of all would see neither. O(columns).
 *
 * @param isAsked 1 for the columns that count
 */
export function columnDirections(columns: HeightColumns, isAsked: Uint8Array): ColumnDirections {
  const { count, size } = columns;
  const angle = new Float64Array(count).fill(Number.NaN);
  const support = new Float64Array(count);
  const around = new Neighbours(columns, isAsked);
  const least = LEAST_FILLED * (REACH / size);
  for (let c = 0; c < count; c++) {
    if (isAsked[c] === 0) continue;
    around.lookAt(c);
    const strip = around.bestStrip();
    if (strip.filled < least) continue;
    angle[c] = strip.normal;
    support[c] = strip.filled * size;
  }
  return { angle, support };
}

/** The columns around one, relative to it. */
class Neighbours {
  readonly #columns: HeightColumns;
  readonly #isAsked: Uint8Array;
  readonly #cells: number;
  readonly #dx: Float64Array;
  readonly #dy: Float64Array;
  readonly #weight: Float64Array;
  #found = 0;
  readonly #cos = Float64Array.from({ length: DIRECTIONS }, (_, k) => Math.cos((k * Math.PI) / DIRECTIONS));
  readonly #sin = Float64Array.from({ length: DIRECTIONS }, (_, k) => Math.sin((k * Math.PI) / DIRECTIONS));

  constructor(columns: HeightColumns, isAsked: Uint8Array) {
    this.#columns = columns;
    this.#isAsked = isAsked;
    this.#cells = Math.ceil(REACH / columns.size);
    const most = (2 * this.#cells + 1) ** 2;
    this.#dx = new Float64Array(most);
    this.#dy = new Float64Array(most);
    this.#weight = new Float64Array(most);
  }

  lookAt(column: number): void {
    const { table, centres, hits } = this.#columns;
    const [ix, iy] = table.coordinatesOf(column);
    this.#found = 0;
    for (let oy = -this.#cells; oy <= this.#cells; oy++) {
      for (let ox = -this.#cells; ox <= this.#cells; ox++) {
        const c = table.find(ix + ox, iy + oy, 0);
        if (c < 0 || this.#isAsked[c] === 0) continue;
        this.#dx[this.#found] = centres[2 * c] - centres[2 * column];
        this.#dy[this.#found] = centres[2 * c + 1] - centres[2 * column + 1];
        this.#weight[this.#found++] = hits[c];
      }
    }
  }

  /** Normal of the fullest strip, and columns in it. */
  bestStrip(): { readonly normal: number; readonly filled: number } {
    let best = 0;
    let most = 0;
    for (let d = 0; d < DIRECTIONS; d++) {
      let sum = 0;
      for (let i = 0; i < this.#found; i++) sum += Math.max(0, 1 - this.#across(i, d) / HALF_WIDTH);
      if (sum > most) [best, most] = [d, sum];
    }
    return this.#mainAxis(best);
  }

  #across(i: number, direction: number): number {
    return Math.abs(this.#dy[i] * this.#cos[direction] - this.#dx[i] * this.#sin[direction]);
  }

  #mainAxis(direction: number) {
    const moments = new Moments();
    let filled = 0;
    for (let i = 0; i < this.#found; i++) {
      if (this.#across(i, direction) >= 1.5 * HALF_WIDTH) continue;
      moments.add(this.#dx[i], this.#dy[i], this.#weight[i]);
      filled++;
    }
    const { angle } = moments.spread();
    return { normal: (angle + 1.5 * Math.PI) % Math.PI, filled };
  }
}

/** Angle between two lines, 0 to π/2, from the directions of their normals. */
export function turnBetween(a: number, b: number): number {
  return Math.abs(turnFrom(a, b));
}

/** Turn from one line to another, −π/2 to π/2, from the directions of their normals. */
export function turnFrom(a: number, b: number): number {
  const turn = b - a;
  return turn - Math.PI * Math.round(turn / Math.PI);
}
