import { ringsOf } from '../../core/geometry/rings.ts';
import type { Ring, Storey, Vec2 } from '../../core/types.ts';
import type { Stretch } from '../stretch.ts';

/** Where a pointer was caught. */
export interface Snapped {
  readonly at: Vec2;
  /** False where nothing was near. */
  readonly isCaught: boolean;
}

/** Edges of the outlines: what was scanned, so what is measured. */
export function outlineEdges({ primary }: Storey): Stretch[] {
  return ringsOf(primary).flatMap(edgesOf);
}

/** All edges a person may mean: outlines, structures and walls. */
export function planEdges(storey: Storey): Stretch[] {
  const polygons = [...storey.secondary, ...storey.walls].map(({ outline }) => outline);
  return [...outlineEdges(storey), ...ringsOf(polygons).flatMap(edgesOf)];
}

/** The nearest corner within `reach` metres, else the nearest place of an edge, else the place itself. O(edges). */
export function snap(edges: readonly Stretch[], place: Vec2, reach: number): Snapped {
  const corners = edges.map(({ from }) => from);
  const feet = edges.map((edge) => footOn(edge, place));
  const at = nearest(corners, place, reach) ?? nearest(feet, place, reach);
  return at ? { at, isCaught: true } : { at: place, isCaught: false };
}

function edgesOf(ring: Ring): Stretch[] {
  return Array.from({ length: ring.length / 2 }, (_, i) => {
    const next = (2 * i + 2) % ring.length;
    return { from: [ring[2 * i], ring[2 * i + 1]], to: [ring[next], ring[next + 1]] };
  });
}

function footOn({ from: [ax, ay], to: [bx, by] }: Stretch, [x, y]: Vec2): Vec2 {
  const [dx, dy] = [bx - ax, by - ay];
  const squared = dx * dx + dy * dy;
  const along = squared === 0 ? 0 : ((x - ax) * dx + (y - ay) * dy) / squared;
  const share = Math.min(1, Math.max(0, along));
  return [ax + share * dx, ay + share * dy];
}

function nearest(places: readonly Vec2[], [x, y]: Vec2, reach: number): Vec2 | null {
  let best: Vec2 | null = null;
  let least = reach;
  for (const place of places) {
    const distance = Math.hypot(place[0] - x, place[1] - y);
    if (distance > least) continue;
    least = distance;
    best = place;
  }
  return best;
}
