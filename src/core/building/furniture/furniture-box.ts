import { convexHull } from '../../geometry/convex-hull.ts';
import type { Ring } from '../../types.ts';

/** Share of the points that may lie outside a box at each of its sides: noise. */
const TRIMMED = 0.01;
/** What stands askew in its room fits a box that much smaller than one along the wall; people set things by walls. */
const ASKEW = 0.85;

/** A box by its direction and its reach along (u) and across it (v), m. */
export interface Box {
  /** Unit vector. */
  readonly ux: number;
  readonly uy: number;
  readonly minU: number;
  readonly maxU: number;
  readonly minV: number;
  readonly maxV: number;
}

type Direction = readonly [ux: number, uy: number];

/**
 * The box around points, along a wall or, where that is much smaller, along an edge of their hull. O(n log n).
 *
 * @param seen measured points, x, y each: the outermost are noise
 * @param known places that are in the box for sure, likewise
 */
export function boxAround(seen: Float64Array, known: Float64Array, wall: Direction): Box {
  const all = new Float64Array(seen.length + known.length);
  all.set(seen);
  all.set(known, seen.length);
  const hull = convexHull(all);
  const along = extentOf(hull, wall);
  let best = along;
  for (let i = 0; i < hull.length; i += 2) {
    const j = (i + 2) % hull.length;
    const [dx, dy] = [hull[j] - hull[i], hull[j + 1] - hull[i + 1]];
    const length = Math.hypot(dx, dy);
    if (length === 0) continue;
    const box = extentOf(hull, [dx / length, dy / length]);
    if (areaOfBox(box) < areaOfBox(best)) best = box;
  }
  const { ux, uy } = areaOfBox(best) < ASKEW * areaOfBox(along) ? best : along;
  return united(trimmedExtent(seen, [ux, uy]), extentOf(known, [ux, uy]));
}

/** Its corners, counter-clockwise. */
export function cornersOf({ ux, uy, minU, maxU, minV, maxV }: Box): Ring {
  const at = (u: number, v: number) => [u * ux - v * uy, u * uy + v * ux];
  return Float64Array.from([at(minU, minV), at(maxU, minV), at(maxU, maxV), at(minU, maxV)].flat());
}

export function areaOfBox({ minU, maxU, minV, maxV }: Box): number {
  return (maxU - minU) * (maxV - minV);
}

function extentOf(xy: Float64Array, [ux, uy]: Direction): Box {
  let [minU, maxU, minV, maxV] = [Infinity, -Infinity, Infinity, -Infinity];
  for (let i = 0; i < xy.length; i += 2) {
    const [u, v] = [xy[i] * ux + xy[i + 1] * uy, xy[i + 1] * ux - xy[i] * uy];
    [minU, maxU] = [Math.min(minU, u), Math.max(maxU, u)];
    [minV, maxV] = [Math.min(minV, v), Math.max(maxV, v)];
  }
  return { ux, uy, minU, maxU, minV, maxV };
}

function trimmedExtent(xy: Float64Array, [ux, uy]: Direction): Box {
  const n = xy.length / 2;
  const u = Float64Array.from({ length: n }, (_, i) => xy[2 * i] * ux + xy[2 * i + 1] * uy).sort();
  const v = Float64Array.from({ length: n }, (_, i) => xy[2 * i + 1] * ux - xy[2 * i] * uy).sort();
  const first = Math.floor(TRIMMED * n);
  const last = n - 1 - first;
  return { ux, uy, minU: u[first], maxU: u[last], minV: v[first], maxV: v[last] };
}

function united(a: Box, b: Box): Box {
  return {
    ...a,
    minU: Math.min(a.minU, b.minU),
    maxU: Math.max(a.maxU, b.maxU),
    minV: Math.min(a.minV, b.minV),
    maxV: Math.max(a.maxV, b.maxV),
  };
}
