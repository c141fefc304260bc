import { distinctPoints } from '../geometry/point-order.ts';

/** Every so many of the distinct points in lexicographic order, so the order given does not matter. */
export function evenSample(xy: Float64Array, most: number): Float64Array {
  const distinct = distinctPoints(xy);
  const points = distinct.length / 2;
  if (points <= most) return distinct;
  const sample = new Float64Array(2 * most);
  for (let k = 0; k < most; k++) {
    const i = Math.floor((k * points) / most);
    sample[2 * k] = distinct[2 * i];
    sample[2 * k + 1] = distinct[2 * i + 1];
  }
  return sample;
}
