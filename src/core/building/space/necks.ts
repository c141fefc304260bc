import { areaOf, combine, grow } from '../../geometry/areas.ts';
import { polygonArea } from '../../geometry/rings.ts';
import type { Polygon } from '../../types.ts';
import { TAKEN_SHARE } from '../faces/face-support.ts';
import { type Arrangement, faceArea } from './arrangement.ts';
import type { FoundRooms } from './found-rooms.ts';
import { isRoomSized, PARTING } from './trace-rooms.ts';

/** Nobody passes through what is narrower than this, m. */
const NARROWEST_PASSAGE = 0.3;

/**
 * Parts rooms that only a slit joins, too narrow to pass through: a wall ends short of the next where its last
 * centimetres were not seen. The slit becomes wall. O(rooms · faces of each).
 *
 * @returns what is room and what is wall then; null where there is no such slit
 */
export function withoutNecks({
  arrangement,
  space,
  support,
  rooms,
}: FoundRooms): Pick<FoundRooms, 'space' | 'support'> | null {
  const isRoom = space.isRoom.slice();
  const parted = support.slice();
  let isParted = false;
  for (const { outline, faces } of rooms) {
    const parts = partsOf(outline);
    if (parts.length < 2) continue;
    isParted = true;
    const partOf = shareOut(arrangement, support, faces, parts);
    for (const f of faces) if (!partOf.has(f)) isRoom[f] = 0;
    for (let e = 0; e < parted.length; e++) {
      const [a, b] = [0, 1].map((h) => partOf.get(arrangement.face[2 * e + h]));
      if (a !== undefined && b !== undefined && a !== b) parted[e] = Math.max(parted[e], TAKEN_SHARE);
    }
  }
  return isParted ? { space: { ...space, isRoom }, support: parted } : null;
}

/** The parts of a room that slits join, each large enough for one. */
function partsOf(outline: Polygon): Polygon[] {
  const wide = grow([outline], -NARROWEST_PASSAGE / 2);
  return wide.flatMap((part) => grow([part], NARROWEST_PASSAGE / 2)).filter(isRoomSized);
}

/** The part that each face of a room is in; faces that join two are in none. */
function shareOut(
  arrangement: Arrangement,
  support: Float64Array,
  faces: readonly number[],
  parts: readonly Polygon[],
): Map<number, number> {
  const partOf = new Map<number, number>();
  for (const f of faces) {
    const polygon = faceArea(arrangement, f);
    const shared = parts.map((part) => areaOf(combine('intersection', [polygon], [part])));
    const most = shared.indexOf(Math.max(...shared));
    if (shared[most] >= polygonArea(polygon) / 2) partOf.set(f, most);
  }
  const beside = openNeighbours(arrangement, support);
  const rest = faces.filter((f) => !partOf.has(f));
  for (let isGrowing = true; isGrowing; ) {
    isGrowing = false;
    for (const f of rest) {
      if (partOf.has(f)) continue;
      const around = new Set(beside[f].flatMap((g) => partOf.get(g) ?? []));
      if (around.size !== 1) continue;
      partOf.set(f, [...around][0]);
      isGrowing = true;
    }
  }
  return partOf;
}

/** The faces that no wall parts from each face. */
function openNeighbours({ face, faceEdge }: Arrangement, support: Float64Array): number[][] {
  const beside = Array.from(faceEdge, () => [] as number[]);
  for (let e = 0; e < support.length; e++) {
    const [f, g] = [face[2 * e], face[2 * e + 1]];
    if (f < 0 || g < 0 || support[e] >= PARTING) continue;
    beside[f].push(g);
    beside[g].push(f);
  }
  return beside;
}
