const SAMPLES = 50_000;
/** Shares of the points that may be astray on either side without moving a trimmed bound. */
const TRIM = 0.02;

/** Of a float32: sign, exponent and some digits. */
const LEADING_BITS = 16;

/** Turns a median absolute deviation into a standard deviation, for a normal distribution. */
export const DEVIATION_BY_MEDIAN = 1.4826;

/** Bounds of a cloud along its three axes, x, y, z. */
export interface Bounds {
  readonly min: Float64Array;
  readonly max: Float64Array;
}

/** Exact bounds. O(n). */
export function boundsOf(positions: Float32Array): Bounds {
  const min = new Float64Array(3).fill(Infinity);
  const max = new Float64Array(3).fill(-Infinity);
  for (let i = 0; i < positions.length; i++) {
    const axis = i % 3;
    if (positions[i] < min[axis]) min[axis] = positions[i];
    if (positions[i] > max[axis]) max[axis] = positions[i];
  }
  return { min, max };
}

/**
 * Bounds of the inner 96 % along each axis, from an evenly strided sample: stray points do not stretch them.
 */
export function trimmedBounds(positions: Float32Array): Bounds {
  const points = positions.length / 3;
  const stride = Math.max(1, Math.floor(points / SAMPLES));
  const values = new Float32Array(Math.ceil(points / stride));
  const min = new Float64Array(3);
  const max = new Float64Array(3);
  for (let axis = 0; axis < 3; axis++) {
    for (let i = 0; i < values.length; i++) values[i] = positions[3 * i * stride + axis];
    const trimmed = Math.floor(values.length * TRIM);
    min[axis] = valueOfRank(values, trimmed);
    max[axis] = valueOfRank(values, values.length - 1 - trimmed);
  }
  return { min, max };
}

/**
 * The value that sorting would bring to place `rank`; NaN where there is none.
 *
 * Values are counted by their leading bits, and only those that share them with the one looked for are sorted. O(n) for
 * values that are spread.
 */
export function valueOfRank(values: Float32Array, rank: number): number {
  const bits = new Int32Array(values.buffer, values.byteOffset, values.length);
  const counts = new Uint32Array(1 << LEADING_BITS);
  for (let i = 0; i < bits.length; i++) counts[leadingBits(bits[i])]++;
  let leading = 0;
  let before = 0;
  while (leading < counts.length && before + counts[leading] <= rank) before += counts[leading++];
  return values.filter((_, i) => leadingBits(bits[i]) === leading).sort()[rank - before] ?? Number.NaN;
}

/** Leading bits of a float32, so turned that they rise with the value: below zero larger bits are smaller values. */
function leadingBits(bits: number): number {
  return (bits < 0 ? ~bits : bits ^ 0x80000000) >>> (32 - LEADING_BITS);
}

/** Longest side. */
export function largestExtent({ min, max }: Bounds): number {
  return Math.max(max[0] - min[0], max[1] - min[1], max[2] - min[2]);
}

/** The value in the middle of `values`, which it sorts; NaN for none. */
export function medianOf(values: Float64Array): number {
  values.sort();
  const middle = values.length >> 1;
  return values.length % 2 === 1 ? values[middle] : (values[middle - 1] + values[middle]) / 2;
}

/** Values that tell a median well enough: its error is then about 3 % of their deviation. */
const MEDIAN_SAMPLE = 2_000;

/** Median of the first `count` of `values`, of which every so-many-th is looked at where they are many. O(1) beyond that. */
export function sampledMedian(values: Float64Array, count: number): number {
  const stride = Math.ceil(count / MEDIAN_SAMPLE);
  return medianOf(Float64Array.from({ length: Math.ceil(count / stride) }, (_, k) => values[k * stride]));
}
