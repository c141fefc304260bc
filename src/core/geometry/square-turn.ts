import type { Affine } from '../sheet.ts';
import type { Polygon } from '../types.ts';
import { ringsOf } from './rings.ts';

/** The walls' direction is clear when this share of their length agrees on it; a round hall has none. */
const AGREED = 1 / 3;
/** Walls agree that stand within so much of each other, radians: out of square, but not askew. */
const ALIKE = Math.PI / 60;
/** The direction of short or rough walls is no surer than 1°: less is left, and sheet and scan keep the same axes. */
const UNSURE = Math.PI / 180;
/** Walls in one direction and walls square to it are alike. */
const QUARTER = Math.PI / 2;
/** Directions are counted in so many classes of a quarter turn. */
const CLASSES = 180;

/** An edge's direction modulo a quarter turn, and its length. */
type Run = readonly [angle: number, length: number];

/**
 * How far the plan is turned so that its walls stand square on the sheet and dimensions are those of walls, not of the
 * box around a slanted building: the direction, modulo 90°, that most of the length of their edges agrees on;
 * walls askew to the rest do not draw it aside. O(vertices).
 *
 * @returns radians, counter-clockwise, at most an eighth of a turn either way
 */
export function turnToSquare(areas: readonly Polygon[]): number {
  const runs = ringsOf(areas).flatMap(runsOf);
  const total = runs.reduce((sum, [, length]) => sum + length, 0);
  const middle = commonest(runs);
  let [agreeing, aside] = [0, 0];
  for (const [angle, length] of runs) {
    const off = nearestTurn(angle - middle);
    if (Math.abs(off) > ALIKE) continue;
    agreeing += length;
    aside += off * length;
  }
  if (total === 0 || agreeing <= AGREED * total) return 0;
  const turn = -nearestTurn(middle + aside / agreeing);
  return Math.abs(turn) < UNSURE ? 0 : turn;
}

function runsOf(ring: Float64Array): Run[] {
  const runs: Run[] = [];
  for (let i = 0; i < ring.length; i += 2) {
    const j = (i + 2) % ring.length;
    const [dx, dy] = [ring[j] - ring[i], ring[j + 1] - ring[i + 1]];
    runs.push([nearestTurn(Math.atan2(dy, dx)), Math.hypot(dx, dy)]);
  }
  return runs;
}

/** The direction that has the most length about it, within what is alike; what is nearer counts for more. */
function commonest(runs: readonly Run[]): number {
  const step = QUARTER / CLASSES;
  const lengths = new Float64Array(CLASSES);
  for (const [angle, length] of runs) {
    lengths[Math.round(angle / step + CLASSES) % CLASSES] += length;
  }
  const reach = Math.floor(ALIKE / step);
  const around = lengths.map((_, i) => {
    let sum = 0;
    for (let k = -reach; k <= reach; k++) {
      sum += (reach + 1 - Math.abs(k)) * lengths[(i + k + CLASSES) % CLASSES];
    }
    return sum;
  });
  return around.indexOf(Math.max(...around)) * step;
}

/** The same direction modulo a quarter turn, at most an eighth of a turn either way. */
function nearestTurn(angle: number): number {
  return angle - QUARTER * Math.round(angle / QUARTER);
}

/** The turn about the origin as a map. */
export function rotationBy(turn: number): Affine {
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  return turn === 0 ? [1, 0, 0, 1, 0, 0] : [cos, sin, -sin, cos, 0, 0];
}
