import { expect } from 'vitest';
import { type Building, footprint, type Storey } from '../../../fixtures/simulator/building.ts';
import { contains, signedArea } from '../../../fixtures/simulator/ring.ts';
import { surfacesOf } from '../../../fixtures/simulator/surfaces.ts';
import { expectValidRing } from '../../invariants.ts';

/** A storey, and what it is called where a test fails. */
export interface NamedStorey {
  readonly name: string;
  readonly storey: Storey;
}

export function storeysOf(buildings: readonly Building[]): NamedStorey[] {
  return buildings.flatMap(({ name, storeys }) =>
    storeys.map((storey, i) => ({ name: `${name}/${i}`, storey })),
  );
}

/** Fails unless every ring of a storey is simple and counter-clockwise. */
export function expectSimpleRings({ name, storey }: NamedStorey): void {
  const { rooms, interiorOutline, outer, columns, furniture } = storey;
  const rings = [...rooms, ...furniture].map(({ ring }) => ring).concat([interiorOutline, outer], columns);
  for (const ring of rings) {
    expectValidRing(Float64Array.from(ring.flat()), name);
    expect(signedArea(ring), name).toBeGreaterThan(0);
  }
}

/** Fails if a wall stands in an opening of a storey, half way up. */
export function expectOpenWalls({ name, storey }: NamedStorey): void {
  const { quads } = surfacesOf(storey);
  for (const opening of storey.openings) {
    const height = storey.floor + (opening.sill + opening.head) / 2;
    const hole = footprint(opening, 0.01);
    const inTheWay = quads.filter(
      ({ kind, low, high, a, b }) =>
        (kind === 'wall' || kind === 'facade') &&
        low < height &&
        high > height &&
        contains(hole, (a[0] + b[0]) / 2, (a[1] + b[1]) / 2),
    );
    expect(inTheWay, name).toEqual([]);
  }
}

/** Fails unless a door or passage leads to each of some rooms. */
export function expectDoors(rooms: Storey['rooms'], { name, storey }: NamedStorey): void {
  const doors = storey.openings.filter(({ kind }) => kind !== 'window');
  for (const { ring } of rooms) {
    const touches = doors.some((door) => footprint(door, 0.02).some(([x, y]) => contains(ring, x, y)));
    expect(touches, name).toBe(true);
  }
}
