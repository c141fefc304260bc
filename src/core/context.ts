import type { Warning } from './types.ts';

/**
 * The canvas question of [Stojanovic19] Algorithm 2: which points lie in the stroke of a segment?
 *
 * @param segment ax, ay, bx, by in canvas pixels
 * @param lineWidth stroke width in canvas pixels, butt caps
 * @param xy x, y a point, canvas pixels
 * @returns one entry a point: 1 in the stroke, 0 outside
 */
export type StrokeTest = (
  segment: readonly [ax: number, ay: number, bx: number, by: number],
  lineWidth: number,
  xy: Float64Array,
) => Uint8Array;

/** What an environment alone can do, handed to every stage. */
export interface StageContext {
  /** Notes a degraded result; it travels in the plan and the report. */
  warn(warning: Warning): void;
  /** Share of this stage that is done, 0 to 1. */
  progress(share: number): void;
  /** The real Canvas call: OffscreenCanvas in browser and worker, @napi-rs/canvas in Node. */
  readonly strokeTest: StrokeTest;
  /** A plan point, m, in words a person finds in the source: its coordinates and unit. */
  placeInSource?(x: number, y: number): string;
}
