import type { Gap, Vec2 } from '../core/types.ts';

/** From and to, plan metres. */
export type Stretch = Pick<Gap, 'from' | 'to'>;

export function lengthOf({ from, to }: Stretch): number {
  return Math.hypot(to[0] - from[0], to[1] - from[1]);
}

export function middleOf({ from, to }: Stretch): Vec2 {
  return [(from[0] + to[0]) / 2, (from[1] + to[1]) / 2];
}

/** Unit vector; (0, 0) where it has no length. */
export function directionOf({ from, to }: Stretch): Vec2 {
  const length = lengthOf({ from, to }) || 1;
  return [(to[0] - from[0]) / length, (to[1] - from[1]) / length];
}
