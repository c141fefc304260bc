import { describe, expect, it } from 'vitest';
import { footprint } from '../../../fixtures/simulator/building.ts';
import {
  contains,
  convexOverlap,
  distanceToRing,
  insetEach,
  rectangle,
  signedArea,
} from '../../../fixtures/simulator/ring.ts';
import { CORPUS } from '../../accuracy/corpus.ts';
import { expectValidRing } from '../../invariants.ts';
import { flat, ringsOf, roomsWithoutDoor, storeysOf, wallsAcross } from './storeys.ts';

const specs = CORPUS.map(({ spec }) => spec());
const storeys = storeysOf(specs.map(({ building }, i) => ({ ...building, name: specs[i].name })));

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
      for (const opening of storey.openings) {
        expect(wallsAcross(storey, opening), name).toEqual([]);
        expect(opening.head, name).toBeLessThanOrEqual(storey.height);
        expect(opening.head - opening.sill, name).toBeGreaterThan(0.9);
      }
    }
  });

  it('has a door or passage to every room', () => {
    for (const { name, storey } of storeys) expect(roomsWithoutDoor(storey), name).toEqual([]);
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
