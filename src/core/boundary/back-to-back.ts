import { squaredDistanceToSegment } from '../geometry/segments.ts';
import type { HullRing } from './hull-ring.ts';

/** Edges whose directions turn by more than this are opposed: cosine of 120°. */
const OPPOSED = -0.5;

/**
 * Whether the ring runs along both sides of what the edge a → next[a] follows: an opposed edge lies behind it, on its
 * inner side, within `thickness` of its middle. One of the two then leads through a room, not around it.
 */
export function isBackToBack({ grid, next, edges }: HullRing, a: number, thickness: number): boolean {
  const { x, y } = grid;
  const b = next[a];
  const ux = x[b] - x[a];
  const uy = y[b] - y[a];
  const length = Math.sqrt(ux * ux + uy * uy);
  const mx = (x[a] + x[b]) / 2;
  const my = (y[a] + y[b]) / 2;
  const count = edges.around(mx, my, thickness);
  for (let k = 0; k < count; k++) {
    const c = edges.u[edges.found[k]];
    const d = edges.v[edges.found[k]];
    if (next[c] !== d) continue;
    const vx = x[d] - x[c];
    const vy = y[d] - y[c];
    if (ux * vx + uy * vy > OPPOSED * length * Math.sqrt(vx * vx + vy * vy)) continue;
    // Each has the other on its left.
    const isBehind = ux * (y[c] - my) - uy * (x[c] - mx) > 0 || ux * (y[d] - my) - uy * (x[d] - mx) > 0;
    if (!isBehind || vx * (my - y[c]) - vy * (mx - x[c]) < 0) continue;
    if (squaredDistanceToSegment(mx, my, x[c], y[c], x[d], y[d]) <= thickness * thickness) return true;
  }
  return false;
}
