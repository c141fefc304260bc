import type { StageContext } from '../../../src/core/context.ts';
import { createRandom, type Random } from '../../../src/core/random.ts';
import type { Frame, PointCloud, Scan, Vec3, Warning } from '../../../src/core/types.ts';

/** Scans made by hand, for the tests of the stages before the outline. */

/** Corners of an L without any symmetry, m. */
export const ASYMMETRIC_L = [0, 0, 7, 0, 7, 3, 4, 3, 4, 5, 0, 5];

export interface RoomShape {
  /** Corners of the walls, x, y each, m. */
  readonly corners?: readonly number[];
  readonly height?: number;
  readonly floor?: number;
  /** Distance between points, m. */
  readonly spacing?: number;
  /** Largest deviation from the surface, m. */
  readonly noise?: number;
  /** Tables 0.75 m above the floor, over a tenth of it, tell it from the ceiling. */
  readonly hasTable?: boolean;
  readonly seed?: number;
}

/** Points on floor, ceiling, walls and a table, z up, metres. */
export function roomPoints(shape: RoomShape = {}): Float64Array {
  const { corners = ASYMMETRIC_L, height = 2.7, floor = 0, noise = 0.004, seed = 1 } = shape;
  const { spacing = 0.05, hasTable = true } = shape;
  const random = createRandom(seed);
  const points: number[] = [];
  const add = (x: number, y: number, z: number) =>
    points.push(x + jitter(), y + jitter(), floor + z + jitter());
  const jitter = () => (2 * random() - 1) * noise;
  const patch = { corners, spacing };
  const [width, depth] = [0, 1].map((axis) => Math.max(...corners.filter((_, i) => i % 2 === axis)));
  for (const [x, y] of insidePoints(patch)) for (const z of [0, height]) add(x, y, z);
  if (hasTable)
    for (const [x, y] of insidePoints(patch))
      if (x > 1 && x < 1 + 0.4 * width && y > 0.7 && y < 0.7 + 0.25 * depth) add(x, y, 0.75);
  let j = corners.length - 2;
  for (let i = 0; i < corners.length; j = i, i += 2) {
    const [dx, dy] = [corners[i] - corners[j], corners[i + 1] - corners[j + 1]];
    const steps = Math.round(Math.hypot(dx, dy) / spacing);
    for (let s = 0; s < steps; s++) {
      for (let z = spacing; z < height; z += spacing) {
        add(corners[j] + (dx * s) / steps, corners[j + 1] + (dy * s) / steps, z);
      }
    }
  }
  return Float64Array.from(points);
}

function* insidePoints({ corners, spacing }: { corners: readonly number[]; spacing: number }) {
  const xs = corners.filter((_, i) => i % 2 === 0);
  const ys = corners.filter((_, i) => i % 2 === 1);
  for (let x = Math.min(...xs); x <= Math.max(...xs); x += spacing) {
    for (let y = Math.min(...ys); y <= Math.max(...ys); y += spacing) {
      if (isInside(x, y, corners)) yield [x, y] as const;
    }
  }
}

function isInside(x: number, y: number, corners: readonly number[]): boolean {
  let inside = false;
  let j = corners.length - 2;
  for (let i = 0; i < corners.length; j = i, i += 2) {
    const [ax, ay, bx, by] = [corners[j], corners[j + 1], corners[i], corners[i + 1]];
    if (ay > y !== by > y && x < ax + ((bx - ax) * (y - ay)) / (by - ay)) inside = !inside;
  }
  return inside;
}

/** A scan of points given as x, y, z in source coordinates. */
export function makeScan(points: ArrayLike<number>, extra: Partial<Scan> = {}): Scan {
  const origin = extra.origin ?? ([0, 0, 0] as const);
  const positions = Float32Array.from(points, (value, i) => value - origin[i % 3]);
  const count = points.length / 3;
  const side = (pick: (...values: number[]) => number) =>
    [0, 1, 2].map((k) =>
      Array.from(points).reduce((a, v, i) => (i % 3 === k ? pick(a, v) : a), points[k]),
    ) as unknown as Vec3;
  return {
    facts: { name: 'made', format: 'ply', bytes: 0, pointsRead: count, pointsDropped: 0, pointsKept: count },
    positions,
    origin,
    attributes: {},
    bounds: { min: side(Math.min), max: side(Math.max) },
    cellSize: 0,
    stations: [],
    isSlice: false,
    warnings: [],
    ...extra,
  };
}

/** A ready slice of points given as x, y. */
export function makeSliceScan(xy: ArrayLike<number>, extra: Partial<Scan> = {}): Scan {
  const points: number[] = [];
  for (let i = 0; i < xy.length; i += 2) points.push(xy[i], xy[i + 1], 0);
  return makeScan(points, { isSlice: true, ...extra });
}

/** Plan metres are source coordinates. */
export const UPRIGHT_FRAME: Frame = {
  origin: [0, 0, 0],
  planOrigin: [0, 0, 0],
  rotation: [1, 0, 0, 0, 1, 0, 0, 0, 1],
  metresPerUnit: 1,
  unit: 'm',
  up: 'z',
  tilt: 0,
};

/** An upright cloud of points given as x, y, z, metres. */
export function makeCloud(points: ArrayLike<number>, extra: Partial<PointCloud> = {}): PointCloud {
  return {
    frame: UPRIGHT_FRAME,
    positions: Float32Array.from(points),
    attributes: {},
    stations: [],
    floor: null,
    ceiling: null,
    reasons: { unit: '', up: '' },
    isFlat: false,
    ...extra,
  };
}

/** A context that keeps the warnings; its canvas must not be asked. */
export function listen(): { context: StageContext; warnings: Warning[] } {
  const warnings: Warning[] = [];
  const context: StageContext = {
    warn: (warning) => warnings.push(warning),
    progress: () => {},
    strokeTest: () => {
      throw new Error('The canvas was asked.');
    },
  };
  return { context, warnings };
}

export const codesOf = (warnings: readonly Warning[]): string[] => warnings.map(({ code }) => code);

export const everyIndex = (cloud: PointCloud): Uint32Array =>
  Uint32Array.from({ length: cloud.positions.length / 3 }, (_, i) => i);

/** Applies a row-major 3 × 3 matrix to every point. */
export function transform(points: ArrayLike<number>, m: readonly number[]): Float64Array {
  const out = new Float64Array(points.length);
  for (let i = 0; i < points.length; i += 3) {
    for (let row = 0; row < 3; row++) {
      const r = 3 * row;
      out[i + row] = m[r] * points[i] + m[r + 1] * points[i + 1] + m[r + 2] * points[i + 2];
    }
  }
  return out;
}

export const transpose = (m: readonly number[]): number[] => [0, 3, 6, 1, 4, 7, 2, 5, 8].map((i) => m[i]);

/** Rotation about a horizontal axis at angle `heading`, by `angle`; both radians. */
export function tiltMatrix(angle: number, heading: number): number[] {
  const [kx, ky] = [Math.cos(heading), Math.sin(heading)];
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  const t = 1 - c;
  return [c + kx * kx * t, kx * ky * t, ky * s, kx * ky * t, c + ky * ky * t, -kx * s, -ky * s, kx * s, c];
}

/** Stray points around a room, uniform in its bounding box grown by `margin` metres. */
export function strayPoints(count: number, margin: number, random: Random): Float64Array {
  const points: number[] = [];
  for (let i = 0; i < count; i++) {
    points.push(
      -margin + random() * (7 + 2 * margin),
      -margin + random() * (5 + 2 * margin),
      -margin + random() * (2.7 + 2 * margin),
    );
  }
  return Float64Array.from(points);
}

export function concat(...parts: readonly ArrayLike<number>[]): Float64Array {
  return Float64Array.from(parts.flatMap((part) => Array.from(part)));
}

/** The points in another order. */
export function shuffled(points: ArrayLike<number>, stride: number, random: Random): Float64Array {
  const count = points.length / stride;
  const order = Array.from({ length: count }, (_, i) => i);
  for (let i = count - 1; i > 0; i--) {
    const j = Math.floor(random() * (i + 1));
    [order[i], order[j]] = [order[j], order[i]];
  }
  return Float64Array.from(
    order.flatMap((i) => Array.from({ length: stride }, (_, k) => points[stride * i + k])),
  );
}

export function centroidOf(points: ArrayLike<number>): Vec3 {
  const sum = [0, 0, 0];
  for (let i = 0; i < points.length; i++) sum[i % 3] += points[i];
  const count = points.length / 3;
  return [sum[0] / count, sum[1] / count, sum[2] / count];
}
