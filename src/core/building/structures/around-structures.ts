import { areaOf, combine } from '../../geometry/areas.ts';
import { reverseRing } from '../../geometry/rings.ts';
import type { Polygon, Ring, SecondaryBoundary } from '../../types.ts';

/** A hole is a structure's when they share so much of what they cover together. */
const SAME = 0.5;

/** The outline of a room without the holes that are structures: these stand in it, and are no walls of it. */
export function aroundStructures(room: Polygon, structures: readonly SecondaryBoundary[]): Polygon {
  const holes = room.holes.filter((hole) => !structures.some(({ outline }) => isSame(hole, outline)));
  return holes.length === room.holes.length ? room : { outer: room.outer, holes };
}

function isSame(hole: Ring, structure: Polygon): boolean {
  const space: Polygon = { outer: reverseRing(hole), holes: [] };
  const shared = areaOf(combine('intersection', [space], [structure]));
  return shared > SAME * areaOf(combine('union', [space, structure]));
}
