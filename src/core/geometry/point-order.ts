/** Bits of one counting-sort digit: its table of counts stays in the first-level cache. */
const DIGIT_BITS = 11;
const DIGITS = 1 << DIGIT_BITS;
/** Two digits a coordinate: four million steps over the extent, so few points share a step. */
const STEPS = DIGITS * DIGITS;
/** Moves a point may cost, on average, before a run goes to a comparison sort. */
const MOVES_PER_POINT = 16;

/**
 * Order of points by x, then y, exact and independent of the order given.
 *
 * Counting sort on coordinates quantised to {@link STEPS} steps, then an insertion pass on the exact coordinates;
 * stretches that are far from sorted (one far point squeezes all others into a step) go to a comparison sort.
 *
 * @param xy x, y a point; finite
 * @returns point numbers in order. Linear but for the stretches named.
 */
export function lexicographicOrder(xy: Float64Array): Uint32Array {
  const n = xy.length >> 1;
  let order = new Uint32Array(n);
  for (let i = 0; i < n; i++) order[i] = i;
  if (n < 2) return order;
  const digits = new Uint32Array(n);
  quantise(xy, 1, digits);
  // y only parts points of one x: of few points its upper digit is enough.
  if (n > DIGITS) order = countingSort(order, digits, 0);
  order = countingSort(order, digits, DIGIT_BITS);
  quantise(xy, 0, digits);
  order = countingSort(order, digits, 0);
  order = countingSort(order, digits, DIGIT_BITS);
  settle(order, xy);
  return order;
}

/** The distinct points in lexicographic order, x, y each; the array given, when it is that already. */
export function distinctPoints(xy: Float64Array): Float64Array {
  if (isStrictlyAscending(xy)) return xy;
  const order = lexicographicOrder(xy);
  const kept = new Float64Array(xy.length);
  let n = 0;
  for (let k = 0; k < order.length; k++) {
    const x = xy[2 * order[k]];
    const y = xy[2 * order[k] + 1];
    if (n > 0 && x === kept[2 * n - 2] && y === kept[2 * n - 1]) continue;
    kept[2 * n] = x;
    kept[2 * n + 1] = y;
    n++;
  }
  return kept.subarray(0, 2 * n);
}

function isStrictlyAscending(xy: Float64Array): boolean {
  for (let i = 2; i < xy.length; i += 2) {
    if (!(xy[i - 2] < xy[i] || (xy[i - 2] === xy[i] && xy[i - 1] < xy[i + 1]))) return false;
  }
  return true;
}

/** Steps of one coordinate over its extent; monotone, so equal or larger coordinates never get a smaller step. */
function quantise(xy: Float64Array, axis: number, steps: Uint32Array): void {
  let min = Number.POSITIVE_INFINITY;
  let max = Number.NEGATIVE_INFINITY;
  for (let i = axis; i < xy.length; i += 2) {
    if (xy[i] < min) min = xy[i];
    if (xy[i] > max) max = xy[i];
  }
  const extent = max - min;
  for (let i = axis, k = 0; i < xy.length; i += 2, k++) {
    steps[k] = extent > 0 ? ((xy[i] - min) / extent) * (STEPS - 1) : 0;
  }
}

function countingSort(
  order: Uint32Array<ArrayBuffer>,
  steps: Uint32Array,
  shift: number,
): Uint32Array<ArrayBuffer> {
  const start = new Uint32Array(DIGITS + 1);
  for (let k = 0; k < order.length; k++) start[((steps[k] >>> shift) & (DIGITS - 1)) + 1]++;
  for (let d = 0; d < DIGITS; d++) start[d + 1] += start[d];
  const sorted = new Uint32Array(order.length);
  for (let k = 0; k < order.length; k++) {
    const digit = (steps[order[k]] >>> shift) & (DIGITS - 1);
    sorted[start[digit]++] = order[k];
  }
  return sorted;
}

/** Brings a nearly sorted order into exact order. */
function settle(order: Uint32Array, xy: Float64Array): void {
  let moves = MOVES_PER_POINT * order.length;
  for (let k = 1; k < order.length; k++) {
    const point = order[k];
    let at = k;
    while (at > 0 && compare(xy, order[at - 1], point) > 0) {
      order[at] = order[at - 1];
      at--;
      moves--;
    }
    order[at] = point;
    if (moves < 0) {
      order.sort((a, b) => compare(xy, a, b));
      return;
    }
  }
}

function compare(xy: Float64Array, a: number, b: number): number {
  return xy[2 * a] - xy[2 * b] || xy[2 * a + 1] - xy[2 * b + 1];
}
