import { describe, expect, it } from 'vitest';
import { footprint, type Storey } from '../../../fixtures/simulator/building.ts';
import {
  contains,
  convexOverlap,
  distanceToRing,
  insetEach,
  type Ring,
  rectangle,
  signedArea,
} from '../../../fixtures/simulator/ring.ts';
import { surfacesOf } from '../../../fixtures/simulator/surfaces.ts';
import { CORPUS } from '../../accuracy/corpus.ts';
import { expectValidRing } from '../../invariants.ts';

const specs = CORPUS.map(({ spec }) => spec());
const storeys = specs.flatMap(({ name, building }) =>
  building.storeys.map((storey, i) => ({ name: `${name}/${i}`, storey })),
);
const flat = (ring: Ring): Float64Array => Float64Array.from(ring.flat());

function ringsOf({ rooms, interiorOutline, outer, columns, furniture }: Storey): Ring[] {
  return [...rooms, ...furniture].map(({ ring }) => ring).concat([interiorOutline, outer], columns);
}

describe('the corpus', () => {
  it('has sixty buildings and more, half of them kept back', () => {
    expect(CORPUS.length).toBeGreaterThanOrEqual(60);
    expect(CORPUS.filter(({ isHeldBack }) => isHeldBack).length).toBe(CORPUS.length / 2);
    expect(new Set(CORPUS.map(({ name }) => name)).size).toBe(CORPUS.length);
  });

  it('is made of simple, counter-clockwise rings', () => {
    for (const { name, storey } of storeys) {
      for (const ring of ringsOf(storey)) {
        expectValidRing(flat(ring), name);
        expect(signedArea(ring), name).toBeGreaterThan(0);
      }
    }
  });

  it('has rooms a wall apart, inside the outline', () => {
    for (const { name, storey } of storeys) {
      storey.rooms.forEach(({ ring }, i) => {
        for (const [x, y] of ring) {
          const isIn = contains(storey.interiorOutline, x, y);
          expect(isIn || distanceToRing(storey.interiorOutline, x, y) < 1e-6, name).toBe(true);
          expect(contains(storey.outer, x, y), name).toBe(true);
          expect(distanceToRing(storey.outer, x, y), name).toBeGreaterThan(0.07);
          const near = storey.rooms.filter((other, k) => k !== i && distanceToRing(other.ring, x, y) < 0.069);
          expect(near, name).toEqual([]);
        }
      });
    }
  });

  it('has openings that cut both faces of their wall', () => {
    for (const { name, storey } of storeys) {
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
        expect(opening.head, name).toBeLessThanOrEqual(storey.height);
        expect(opening.head - opening.sill, name).toBeGreaterThan(0.9);
      }
    }
  });

  it('has a door or passage to every room', () => {
    for (const { name, storey } of storeys) {
      const doors = storey.openings.filter(({ kind }) => kind !== 'window');
      for (const { ring } of storey.rooms) {
        const touches = doors.some((door) => footprint(door, 0.02).some(([x, y]) => contains(ring, x, y)));
        expect(touches, name).toBe(true);
      }
    }
  });

  it('has columns and furniture in rooms, clear of doors', () => {
    for (const { name, storey } of storeys) {
      const doors = storey.openings.filter(({ kind }) => kind !== 'window').map((door) => footprint(door));
      const inRooms = storey.furniture.filter(({ ring }) => !doors.some((door) => convexOverlap(door, ring)));
      // A room scanned alone has a shut leaf in its door.
      expect(storey.furniture.length - inRooms.length, name).toBe(storey.rooms.length === 1 ? 1 : 0);
      for (const ring of [...storey.columns, ...inRooms.map((prism) => prism.ring)]) {
        const room = storey.rooms.find((candidate) => contains(candidate.ring, ...ring[0]));
        expect(
          ring.every(([x, y]) => room !== undefined && contains(room.ring, x, y)),
          name,
        ).toBe(true);
      }
    }
  });

  it('has walls of several thicknesses in most buildings', () => {
    const several = storeys.filter(
      ({ storey }) => new Set(storey.openings.map(({ thickness }) => thickness.toFixed(3))).size > 2,
    );
    expect(several.length).toBeGreaterThan(storeys.length / 2);
  });
});

describe('insetEach', () => {
  it('moves every edge by its own distance', () => {
    const found = insetEach(rectangle(0, 0, 10, 8), ([x0, y0], [x1]) => (y0 === 0 && x1 > x0 ? 1 : 0.5));
    expect(found).toEqual([
      [0.5, 1],
      [9.5, 1],
      [9.5, 7.5],
      [0.5, 7.5],
    ]);
  });
});
