import { boundsOf, centroid } from '../geometry/rings.ts';
import { rotationBy, turnToSquare } from '../geometry/square-turn.ts';
import { mapped } from '../sheet.ts';
import type { Polygon } from '../types.ts';

interface Placed {
  readonly outline: Polygon;
  readonly x: number;
  readonly y: number;
  readonly bottom: number;
}

/**
 * Rooms as a plan is read that stands square on its sheet: row by row from above, each from left to right. To the row of
 * the highest room belong all whose middle is no lower than its bottom. O(rooms²).
 */
export function inReadingOrder(outlines: readonly Polygon[]): Polygon[] {
  const turn = turnToSquare(outlines);
  let left = outlines.map((outline) => placed(outline, turn)).sort((a, b) => b.y - a.y || a.x - b.x);
  const ordered: Polygon[] = [];
  while (left.length > 0) {
    const { bottom } = left[0];
    const row = left.filter(({ y }, i) => i === 0 || y >= bottom).sort((a, b) => a.x - b.x || b.y - a.y);
    ordered.push(...row.map(({ outline }) => outline));
    left = left.filter((room) => !row.includes(room));
  }
  return ordered;
}

function placed(outline: Polygon, turn: number): Placed {
  const ring = mapped(outline.outer, rotationBy(turn));
  const [x, y] = centroid(ring);
  return { outline, x, y, bottom: boundsOf(ring).minY };
}
