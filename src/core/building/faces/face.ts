import type { Circle } from '../../geometry/circle.ts';
import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import type { LocalCeiling } from '../columns/local-ceiling.ts';

/** A run of columns in a line: points x with normal · x = offset. */
export interface Line {
  readonly nx: number;
  readonly ny: number;
  readonly offset: number;
  /** Reach along (−ny, nx), m. */
  readonly from: number;
  readonly to: number;
  readonly members: readonly number[];
}

/** A line fitted to points. */
export interface Face extends Line {
  /** Standard deviation of its points across it, m. */
  readonly noise: number;
  /** Points that the fit rests on. */
  readonly support: number;
  /** The curved wall that it is a chord of. */
  readonly arc?: Circle;
}

/** The storey that faces stand in. */
export interface FaceSite {
  readonly cloud: PointCloud;
  readonly columns: HeightColumns;
  readonly ceiling: LocalCeiling;
}

/** Cosine of the angle up to which lines are parallel, 3°. */
const SAME_DIRECTION = 0.9986;
/** Sine of the angle from which they cross, 30°. */
const CROSSING = 0.5;

type Place = readonly [x: number, y: number];
type Straight = Pick<Line, 'nx' | 'ny' | 'offset'>;

/** The point at a place along a line, `across` off it on the side of its normal, m. */
export function pointOn({ nx, ny, offset }: Straight, along: number, across = 0): Place {
  return [nx * (offset + across) - ny * along, ny * (offset + across) + nx * along];
}

/** Where along a line a point is, m. */
export function alongOf({ nx, ny }: Pick<Line, 'nx' | 'ny'>, x: number, y: number): number {
  return y * nx - x * ny;
}

/** How far off a line a point is, m, on the side of its normal. */
export function asideOf({ nx, ny, offset }: Straight, x: number, y: number): number {
  return x * nx + y * ny - offset;
}

/** Its two ends, that `from` first, drawn on by `reach` past each, m. */
export function endsOf(line: Line, reach = 0): readonly [Place, Place] {
  return [pointOn(line, line.from - reach), pointOn(line, line.to + reach)];
}

/** How far from a place on a line a parallel one runs, m, whichever way that is turned: with the line's normal where `side` is 1, against it where −1. */
export function behindOf(line: Straight, other: Straight, side: number, [x, y]: Place): number {
  return -side * asideOf(other, x, y) * Math.sign(line.nx * other.nx + line.ny * other.ny);
}

export function isParallel(a: Straight, b: Straight): boolean {
  return Math.abs(a.nx * b.nx + a.ny * b.ny) >= SAME_DIRECTION;
}

/** Where two lines cross; null where they do so at a small angle, or not at all. */
export function crossingOf(a: Straight, b: Straight): Place | null {
  const sine = a.nx * b.ny - a.ny * b.nx;
  if (Math.abs(sine) < CROSSING) return null;
  return [(a.offset * b.ny - b.offset * a.ny) / sine, (a.nx * b.offset - b.nx * a.offset) / sine];
}
