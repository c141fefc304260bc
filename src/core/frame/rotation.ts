import type { Axis, Vec3 } from '../types.ts';

/** Row-major 3 × 3. */
export type Rotation = readonly number[];

/**
 * Source axes → plan axes (right, ahead, up) for each up axis: two source axes a, b with a × b = up, so every
 * one has determinant +1 and no plan is mirrored. z up gives (x, y), y up gives (x, −z).
 */
const UPRIGHT: Readonly<Record<Axis, Rotation>> = {
  z: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  '-z': [1, 0, 0, 0, -1, 0, 0, 0, -1],
  y: [1, 0, 0, 0, 0, -1, 0, 1, 0],
  '-y': [1, 0, 0, 0, 0, 1, 0, -1, 0],
  x: [0, 1, 0, 0, 0, 1, 1, 0, 0],
  '-x': [0, 1, 0, 0, 0, -1, -1, 0, 0],
};

export function uprightRotation(up: Axis): Rotation {
  return UPRIGHT[up];
}

/** Unit vector of an axis in source axes. */
export function axisVector(up: Axis): Vec3 {
  const [, , , , , , x, y, z] = UPRIGHT[up];
  return [x, y, z];
}

/** The smallest rotation that turns the unit vector `from` to (0, 0, 1); `from` must not be (0, 0, −1). */
export function rotationToZ([x, y, z]: Vec3): Rotation {
  const k = 1 / (1 + z);
  return [1 - k * x * x, -k * x * y, -x, -k * x * y, 1 - k * y * y, -y, x, y, z];
}

/** First `b`, then `a`. */
export function multiply(a: Rotation, b: Rotation): Rotation {
  const product: number[] = [];
  for (let row = 0; row < 9; row += 3) {
    for (let column = 0; column < 3; column++) {
      product.push(a[row] * b[column] + a[row + 1] * b[column + 3] + a[row + 2] * b[column + 6]);
    }
  }
  return product;
}

export function rotate(r: Rotation, [x, y, z]: Vec3): Vec3 {
  return [r[0] * x + r[1] * y + r[2] * z, r[3] * x + r[4] * y + r[5] * z, r[6] * x + r[7] * y + r[8] * z];
}
