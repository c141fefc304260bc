import { describe, expect, it } from 'vitest';
import { type Building, footprint } from '../../../fixtures/simulator/building.ts';
import {
  columnRoomBuilding,
  corridorBuilding,
  homeBuilding,
  officeBuilding,
  roundHallBuilding,
} from '../../../fixtures/simulator/layouts.ts';
import { contains, convexOverlap, signedArea } from '../../../fixtures/simulator/ring.ts';
import { sampleHome, sampleOffice } from '../../../fixtures/simulator/sample-buildings.ts';
import { surfacesOf } from '../../../fixtures/simulator/surfaces.ts';
import { expectValidRing } from '../../invariants.ts';
import { flat, ringsOf, roomsWithoutDoor, storeysOf, wallsAcross } from './storeys.ts';

const seeds = Array.from({ length: 12 }, (_, i) => i + 1);
const buildings: Building[] = [
  ...seeds.flatMap((seed) =>
    (['rect', 'L', 'T', 'U'] as const).map((shape) =>
      homeBuilding(seed, { shape, skew: seed % 2 === 0 ? 0.05 : 0, storeys: seed % 5 === 0 ? 2 : 1 }),
    ),
  ),
  ...seeds.map((seed) => officeBuilding(seed)),
  ...seeds.map(roundHallBuilding),
  ...seeds.map((seed) => columnRoomBuilding(seed, seed % 2 === 0 ? 'round' : 'square')),
  ...seeds.map(corridorBuilding),
  sampleHome(),
  sampleOffice(),
];
const storeys = storeysOf(buildings);

describe('layouts', () => {
  it('are made of simple, counter-clockwise rings', () => {
    for (const { name, storey } of storeys) {
      for (const ring of ringsOf(storey)) {
        expectValidRing(flat(ring), name);
        expect(signedArea(ring), name).toBeGreaterThan(0);
      }
    }
  });

  it('have rooms that fill the interior outline, walls aside', () => {
    for (const { name, storey } of storeys) {
      const floor = storey.rooms.reduce((sum, { ring }) => sum + signedArea(ring), 0);
      const outline = signedArea(storey.interiorOutline);
      expect(floor, name).toBeLessThanOrEqual(outline + 1e-6);
      expect(floor, name).toBeGreaterThan(0.85 * outline);
      const outside = storey.rooms.flatMap(({ ring }) =>
        ring.filter(([x, y]) => !contains(storey.outer, x, y)),
      );
      expect(outside, name).toEqual([]);
    }
  });

  it('have openings that cut both faces of their wall', () => {
    for (const { name, storey } of storeys) {
      const jambs = surfacesOf(storey).quads.filter(({ kind }) => kind === 'opening');
      for (const opening of storey.openings) {
        expect(wallsAcross(storey, opening), name).toEqual([]);
        expect(jambs.length, name).toBe(2 * storey.openings.length);
      }
    }
  });

  it('have a door or passage to every room', () => {
    for (const { name, storey } of storeys) {
      if (storey.rooms.length > 1) expect(roomsWithoutDoor(storey), name).toEqual([]);
    }
  });

  it('have furniture in rooms, clear of doors', () => {
    for (const { name, storey } of storeys) {
      const doors = storey.openings.filter(({ kind }) => kind === 'door').map((door) => footprint(door));
      for (const { ring } of storey.furniture) {
        const room = storey.rooms.find((candidate) => contains(candidate.ring, ...ring[0]));
        expect(room, name).toBeDefined();
        expect(
          ring.every(([x, y]) => contains(room!.ring, x, y)),
          name,
        ).toBe(true);
        expect(
          doors.filter((door) => convexOverlap(door, ring)),
          name,
        ).toEqual([]);
      }
    }
  });

  it('are the same for the same seed and others for another', () => {
    expect(homeBuilding(3)).toEqual(homeBuilding(3));
    expect(homeBuilding(3).storeys[0].rooms).not.toEqual(homeBuilding(4).storeys[0].rooms);
  });
});
