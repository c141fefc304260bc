import type { Affine } from '../sheet.ts';
import type { Polygon } from '../types.ts';

/** The walls' direction is clear when this share of their length agrees on it; a round hall has none. */
const AGREED = 0.5;
/** The direction of short or rough walls is no surer than 1°: less is left, and sheet and scan keep the same axes. */
const UNSURE = Math.PI / 180;
/** Walls in one direction and walls square to it are alike: directions repeat four times a turn. */
const FOLD = 4;

/**
 * How far the plan is turned so that its walls stand square on the sheet and dimensions are those of walls, not of the
 * box around a slanted building: the mean direction of the edges modulo 90°, weighted by length. O(vertices).
 *
 * @returns radians, counter-clockwise, at most an eighth of a turn either way
 */
export function turnToSquare(polygons: readonly Polygon[]): number {
  let [across, along, total] = [0, 0, 0];
  for (const { outer } of polygons) {
    for (let i = 0; i < outer.length; i += 2) {
      const j = (i + 2) % outer.length;
      const [dx, dy] = [outer[j] - outer[i], outer[j + 1] - outer[i + 1]];
      const length = Math.hypot(dx, dy);
      const angle = FOLD * Math.atan2(dy, dx);
      across += length * Math.cos(angle);
      along += length * Math.sin(angle);
      total += length;
    }
  }
  if (Math.hypot(across, along) <= AGREED * total) return 0;
  const turn = -Math.atan2(along, across) / FOLD;
  return Math.abs(turn) < UNSURE ? 0 : turn;
}

/** The turn about the origin as a map. */
export function rotationBy(turn: number): Affine {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return turn === 0 ? [1, 0, 0, 1, 0, 0] : [cos, sin, -sin, cos, 0, 0];
}
