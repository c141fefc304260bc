import type { Vec3 } from '../../core/types.ts';

/** Cells a side that the order tells apart, around the centre; strays beyond share the outermost. 3 × 17 bits fit a float64. */
const HALF_WINDOW = 2 ** 16;
const DIGIT_BITS = 11;
const DIGITS = 1 << DIGIT_BITS;

/** Points to be ordered. */
export interface OrderedPoints {
  /** x, y, z a point; entries past 3 · count are not looked at. */
  readonly xyz: Float64Array;
  readonly count: number;
  /** Edge of a cell, same unit. */
  readonly cell: number;
  /** Somewhere amid the points. */
  readonly centre: Vec3;
  /** A box that holds them. */
  readonly bounds: { readonly min: Vec3; readonly max: Vec3 };
}

/**
 * Indices of points by cell (z slowest, x fastest), then by coordinates: an order that forgets the one they came in.
 *
 * Radix sort of the packed cell numbers. Complexity: O(n) for points spread over cells.
 */
export function orderByCell(points: OrderedPoints): Uint32Array {
  const { low, high, bits } = packCells(points);
  const order = radixOrder(low, high, bits);
  sortTies(points, low, high, order);
  return order;
}

interface PackedCells {
  /** The cell's number modulo 2³², and what is above. */
  readonly low: Uint32Array;
  readonly high: Uint32Array;
  /** Bits of the largest number. */
  readonly bits: number;
}

function packCells(points: OrderedPoints): PackedCells {
  const { xyz, count } = points;
  const [x, y, z] = [0, 1, 2].map((axis) => axisCells(points, axis));
  const low = new Uint32Array(count);
  const high = new Uint32Array(count);
  for (let i = 0; i < count; i++) {
    const ix = cellOf(xyz[3 * i], x) - x.least;
    const iy = cellOf(xyz[3 * i + 1], y) - y.least;
    const iz = cellOf(xyz[3 * i + 2], z) - z.least;
    const number = (iz * y.cells + iy) * x.cells + ix;
    low[i] = number;
    high[i] = number / 2 ** 32;
  }
  return { low, high, bits: Math.ceil(Math.log2(x.cells * y.cells * z.cells + 1)) };
}

/** The cells of one axis: the one at the centre, the first in use and how many from there on. */
interface AxisCells {
  readonly inverse: number;
  readonly middle: number;
  readonly least: number;
  readonly cells: number;
}

function axisCells({ cell, centre, bounds }: OrderedPoints, axis: number): AxisCells {
  const inverse = 1 / cell;
  const lattice = { inverse, middle: Math.floor(centre[axis] * inverse) };
  const least = cellOf(bounds.min[axis], lattice);
  return { ...lattice, least, cells: cellOf(bounds.max[axis], lattice) - least + 1 };
}

function cellOf(value: number, { inverse, middle }: Pick<AxisCells, 'inverse' | 'middle'>): number {
  const index = Math.floor(value * inverse) - middle;
  return index < -HALF_WINDOW ? -HALF_WINDOW : index >= HALF_WINDOW ? HALF_WINDOW - 1 : index;
}

/** Least significant digit first; the digits of a pass are laid out first, so that the scatter fetches little. */
function radixOrder(low: Uint32Array, high: Uint32Array, bits: number): Uint32Array {
  const count = low.length;
  let order = new Uint32Array(count);
  for (let i = 0; i < count; i++) order[i] = i;
  let next = new Uint32Array(count);
  const digits = new Uint16Array(count);
  const starts = new Uint32Array(DIGITS + 1);
  for (let shift = 0; shift < bits; shift += DIGIT_BITS) {
    starts.fill(0);
    for (let i = 0; i < count; i++) {
      const digit = digitOf(low[i], high[i], shift);
      digits[i] = digit;
      starts[digit + 1]++;
    }
    for (let digit = 0; digit < DIGITS; digit++) starts[digit + 1] += starts[digit];
    for (let i = 0; i < count; i++) {
      const index = order[i];
      next[starts[digits[index]]++] = index;
    }
    [order, next] = [next, order];
  }
  return order;
}

function digitOf(low: number, high: number, shift: number): number {
  if (shift >= 32) return (high >>> (shift - 32)) & (DIGITS - 1);
  const above = shift + DIGIT_BITS > 32 ? high << (32 - shift) : 0;
  return ((low >>> shift) | above) & (DIGITS - 1);
}

function sortTies({ xyz }: OrderedPoints, low: Uint32Array, high: Uint32Array, order: Uint32Array): void {
  const byPlace = (a: number, b: number) =>
    xyz[3 * a + 2] - xyz[3 * b + 2] || xyz[3 * a + 1] - xyz[3 * b + 1] || xyz[3 * a] - xyz[3 * b];
  let begin = 0;
  for (let i = 1; i <= order.length; i++) {
    const isTie =
      i < order.length && low[order[i]] === low[order[begin]] && high[order[i]] === high[order[begin]];
    if (isTie) continue;
    if (i - begin > 1) order.subarray(begin, i).sort(byPlace);
    begin = i;
  }
}
