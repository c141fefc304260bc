import {
  type Building,
  footprint,
  type Opening,
  type Room,
  type Storey,
} from '../../../fixtures/simulator/building.ts';
import { contains, type Ring } from '../../../fixtures/simulator/ring.ts';
import { type Quad, surfacesOf } from '../../../fixtures/simulator/surfaces.ts';

export interface NamedStorey {
  readonly name: string;
  readonly storey: Storey;
}

/** Every storey, by its building's name and its number. */
export function storeysOf(buildings: readonly Building[]): NamedStorey[] {
  return buildings.flatMap(({ name, storeys }) =>
    storeys.map((storey, i) => ({ name: `${name}/${i}`, storey })),
  );
}

export function ringsOf({ rooms, interiorOutline, outer, columns, furniture }: Storey): Ring[] {
  return [...rooms, ...furniture].map(({ ring }) => ring).concat([interiorOutline, outer], columns);
}

export const flat = (ring: Ring): Float64Array => Float64Array.from(ring.flat());

/** Faces of walls that stand in an opening of theirs. */
export function wallsAcross(storey: Storey, opening: Opening): Quad[] {
  const height = storey.floor + (opening.sill + opening.head) / 2;
  const hole = footprint(opening, 0.01);
  return surfacesOf(storey).quads.filter(
    ({ kind, low, high, a, b }) =>
      (kind === 'wall' || kind === 'facade') &&
      low < height &&
      high > height &&
      contains(hole, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2),
  );
}

export function roomsWithoutDoor({ rooms, openings }: Storey): Room[] {
  const doors = openings.filter(({ kind }) => kind !== 'window');
  const touches = (ring: Ring) =>
    doors.some((door) => footprint(door, 0.02).some(([x, y]) => contains(ring, x, y)));
  return rooms.filter(({ ring }) => !touches(ring));
}
