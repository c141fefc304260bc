import { boundsOf, centroid } from '../geometry/rings.ts';
import { rotationBy, turnToSquare } from '../geometry/square-turn.ts';
import { mapped } from '../sheet.ts';
import type { Polygon } from '../types.ts';

interface Placed {
  readonly outline: Polygon;
  readonly x: number;
  readonly y: number;
  readonly top: number;
}

/**
 * Rooms as a plan is read that stands square on its sheet: row by row from above, each from left to right. To the row of
 * the room whose middle is highest belong all that begin above that. O(rooms²).
 */
export function inReadingOrder(outlines: readonly Polygon[]): Polygon[] {
  const turn = turnToSquare(outlines);
  let left = outlines.map((outline) => placed(outline, turn)).sort((a, b) => b.y - a.y || a.x - b.x);
  const ordered: Polygon[] = [];
  while (left.length > 0) {
    const middle = left[0].y;
    const row = left.filter(({ top }, i) => i === 0 || top > middle).sort((a, b) => a.x - b.x || b.y - a.y);
    ordered.push(...row.map(({ outline }) => outline));
    left = left.filter((room) => !row.includes(room));
  }
  return ordered;
}

function placed(outline: Polygon, turn: number): Placed {
  const ring = mapped(outline.outer, rotationBy(turn));
  const [x, y] = centroid(ring);
  return { outline, x, y, top: boundsOf(ring).maxY };
}
