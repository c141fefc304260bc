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
