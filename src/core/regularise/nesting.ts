import { type Bounds, boundsOf, pointInRing } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';

/** Which of some rings lies in which. */
export interface Nesting {
  /** Whether ring `inner` lies in ring `outer`. */
  has(outer: number, inner: number): boolean;
}

/**
 * Which of some rings that do not cross lies in which, exactly. O(rings²) boxes, O(vertices) for each pair of boxes one in
 * the other.
 */
export function nestingOf(rings: readonly Ring[]): Nesting {
  const inside = new Set<number>();
  const boxes = rings.map(boundsOf);
  rings.forEach((outer, r) => {
    rings.forEach((inner, s) => {
      if (r !== s && contains(boxes[r], boxes[s]) && liesIn(inner, outer)) inside.add(r * rings.length + s);
    });
  });
  return { has: (outer, inner) => inside.has(outer * rings.length + inner) };
}

function contains(a: Bounds, b: Bounds): boolean {
  return a.minX <= b.minX && a.minY <= b.minY && a.maxX >= b.maxX && a.maxY >= b.maxY;
}

/** By the first vertex that is not on the outer ring; rings may share vertices. */
function liesIn(inner: Ring, outer: Ring): boolean {
  for (let i = 0; i < inner.length; i += 2) {
    const place = pointInRing(inner[i], inner[i + 1], outer);
    if (place !== 0) return place > 0;
  }
  return false;
}
