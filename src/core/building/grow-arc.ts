import { turnBetween } from './column-directions.ts';
import type { WallColumns } from './find-faces.ts';
import { type Arc, circleThrough } from './fit-arc.ts';
import { columnAt } from './height-columns.ts';

/** Reach of the first look around a column, m. */
const FIRST_REACH = 0.8;
/** Columns this far off a growing arc belong to it, m. */
const BAND = 0.04;
/** A column whose own direction leaves the arc's by more, radians, belongs to another. */
const MOST_TURN = (25 * Math.PI) / 180;
/** In the first look directions may differ by so much, radians: a round column turns fast. */
const FIRST_TURN = (70 * Math.PI) / 180;
/** Radii of curved walls and columns, m. */
const SMALLEST = 0.1;
const LARGEST = 40;
/** An arc ends where no column follows for longer than this, m. */
const LONGEST_BREAK = 1.3;
/** An arc turns at least by this, radians: less is a straight wall. */
const LEAST_ARC = (25 * Math.PI) / 180;
/** Share of its length that has columns. */
const LEAST_FILLED = 0.4;
const MOST_ROUNDS = 20;

/** Lets an arc grow from a column; null where none fits. */
export function growArc(walls: WallColumns, seed: number): Arc | null {
  let members: readonly number[] = connectedAround(walls, seed);
  let arc: Arc | null = null;
  for (let round = 0; round < MOST_ROUNDS; round++) {
    const circle = circleOf(walls, members);
    if (!circle || circle.radius < SMALLEST || circle.radius > LARGEST) return null;
    const grown = alongCircle(walls, circle, seed);
    if (grown === null) return null;
    const isDone = arc !== null && grown.members.length <= arc.members.length;
    if (isDone) break;
    arc = grown;
    members = grown.members;
  }
  if (arc === null) return null;
  const { size } = walls.columns;
  const turn = arc.to - arc.from;
  const sagitta = arc.radius * (1 - Math.cos(Math.min(Math.PI, turn / 2)));
  const isFilled = arc.members.length * size >= LEAST_FILLED * turn * arc.radius;
  return turn >= LEAST_ARC && sagitta > 2 * BAND && isFilled ? arc : null;
}

function circleOf({ columns }: WallColumns, members: readonly number[]) {
  if (members.length < 6) return null;
  const { centres, hits } = columns;
  return circleThrough(
    members.map((c) => centres[2 * c]),
    members.map((c) => centres[2 * c + 1]),
    members.map((c) => hits[c]),
  );
}

/** Free columns that hang together with one, near it and not turned far from it. */
function connectedAround({ columns, angle, isFree }: WallColumns, seed: number): number[] {
  const { table, centres } = columns;
  const found = [seed];
  const seen = new Set(found);
  for (let k = 0; k < found.length; k++) {
    const [ix, iy] = table.coordinatesOf(found[k]);
    for (let dy = -2; dy <= 2; dy++) {
      for (let dx = -2; dx <= 2; dx++) {
        const c = table.find(ix + dx, iy + dy, 0);
        if (c < 0 || isFree[c] === 0 || seen.has(c)) continue;
        const away = Math.hypot(
          centres[2 * c] - centres[2 * seed],
          centres[2 * c + 1] - centres[2 * seed + 1],
        );
        if (away > FIRST_REACH || !(turnBetween(angle[c], angle[seed]) <= FIRST_TURN)) continue;
        seen.add(c);
        found.push(c);
      }
    }
  }
  return found;
}

/** Columns along a circle to both sides of a column, as far as they follow each other. */
function alongCircle(
  walls: WallColumns,
  circle: { cx: number; cy: number; radius: number },
  seed: number,
): Arc | null {
  const { columns } = walls;
  const { centres, size } = columns;
  const { cx, cy, radius } = circle;
  const at = Math.atan2(centres[2 * seed + 1] - cy, centres[2 * seed] - cx);
  const step = Math.min(size / 2 / radius, Math.PI / 36);
  const seen = new Set<number>();
  const reach = [0, 0];
  [1, -1].forEach((side, k) => {
    const most = k === 0 ? 2 * Math.PI : 2 * Math.PI - reach[0];
    for (let turn = 0; turn <= most && (turn - reach[k]) * radius <= LONGEST_BREAK; turn += step) {
      if (collectAt(walls, circle, at + side * turn, seen)) reach[k] = turn;
    }
  });
  if (seen.size < 6) return null;
  return { ...circle, from: at - reach[1], to: at + reach[0], members: [...seen] };
}

function collectAt(
  { columns, angle, isFree }: WallColumns,
  { cx, cy, radius }: { cx: number; cy: number; radius: number },
  direction: number,
  seen: Set<number>,
): boolean {
  const { centres, size } = columns;
  let isAny = false;
  for (let across = -BAND; across <= BAND; across += size / 2) {
    const [x, y] = [
      cx + (radius + across) * Math.cos(direction),
      cy + (radius + across) * Math.sin(direction),
    ];
    const c = columnAt(columns, x, y);
    if (c < 0 || isFree[c] === 0) continue;
    if (Math.abs(Math.hypot(centres[2 * c] - cx, centres[2 * c + 1] - cy) - radius) > BAND) continue;
    if (!(turnBetween(angle[c], direction) <= MOST_TURN)) continue;
    seen.add(c);
    isAny = true;
  }
  return isAny;
}
