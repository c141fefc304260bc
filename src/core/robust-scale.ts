/** Of a float32: sign, exponent and some digits; as many follow. */
const LEADING_BITS = 16;
const FOLLOWING = 0xffff;

/** Values that tell a median well enough: its error is then about 3 % of their deviation. */
const MEDIAN_SAMPLE = 2_000;

/** Turns a median absolute deviation into a standard deviation, for a normal distribution. */
export const DEVIATION_BY_MEDIAN = 1.4826;

/** The value in the middle of `values`, which it sorts; NaN for none. */
export function medianOf(values: Float64Array): number {
  values.sort();
  const middle = values.length >> 1;
  return values.length % 2 === 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/** The value at or below which half of the weight lies; NaN for none. */
export function weightedMedian(values: ArrayLike<number>, weights: ArrayLike<number>): number {
  const rising = Uint32Array.from(values, (_, i) => i).sort((i, j) => values[i] - values[j]);
  let rest = 0;
  for (const i of rising) rest += weights[i] / 2;
  for (const i of rising) {
    rest -= weights[i];
    if (rest <= 0) return values[i];
  }
  return Number.NaN;
}

/** Median of the first `count` of `values`, of which every so-many-th is looked at where they are many. O(1) beyond that. */
export function sampledMedian(values: Float64Array, count: number): number {
  const stride = Math.ceil(count / MEDIAN_SAMPLE);
  return medianOf(Float64Array.from({ length: Math.ceil(count / stride) }, (_, k) => values[k * stride]));
}

/**
 * The value that sorting would bring to place `rank`; NaN where there is none.
 *
 * Values are counted by their leading bits, and those that share them with the one looked for by the bits that follow. O(n).
 */
export function valueOfRank(values: Float32Array, rank: number): number {
  const bits = new Int32Array(values.buffer, values.byteOffset, values.length);
  const counts = new Uint32Array(1 << LEADING_BITS);
  for (let i = 0; i < bits.length; i++) counts[risingBits(bits[i]) >>> LEADING_BITS]++;
  const leading = placeOfRank(counts, rank);
  if (leading.place === counts.length) return Number.NaN;
  counts.fill(0);
  for (let i = 0; i < bits.length; i++) {
    const rising = risingBits(bits[i]);
    if (rising >>> LEADING_BITS === leading.place) counts[rising & FOLLOWING]++;
  }
  const following = placeOfRank(counts, rank - leading.before);
  const rising = (leading.place << LEADING_BITS) | following.place;
  return new Float32Array(Int32Array.of(rising < 0 ? rising ^ 0x80000000 : ~rising).buffer)[0];
}

/** Bits of a float32, so turned that they rise with the value: below zero larger bits are smaller values. */
function risingBits(bits: number): number {
  return bits < 0 ? ~bits : bits ^ 0x80000000;
}

/** The place among counted ones that holds the one of a rank, and how many come before it. */
function placeOfRank(counts: Uint32Array, rank: number): { place: number; before: number } {
  let place = 0;
  let before = 0;
  while (place < counts.length && before + counts[place] <= rank) before += counts[place++];
  return { place, before };
}
