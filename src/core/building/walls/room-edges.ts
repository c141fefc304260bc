import type { Polygon, Ring } from '../../types.ts';

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
}

/** The edges of outlines. Away from the room is (uy, −ux). */
export function edgesOf(outlines: readonly Polygon[]): RoomEdge[] {
  return outlines.flatMap(({ outer, holes }, owner) =>
    [outer, ...holes].flatMap((ring) => edgesOfRing(ring, owner)),
  );
}

function edgesOfRing(ring: Ring, owner: number): RoomEdge[] {
  const edges: RoomEdge[] = [];
  for (let i = 0; i < ring.length; i += 2) {
    const j = (i + 2) % ring.length;
    const [ax, ay, bx, by] = [ring[i], ring[i + 1], ring[j], ring[j + 1]];
    const length = Math.hypot(bx - ax, by - ay);
    if (length > 0)
      edges.push({ owner, ax, ay, bx, by, length, ux: (bx - ax) / length, uy: (by - ay) / length });
  }
  return edges;
}
