import type { Vec3 } from '../core/types.ts';

/** A point's station is a 16-bit number. */
export const MOST_STATIONS = 0xffff;

/** Where a scan's own coordinates lie among the file's: place = rotation · own + translation. */
export interface Pose {
  /** Row-major 3 × 3. */
  readonly rotation: readonly number[];
  /** The place of the scan's own 0: of its scanner. */
  readonly translation: Vec3;
}

/** The rotation, row-major 3 × 3, of a quaternion of length 1. */
export function rotationOf(w: number, x: number, y: number, z: number): number[] {
  return [
    ...[1 - 2 * (y * y + z * z), 2 * (x * y - w * z), 2 * (x * z + w * y)],
    ...[2 * (x * y + w * z), 1 - 2 * (x * x + z * z), 2 * (y * z - w * x)],
    ...[2 * (x * z - w * y), 2 * (y * z + w * x), 1 - 2 * (x * x + y * y)],
  ];
}

/** Moves `count` points, x, y, z each, from point `first` on into their place. */
export function applyPose(
  xyz: Float64Array,
  { rotation, translation }: Pose,
  first: number,
  count: number,
): void {
  const [a, b, c, d, e, f, g, h, i] = rotation;
  const [dx, dy, dz] = translation;
  for (let at = 3 * first; at < 3 * (first + count); at += 3) {
    const x = xyz[at];
    const y = xyz[at + 1];
    const z = xyz[at + 2];
    xyz[at] = a * x + b * y + c * z + dx;
    xyz[at + 1] = d * x + e * y + f * z + dy;
    xyz[at + 2] = g * x + h * y + i * z + dz;
  }
}
