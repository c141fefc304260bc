import { isCounterClockwise } from '../geometry/rings.ts';
import { lineIntersection } from '../geometry/segments.ts';
import { isSimpleRing } from '../geometry/simplicity.ts';
import type { Ring } from '../types.ts';
import { RingEdges } from './ring-edges.ts';

/** Points of a face lie this many deviations within the outermost of them … */
const FACE_DEPTH = 1.5;
/**
 * … and are looked at from so many deviations outside of the face to so many inside: further in an inner face begins.
 * The mean of a normal distribution cut there lies this much further out.
 */
const [LOOK_OUT, LOOK_IN, CUT_MEAN] = [2, 1, 0.23];
const ROUNDS = 4;
/** A corner goes no further than this many deviations from where it was. */
const CORNER_REACH = 6;

/**
 * Moves each side of an outline, which runs along the outermost points, in to the middle of the face's points.
 *
 * Ours: mean shift with a window over the outer part of the noise, so that an inner face close behind hardly pulls.
 * Corners are where the moved sides meet.
 *
 * @param ring simple, counter-clockwise
 * @param noise standard deviation across a face, m
 * @returns simple, counter-clockwise; the ring given where moved sides would cross
 */
export function fitSides(ring: Ring, xy: Float64Array, noise: number): Ring {
  const edges = new RingEdges([{ outer: ring, holes: [] }]);
  const depths: number[][] = Array.from({ length: edges.count }, () => []);
  for (let i = 0; i < xy.length; i += 2) {
    edges.project(xy[i], xy[i + 1]);
    if (edges.along >= 0 && edges.along <= edges.length[edges.edge]) depths[edges.edge].push(edges.across);
  }
  const moved = movedRing(
    ring,
    depths.map((values) => faceDepth(values, noise)),
    noise,
  );
  return isCounterClockwise(moved) && isSimpleRing(moved) ? moved : ring;
}

function faceDepth(depths: readonly number[], noise: number): number {
  let depth = FACE_DEPTH * noise;
  for (let round = 0; round < ROUNDS; round++) {
    let sum = 0;
    let count = 0;
    for (const value of depths) {
      if (value < depth - LOOK_OUT * noise || value > depth + LOOK_IN * noise) continue;
      sum += value;
      count++;
    }
    if (count > 0) depth = sum / count + CUT_MEAN * noise;
  }
  return depth;
}

function movedRing(ring: Ring, depths: readonly number[], noise: number): Ring {
  const n = ring.length / 2;
  const lines = depths.map((depth, e) => {
    const [ax, ay, bx, by] = [0, 1, 2, 3].map((k) => ring[(2 * e + k) % ring.length]);
    const length = Math.hypot(bx - ax, by - ay);
    const [nx, ny] = [(-(by - ay) / length) * depth, ((bx - ax) / length) * depth];
    return [ax + nx, ay + ny, bx + nx, by + ny] as const;
  });
  const moved = new Float64Array(ring.length);
  for (let v = 0; v < n; v++) {
    const [before, after] = [lines[(v + n - 1) % n], lines[v]];
    const [x, y] = [(before[2] + after[0]) / 2, (before[3] + after[1]) / 2];
    const corner = lineIntersection(...before, ...after);
    const isNear = corner && Math.hypot(corner[0] - x, corner[1] - y) <= CORNER_REACH * noise;
    [moved[2 * v], moved[2 * v + 1]] = isNear ? corner : [x, y];
  }
  return moved;
}
