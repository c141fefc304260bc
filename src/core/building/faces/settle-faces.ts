import type { PointCloud } from '../../types.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { turnBetween } from './column-directions.ts';
import { alongOf, asideOf, endsOf, type Face, pointOn } from './face.ts';
import { fitLine } from './fit-line.ts';

/** Faces nearer than this to a longer one beside them are its noise or its skirting, m. */
const SAME_FACE = 0.04;
/** … unless they turn by more from it, radians. */
const DOUBLE_TURN = Math.PI / 12;
/** Faces in one line whose offsets differ by no more than this are one wall, m: a plasterer's tolerance over a room. */
const SAME_LINE = 0.015;
/** … and whose directions differ by no more than this, radians. */
const SAME_TURN = (0.5 * Math.PI) / 180;
/** Farther apart along their line, faces are fitted each by itself, m. */
const LONGEST_GAP = 4;
/** Directions are one when they differ by so many of their standard errors … */
const ERRORS = 3;
/** … to which scanners add this much, m at a face's ends: registration drifts. */
const DRIFT = 0.003;
/** Faces whose directions differ by more are no candidates for a right angle, radians. */
const MOST_SNAP = (3 * Math.PI) / 180;

/**
 * Faces that are one become one, and directions that the evidence cannot tell apart become equal or square.
 *
 * A true skew is left alone: a wall is turned only within what its own points leave open.
 */
export function settleFaces(cloud: PointCloud, columns: HeightColumns, faces: readonly Face[]): Face[] {
  const longest = [...faces].sort((a, b) => b.to - b.from - (a.to - a.from));
  const apart = dropDoubles(longest);
  return squareUp(joinAligned(cloud, columns, apart));
}

function lengthOf({ from, to }: Face): number {
  return to - from;
}

/** Turn between the directions of two faces, 0 to π/2. */
function turnOf(a: Face, b: Face): number {
  return turnBetween(Math.atan2(a.ny, a.nx), Math.atan2(b.ny, b.nx));
}

function dropDoubles(longest: readonly Face[]): Face[] {
  const kept: Face[] = [];
  for (const face of longest) {
    const isDouble = kept.some((other) => {
      if (turnOf(face, other) > DOUBLE_TURN) return false;
      return endsOf(face).every(([x, y]) => {
        const along = alongOf(other, x, y);
        const band = Math.max(SAME_FACE, 3 * other.noise);
        return (
          Math.abs(asideOf(other, x, y)) <= band &&
          along > other.from - SAME_FACE &&
          along < other.to + SAME_FACE
        );
      });
    });
    if (!isDouble) kept.push(face);
  }
  return kept;
}

function joinAligned(cloud: PointCloud, columns: HeightColumns, faces: readonly Face[]): Face[] {
  const joined: Face[] = [];
  for (const face of faces) {
    const at = joined.findIndex((other) => areAligned(other, face));
    const together =
      at < 0
        ? null
        : fitLine(cloud, columns, { ...joined[at], members: [...joined[at].members, ...face.members] });
    if (together && together.noise <= 1.25 * Math.max(joined[at].noise, face.noise)) joined[at] = together;
    else joined.push(face);
  }
  return joined;
}

function areAligned(a: Face, b: Face): boolean {
  if (turnOf(a, b) > SAME_TURN + error(a) + error(b)) return false;
  const [from, to] = endsOf(b).map((end) => alongOf(a, ...end));
  const gap = Math.max(Math.min(from, to) - a.to, a.from - Math.max(from, to));
  if (gap > LONGEST_GAP) return false;
  return endsOf(b).every((end) => Math.abs(asideOf(a, ...end)) <= SAME_LINE + lengthOf(b) * error(b));
}

/** Standard error of a face's direction, radians. */
function error(face: Face): number {
  const length = lengthOf(face);
  return face.noise / (length * Math.sqrt(face.support / 12)) + DRIFT / length;
}

function squareUp(faces: readonly Face[]): Face[] {
  const frames = dominantFrames(faces);
  return faces.map((face) => {
    const own = Math.atan2(face.ny, face.nx);
    for (const frame of frames) {
      const { square, turn } = nearestOf(frame, own);
      if (Math.abs(turn) <= Math.min(MOST_SNAP, ERRORS * (error(face) + frame.error)))
        return turned(face, square);
    }
    return face;
  });
}

interface DirectionFrame {
  /** Direction of one of its two axes, radians. */
  readonly angle: number;
  readonly error: number;
  readonly weight: number;
}

/** The nearest to a direction of a frame's four, and the turn to the direction from it, −π/4 to π/4. */
function nearestOf({ angle }: DirectionFrame, direction: number) {
  const quarters = Math.round((direction - angle) / (Math.PI / 2)) * (Math.PI / 2);
  return { square: angle + quarters, turn: direction - angle - quarters };
}

/** Pairs of square directions that faces agree on, the one with most length first. */
function dominantFrames(faces: readonly Face[]): DirectionFrame[] {
  const frames: DirectionFrame[] = [];
  for (const face of [...faces].sort((a, b) => error(a) - error(b))) {
    const own = Math.atan2(face.ny, face.nx);
    const at = frames.findIndex(
      (frame) => Math.abs(nearestOf(frame, own).turn) <= ERRORS * (error(face) + frame.error),
    );
    const weight = 1 / error(face) ** 2;
    if (at < 0) {
      frames.push({ angle: own, error: error(face), weight });
      continue;
    }
    const frame = frames[at];
    const sum = frame.weight + weight;
    frames[at] = {
      angle: frame.angle + (nearestOf(frame, own).turn * weight) / sum,
      error: 1 / Math.sqrt(sum),
      weight: sum,
    };
  }
  return frames.sort((a, b) => b.weight - a.weight);
}

/** The face turned about the middle of its reach. */
function turned(face: Face, angle: number): Face {
  const middle = (face.from + face.to) / 2;
  const [x, y] = pointOn(face, middle);
  const [nx, ny] = [Math.cos(angle), Math.sin(angle)];
  const along = alongOf({ nx, ny }, x, y);
  const half = (face.to - face.from) / 2;
  return { ...face, nx, ny, offset: x * nx + y * ny, from: along - half, to: along + half };
}
