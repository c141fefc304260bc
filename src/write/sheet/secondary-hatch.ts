import type { Operation } from '../../core/types.ts';

interface Hatch {
  /** Radians, y down. */
  readonly angle: number;
  /** mm */
  readonly spacing: number;
}

const RISING = -Math.PI / 4;
const FALLING = Math.PI / 4;

/** How a secondary boundary is hatched: subtracted falls, added crosses, independent rises; all at 45°. */
export const HATCHES: Record<Operation, readonly Hatch[]> = {
  subtract: [{ angle: FALLING, spacing: 1.5 }],
  add: [
    { angle: RISING, spacing: 0.9 },
    { angle: FALLING, spacing: 0.9 },
  ],
  independent: [{ angle: RISING, spacing: 1.5 }],
};
