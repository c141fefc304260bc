import { DEVIATION_BY_MEDIAN, sampledMedian } from '../../robust-scale.ts';

/** Tukey's biweight ([Beaton74]), by which lines and arcs are fitted to the points of a face again and again. */

/** Residuals past so many deviations count nothing … */
const DEVIATIONS = 4;
/** … but those within this always do, m: half the step between a wall and its skirting. */
const LEAST_REACH = 0.012;
/** Smallest deviation told, m: what a made-up cloud without noise has. */
const LEAST_NOISE = 0.0005;

/** Deviation to start with, m. */
export const FIRST_NOISE = 0.012;

/** Residuals from here on count nothing, m. */
export function reachOfNoise(noise: number): number {
  return Math.max(LEAST_REACH, DEVIATIONS * noise);
}

/** Weight of a residual, told as a share of the reach, −1 to 1. */
export function biweight(share: number): number {
  return (1 - share * share) ** 2;
}

/** Standard deviation that the first `count` residuals, without sign, tell. */
export function noiseOf(residuals: Float64Array, count: number): number {
  return Math.max(LEAST_NOISE, DEVIATION_BY_MEDIAN * sampledMedian(residuals, count));
}
