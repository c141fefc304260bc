/** Farther from 0 than this is no place in a building but a mark for "no return": a UTM northing in mm is 10¹⁰. */
export const FARTHEST = 1e12;

/** Whether a point is somewhere, `at` its x; false for NaN too. */
export function isPlace(xyz: Float64Array, at: number): boolean {
  return (
    Math.abs(xyz[at]) <= FARTHEST && Math.abs(xyz[at + 1]) <= FARTHEST && Math.abs(xyz[at + 2]) <= FARTHEST
  );
}
