import type { Vec2 } from '../../core/types.ts';

/** A box along the axes, plan or source, one unit throughout. */
export interface Box {
  readonly low: Vec2;
  readonly high: Vec2;
}

/** Which sides of a box a hand holds: −1 the low one, 1 the high one, 0 none; `all` moves it. */
export type Grip = readonly [x: -1 | 0 | 1, y: -1 | 0 | 1] | 'all';

const SIDES = [-1, 0, 1] as const;

/** Corners and middles of sides. */
export const HANDLES = SIDES.flatMap((x) => SIDES.map((y) => [x, y] as const)).filter(
  ([x, y]) => x !== 0 || y !== 0,
);

/** Where a handle of a box is. */
export function handleAt({ low, high }: Box, [x, y]: readonly [number, number]): Vec2 {
  return [at(low[0], high[0], x), at(low[1], high[1], y)];
}

/** What a hand takes at a place: the nearest handle within `reach`, a side, the whole box inside; null outside. */
export function gripAt(box: Box, [x, y]: Vec2, reach: number): Grip | null {
  const near = HANDLES.map((handle) => {
    const [hx, hy] = handleAt(box, handle);
    return { handle, distance: Math.hypot(hx - x, hy - y) };
  }).sort((a, b) => a.distance - b.distance)[0];
  if (near.distance <= reach) return near.handle;
  const { low, high } = box;
  const isBeside = x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach;
  if (!isBeside) return null;
  const side = [sideAt(low[0], high[0], x, reach), sideAt(low[1], high[1], y, reach)] as const;
  return side[0] === 0 && side[1] === 0 ? 'all' : side;
}

/** The box after what is held has been moved; dragged past its other side it turns over. */
export function dragged({ low, high }: Box, grip: Grip, [dx, dy]: Vec2): Box {
  const [gx, gy] = grip === 'all' ? [0, 0] : grip;
  const isWhole = grip === 'all';
  const x = [low[0] + (isWhole || gx < 0 ? dx : 0), high[0] + (isWhole || gx > 0 ? dx : 0)];
  const y = [low[1] + (isWhole || gy < 0 ? dy : 0), high[1] + (isWhole || gy > 0 ? dy : 0)];
  return boxBetween([x[0], y[0]], [x[1], y[1]]);
}

/** The box with two opposite corners. */
export function boxBetween(a: Vec2, b: Vec2): Box {
  return {
    low: [Math.min(a[0], b[0]), Math.min(a[1], b[1])],
    high: [Math.max(a[0], b[0]), Math.max(a[1], b[1])],
  };
}

function at(low: number, high: number, side: number): number {
  return (low * (1 - side) + high * (1 + side)) / 2;
}

function sideAt(low: number, high: number, value: number, reach: number): -1 | 0 | 1 {
  if (Math.abs(value - low) <= reach) return -1;
  return Math.abs(value - high) <= reach ? 1 : 0;
}
