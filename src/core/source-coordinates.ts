import { cutText } from './cut-text.ts';
import type { Circle } from './geometry/circle.ts';
import type { Frame, FrameUnit, Vec2 } from './types.ts';

/** What a written coordinate may be off by, m. */
const WRITTEN = 1e-4;
const MOST_DECIMALS = 8;
/** Longer names of coordinate systems are cut: characters. */
const LONGEST_NAME = 40;

/** Turns plan metres into source units and coordinates, seen from above (contract: plan.geojson, slice.csv). */
export interface SourceCoordinates {
  x(planX: number): number;
  y(planY: number): number;
  /** Decimals that keep the precision in the source's unit. */
  readonly digits: number;
}

/** The unit behind a coordinate: `m`; `units` where it has no name. */
export function sayUnit(unit: FrameUnit): string {
  return unit === 'custom' ? 'units' : unit;
}

/** The unit as a fact of a scan: `in m`, `1 unit = 0.372 m`. */
export function sayScale(unit: FrameUnit, metresPerUnit: number): string {
  return unit === 'custom' ? `1 unit = ${Number(metresPerUnit.toPrecision(4))} m` : `in ${unit}`;
}

/** The coordinate system as a fact of a scan: `EPSG:25832`; of WKT its name. */
export function sayCrs(crs: string): string {
  return cutText(/^\s*\w+\s*[[(]\s*"([^"]+)"/.exec(crs)?.[1] ?? crs.trim(), LONGEST_NAME);
}

/** The way back: a place in source units and coordinates, seen from above, as plan metres. */
export function planPlace({ planOrigin, metresPerUnit }: Frame, sourceX: number, sourceY: number): Vec2 {
  return [(sourceX - planOrigin[0]) * metresPerUnit, (sourceY - planOrigin[1]) * metresPerUnit];
}

/** A place of the plan as a person finds it in the source: `3.20, 0.00`. @param precision m */
export function sayCoordinates(frame: Frame, [x, y]: Vec2, precision: number): string {
  const to = sourceCoordinates(frame, precision);
  // Twice, since rounding may leave a negative zero.
  const say = (value: number) => Number(value.toFixed(to.digits)).toFixed(to.digits);
  return `${say(to.x(x))}, ${say(to.y(y))}`;
}

/** @param precision m */
export function sourceCoordinates(
  { planOrigin, metresPerUnit }: Frame,
  precision = WRITTEN,
): SourceCoordinates {
  // Less than any step, so that a whole power of ten does not round up.
  const digits = Math.ceil(-Math.log10(precision / metresPerUnit) - 1e-9);
  return {
    x: (planX) => planOrigin[0] + planX / metresPerUnit,
    y: (planY) => planOrigin[1] + planY / metresPerUnit,
    digits: Math.min(MOST_DECIMALS, Math.max(0, digits)),
  };
}

/** Circles of the plan in source units and coordinates. */
export function circlesIn(
  to: SourceCoordinates,
  metresPerUnit: number,
  circles: readonly Circle[],
): Circle[] {
  return circles.map(({ cx, cy, radius }) => ({
    cx: to.x(cx),
    cy: to.y(cy),
    radius: radius / metresPerUnit,
  }));
}
