import { areaOf, combine } from '../../geometry/areas.ts';
import { reverseRing } from '../../geometry/rings.ts';
import type { Polygon, Ring, SecondaryBoundary } from '../../types.ts';

/** A hole is a structure's when so much of it lies in the structure: its whole foot, or the stub of a face that was seen of it. */
const WITHIN = 0.5;

/** The outline of a room without the holes that are structures: these stand in it, and are no walls of it. */
export function aroundStructures(room: Polygon, structures: readonly SecondaryBoundary[]): Polygon {
  const holes = room.holes.filter((hole) => !structures.some(({ outline }) => liesIn(hole, outline)));
  return holes.length === room.holes.length ? room : { outer: room.outer, holes };
}

function liesIn(hole: Ring, structure: Polygon): boolean {
  const space: Polygon = { outer: reverseRing(hole), holes: [] };
  return areaOf(combine('intersection', [space], [structure])) > WITHIN * areaOf([space]);
}
