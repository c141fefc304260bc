import type { Ring } from '../types.ts';

/** A circle in the plan, m. */
export interface Circle {
  readonly cx: number;
  readonly cy: number;
  readonly radius: number;
}

/** A circle's circumference is looked at in so many parts. */
const ARC_BINS = 36;
/** Vertices of a drawn circle: none turns by more than 5°. */
const VERTICES = 72;
/** Places lie in a line when their variance across it is less than about this share of that along it. */
const STRAIGHT = 1e-9;

/**
 * Circle of least squares of squared distances through places ([Kåsa76]); null where they lie in a line. O(places).
 *
 * @param xy x, y a place, m
 * @param weights one a place; all alike where there are none
 */
export function circleThrough(xy: ArrayLike<number>, weights?: ArrayLike<number>): Circle | null {
  const count = xy.length / 2;
  let [sw, mx, my] = [0, 0, 0];
  for (let i = 0; i < count; i++) {
    const w = weights?.[i] ?? 1;
    sw += w;
    mx += w * xy[2 * i];
    my += w * xy[2 * i + 1];
  }
  mx /= sw;
  my /= sw;
  let [xx, cross, yy, xq, yq, q] = [0, 0, 0, 0, 0, 0];
  for (let i = 0; i < count; i++) {
    const [x, y, w] = [xy[2 * i] - mx, xy[2 * i + 1] - my, weights?.[i] ?? 1];
    const s = x * x + y * y;
    xx += w * x * x;
    cross += w * x * y;
    yy += w * y * y;
    xq += w * x * s;
    yq += w * y * s;
    q += w * s;
  }
  const determinant = xx * yy - cross * cross;
  if (!(determinant > STRAIGHT * (xx + yy) ** 2)) return null;
  const cx = (xq * yy - yq * cross) / (2 * determinant);
  const cy = (yq * xx - xq * cross) / (2 * determinant);
  return { cx: cx + mx, cy: cy + my, radius: Math.sqrt(cx * cx + cy * cy + q / sw) };
}

/** How far off a circle places are, root mean square, m, and the share of it that has places beside it. */
export function offCircle(xy: Float64Array, { cx, cy, radius }: Circle): { rms: number; arc: number } {
  const isSeen = new Uint8Array(ARC_BINS);
  let squares = 0;
  for (let i = 0; i < xy.length; i += 2) {
    squares += (Math.hypot(xy[i] - cx, xy[i + 1] - cy) - radius) ** 2;
    const turn = Math.atan2(xy[i + 1] - cy, xy[i] - cx) / (2 * Math.PI) + 0.5;
    isSeen[Math.min(ARC_BINS - 1, Math.floor(turn * ARC_BINS))] = 1;
  }
  const arc = isSeen.reduce((sum, seen) => sum + seen, 0) / ARC_BINS;
  return { rms: Math.sqrt((2 * squares) / xy.length), arc };
}

/** A circle as a fine counter-clockwise ring on it. */
export function circleRing({ cx, cy, radius }: Circle): Ring {
  const ring = new Float64Array(2 * VERTICES);
  for (let k = 0; k < VERTICES; k++) {
    const angle = (2 * Math.PI * k) / VERTICES;
    ring[2 * k] = cx + radius * Math.cos(angle);
    ring[2 * k + 1] = cy + radius * Math.sin(angle);
  }
  return ring;
}

/** Turn from one direction on to another counter-clockwise, 0 to 2π, radians. */
export function turnOn(from: number, to: number): number {
  const turn = to - from;
  return turn - 2 * Math.PI * Math.floor(turn / (2 * Math.PI));
}
