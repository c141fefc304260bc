import { edgesBetween } from '../../geometry/ring-arcs.ts';
import type { Polygon, Ring, RingArc } from '../../types.ts';

/** A straight stretch of an outline with the room on its left. */
export interface RoomEdge {
  /** Outline it belongs to. */
  readonly owner: number;
  readonly ax: number;
  readonly ay: number;
  readonly bx: number;
  readonly by: number;
  readonly length: number;
  /** Unit vector along it. */
  readonly ux: number;
  readonly uy: number;
  /** The curve it is a chord of. */
  readonly arc?: RingArc;
}

/** The edges of outlines. Away from the room is (uy, −ux). */
export function edgesOf(outlines: readonly Polygon[]): RoomEdge[] {
  return outlines.flatMap(({ outer, holes, arcs = [] }, owner) =>
    [outer, ...holes].flatMap((ring, k) =>
      edgesOfRing(
        ring,
        owner,
        arcs.filter((arc) => arc.ring === k),
      ),
    ),
  );
}

function edgesOfRing(ring: Ring, owner: number, arcs: readonly RingArc[]): RoomEdge[] {
  const edges: RoomEdge[] = [];
  const n = ring.length / 2;
  for (let i = 0; i < n; i++) {
    const j = (i + 1) % n;
    const [ax, ay, bx, by] = [ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]];
    const length = Math.hypot(bx - ax, by - ay);
    if (length === 0) continue;
    const arc = arcs.find(({ from, to }) => (i - from + n) % n < edgesBetween(from, to, n));
    const edge = { owner, ax, ay, bx, by, length, ux: (bx - ax) / length, uy: (by - ay) / length };
    edges.push(arc ? { ...edge, arc } : edge);
  }
  return edges;
}
