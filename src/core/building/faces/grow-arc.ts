import { type Circle, circleThrough, turnOn } from '../../geometry/circle.ts';
import { Moments } from '../../geometry/moments.ts';
import { connectedColumns } from '../columns/connected-columns.ts';
import type { HeightColumns } from '../columns/height-columns.ts';
import { turnBetween, turnFrom } from './column-directions.ts';
import { type Arc, nearestCircle } from './fit-arc.ts';
import { BAND, type Course, type FreeColumns, LONGEST_BREAK, takeAcross } from './free-columns.ts';

/** Reach of the first look around a column, m. */
const FIRST_REACH = 0.8;
/** A column whose own direction leaves the arc's by more, radians, belongs to another. */
const MOST_TURN = (25 * Math.PI) / 180;
/** In the first look directions may differ by so much, radians: a round column turns fast. */
const FIRST_TURN = (70 * Math.PI) / 180;
/** Radii of curved walls and columns, m. */
const SMALLEST = 0.1;
const LARGEST = 40;
/** An arc turns at least by this, radians: less is a straight wall. */
const LEAST_ARC = (25 * Math.PI) / 180;
/** Share of its length that has columns. */
const LEAST_FILLED = 0.4;
/** Columns farther apart than this along an arc, m, are of two runs; the longest must bend by itself, not only with the others … */
const LONGEST_GAP = 0.3;
/** … that is, its columns lie so many times farther off any line than off the arc. */
const BENDS = 1.5;
const MOST_ROUNDS = 20;
/** Fewer columns make no arc. */
const FEWEST = 6;
/** Columns no farther apart than so many, either way, hang together. */
const TOUCH = 2;

/**
 * Lets an arc grow from a column; null where none fits.
 *
 * @param isWall whether only what bends as one face of a wall does is looked at, or all that bends
 */
export function growArc(walls: FreeColumns, seed: number, isWall: boolean): Arc | null {
  let members: readonly number[] = connectedAround(walls, seed, isWall);
  let arc: Arc | null = null;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const circle = circleOf(walls, members, isWall);
    if (!circle || circle.radius < SMALLEST || circle.radius > LARGEST) return null;
    const grown = alongCircle(walls, circle, seed);
    if (grown === null) return null;
    const isDone = arc !== null && grown.members.length <= arc.members.length;
    if (isDone) break;
    arc = grown;
    members = grown.members;
  }
  return arc !== null && isArc(walls.columns, arc) ? arc : null;
}

/** Whether columns follow a circle closely, far enough around for it to be no line. O(members · log members). */
export function isArc(columns: HeightColumns, arc: Arc): boolean {
  const { size } = columns;
  const { from, to, radius, members } = arc;
  if (radius < SMALLEST || radius > LARGEST) return false;
  const turn = to - from;
  const sagitta = radius * (1 - Math.cos(Math.min(Math.PI, turn / 2)));
  const isFilled = members.length * size >= LEAST_FILLED * turn * radius;
  return turn >= LEAST_ARC && sagitta > 2 * BAND && isFilled && bends(columns, arc);
}

/** Whether the longest run of an arc's columns is told better by it than by a line: a straight wall and what stands elsewhere is no arc. */
function bends({ centres, hits }: HeightColumns, arc: Arc): boolean {
  const { cx, cy, radius, from } = arc;
  const turns = arc.members
    .map((c) => ({ c, turn: turnOn(from, Math.atan2(centres[2 * c + 1] - cy, centres[2 * c] - cx)) }))
    .sort((a, b) => a.turn - b.turn);
  let [longest, begin] = [turns.slice(0, 0), 0];
  for (let end = 1; end <= turns.length; end++) {
    const goesOn = end < turns.length && (turns[end].turn - turns[end - 1].turn) * radius <= LONGEST_GAP;
    if (goesOn) continue;
    if (end - begin > longest.length) longest = turns.slice(begin, end);
    begin = end;
  }
  const moments = new Moments();
  let [squares, weight] = [0, 0];
  for (const { c } of longest) {
    const [dx, dy] = [centres[2 * c] - cx, centres[2 * c + 1] - cy];
    moments.add(dx, dy, hits[c]);
    squares += hits[c] * (Math.hypot(dx, dy) - radius) ** 2;
    weight += hits[c];
  }
  return moments.spread().variance >= BENDS ** 2 * (squares / weight);
}

function circleOf({ columns }: FreeColumns, members: readonly number[], isWall: boolean): Circle | null {
  if (members.length < FEWEST) return null;
  const { centres, hits } = columns;
  const first = circleThrough(
    members.flatMap((c) => [centres[2 * c], centres[2 * c + 1]]),
    members.map((c) => hits[c]),
  );
  return first && isWall ? nearestCircle(columns, members, first) : first;
}

/**
 * Free columns that hang together with one, near it and not turned far from it; of a wall's face, those whose directions are
 * of one circle with it.
 *
 * A chord leaves a circle by half the turn between its ends, whatever the radius: so the other face of a wall is told apart.
 */
function connectedAround({ columns, angle, isFree }: FreeColumns, seed: number, isWall: boolean): number[] {
  const { centres } = columns;
  const [nx, ny] = [Math.cos(angle[seed]), Math.sin(angle[seed])];
  const seen = new Set([seed]);
  return connectedColumns(columns, seed, TOUCH, (c) => {
    if (isFree[c] === 0 || seen.has(c)) return false;
    const [dx, dy] = [centres[2 * c] - centres[2 * seed], centres[2 * c + 1] - centres[2 * seed + 1]];
    if (Math.hypot(dx, dy) > FIRST_REACH || !(turnBetween(angle[c], angle[seed]) <= FIRST_TURN)) return false;
    const off = dx * nx + dy * ny + (dy * nx - dx * ny) * Math.tan(turnFrom(angle[seed], angle[c]) / 2);
    if (isWall && Math.abs(off) > BAND) return false;
    seen.add(c);
    return true;
  });
}

/** Columns along a circle to both sides of a column, as far as they follow each other. */
function alongCircle(walls: FreeColumns, circle: Circle, seed: number): Arc | null {
  const { centres, size } = walls.columns;
  const { cx, cy, radius } = circle;
  const at = Math.atan2(centres[2 * seed + 1] - cy, centres[2 * seed] - cx);
  const step = Math.min(size / 2 / radius, Math.PI / 36);
  const course = courseOf(circle);
  const taken = new Set<number>();
  const reach = [0, 0];
  [1, -1].forEach((side, k) => {
    const most = k === 0 ? 2 * Math.PI : 2 * Math.PI - reach[0];
    for (let turn = 0; turn <= most && (turn - reach[k]) * radius <= LONGEST_BREAK; turn += step) {
      if (takeAcross(walls, course, at + side * turn, taken)) reach[k] = turn;
    }
  });
  if (taken.size < FEWEST) return null;
  return { ...circle, from: at - reach[1], to: at + reach[0], members: [...taken] };
}

/** Places along a circle are directions from its centre, radians. */
function courseOf({ cx, cy, radius }: Circle): Course {
  return {
    pointAt: (direction, across) => [
      cx + (radius + across) * Math.cos(direction),
      cy + (radius + across) * Math.sin(direction),
    ],
    asideOf: (x, y) => Math.hypot(x - cx, y - cy) - radius,
    normalAt: (direction) => direction,
    mostTurn: MOST_TURN,
  };
}
