import type { Bounds } from '../../core/geometry/rings.ts';
import type { Ring } from '../../core/types.ts';

/** Whether a box lies in a polygon without touching its edges. */
export function isClear(rings: readonly Ring[], box: Bounds): boolean {
  if (meetsEdges(rings, box)) return false;
  const [x, y] = [(box.minX + box.maxX) / 2, (box.minY + box.maxY) / 2];
  let isInside = false;
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      const [ax, ay, bx, by] = [ring[j], ring[j + 1], ring[i], ring[i + 1]];
      if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside;
    }
  }
  return isInside;
}

/** Whether an edge of closed rings runs through a box. */
export function meetsEdges(rings: readonly Ring[], box: Bounds): boolean {
  for (const ring of rings) {
    for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
      if (crosses(ring[j], ring[j + 1], ring[i], ring[i + 1], box)) return true;
    }
  }
  return false;
}

/** Whether a segment comes into a box: what the sides of the box leave of it [Liang84]. */
function crosses(ax: number, ay: number, bx: number, by: number, box: Bounds): boolean {
  let [low, high] = [0, 1];
  for (const [from, way, least, most] of [
    [ax, bx - ax, box.minX, box.maxX],
    [ay, by - ay, box.minY, box.maxY],
  ]) {
    if (way === 0) {
      if (from <= least || from >= most) return false;
      continue;
    }
    const [first, second] = [(least - from) / way, (most - from) / way];
    low = Math.max(low, Math.min(first, second));
    high = Math.min(high, Math.max(first, second));
  }
  return low < high;
}
