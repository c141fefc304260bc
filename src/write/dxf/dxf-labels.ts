import { combine } from '../../core/geometry/areas.ts';
import { polygonArea, ringsOf } from '../../core/geometry/rings.ts';
import type { Frame, FrameUnit, Polygon, Ring, Vec2 } from '../../core/types.ts';
import { labelPoint } from '../sheet/label-point.ts';
import { METRES_PER_FOOT } from '../sheet/measure-words.ts';
import { shorten, widthByCapitals } from '../sheet/text-width.ts';
import { type DxfText, legible } from './dxf-drawing.ts';

/** Longest name in a label, letters' widths. */
const LONGEST_NAME = 22;
/** Height of a line, heights of letters. */
const LINE = 5 / 3;
/** Blank around a label, heights of letters. */
const BLANK = 0.3;
/** A label that does not fit is tried this much smaller, and smaller … */
const SHRINK = 0.85;
/** … down to this share; then it takes what the circle around its place leaves. */
const SMALLEST = 0.2;
/** Decimals of an area. */
const AREA_DIGITS = 2;
/** Areas of drawings in feet are told in square feet. */
const IN_FEET: readonly FrameUnit[] = ['ft', 'us-ft'];

export interface LabelFacts {
  readonly name: string;
  readonly outline: Polygon;
  /** Structures that it keeps off where that leaves room. */
  readonly obstacles: readonly Polygon[];
  /** Radians that rooms are turned by to be square. */
  readonly turn: number;
  /** Of letters where they fit, m. */
  readonly height: number;
  readonly frame: Pick<Frame, 'unit' | 'metresPerUnit'>;
  /** Areas in square feet, whatever the drawing's unit. */
  readonly isInFeet: boolean;
}

/**
 * Name and area in the middle of a room, along its walls, as large as asked for where that fits, else smaller or turned;
 * always within its outline.
 */
export function roomLabel({ name, outline, obstacles, turn, height, frame, isInFeet }: LabelFacts): DxfText {
  const title = shorten(name.trim(), 1, LONGEST_NAME);
  const area = sayArea(polygonArea(outline), frame, isInFeet);
  const lines = title === '' ? [area] : [title, area];
  const free = obstacles.length > 0 ? combine('difference', [outline], obstacles) : [outline];
  const places = (free.length > 0 ? free : [outline]).map((piece) => ({ piece, at: labelPoint(piece) }));
  const { piece, at } = places.reduce((best, place) => (place.at[2] > best.at[2] ? place : best));
  // Half of its width and depth for letters 1 high.
  const half: Vec2 = [
    Math.max(...lines.map((line) => widthByCapitals(line, 1))) / 2,
    (1 + (lines.length - 1) * LINE) / 2,
  ];
  const [x, y, distance] = at;
  const rings = ringsOf([piece]);
  for (let size = height; size > SMALLEST * height; size *= SHRINK) {
    const reach: Vec2 = [size * (half[0] + BLANK), size * (half[1] + BLANK)];
    for (const angle of [-turn, legible(Math.PI / 2 - turn)]) {
      if (isBoxFree(rings, [x, y], angle, reach)) {
        return { lines, at: [x, y], height: size, angle, half: [size * half[0], size * half[1]] };
      }
    }
  }
  const size = Math.min(height, Math.max(0, distance) / Math.hypot(half[0] + BLANK, half[1] + BLANK));
  return { lines, at: [x, y], height: size, angle: -turn, half: [size * half[0], size * half[1]] };
}

/** In ASCII, since not every program reads the format's escapes. */
function sayArea(
  squareMetres: number,
  { unit, metresPerUnit }: LabelFacts['frame'],
  isInFeet: boolean,
): string {
  const foot = IN_FEET.includes(unit) ? metresPerUnit : METRES_PER_FOOT;
  return isInFeet || IN_FEET.includes(unit)
    ? `${(squareMetres / foot ** 2).toFixed(AREA_DIGITS)} ft2`
    : `${squareMetres.toFixed(AREA_DIGITS)} m2`;
}

/** Whether no edge meets a box around a place, turned by an angle. */
function isBoxFree(rings: readonly Ring[], [x, y]: Vec2, angle: number, [halfX, halfY]: Vec2): boolean {
  const [cos, sin] = [Math.cos(angle), Math.sin(angle)];
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [ring[j] - x, ring[j + 1] - y, ring[i] - x, ring[i + 1] - y];
      const from: Vec2 = [cos * ax + sin * ay, cos * ay - sin * ax];
      const to: Vec2 = [cos * bx + sin * by, cos * by - sin * bx];
      if (meetsBox(from, to, [halfX, halfY])) return false;
    }
  }
  return true;
}

/** Whether a segment has a point within a box about the origin ([LiangBarsky84]). */
function meetsBox(from: Vec2, to: Vec2, half: Vec2): boolean {
  let [enter, leave] = [0, 1];
  for (const axis of [0, 1] as const) {
    const run = to[axis] - from[axis];
    if (run === 0) {
      if (Math.abs(from[axis]) > half[axis]) return false;
      continue;
    }
    const [a, b] = [(-half[axis] - from[axis]) / run, (half[axis] - from[axis]) / run];
    enter = Math.max(enter, Math.min(a, b));
    leave = Math.min(leave, Math.max(a, b));
  }
  return enter <= leave;
}
