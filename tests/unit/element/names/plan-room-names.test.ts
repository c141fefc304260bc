import { describe, expect, it } from 'vitest';
import { nameRooms } from '../../../../src/core/name-rooms.ts';
import type { FloorPlan } from '../../../../src/core/types.ts';
import { type NamedStorey, PlanRoomNames } from '../../../../src/element/names/plan-room-names.ts';
import { planOf, ring } from '../../solid/plans.ts';

/** An L of 6 m × 5 m less 4 m × 3 m, whose middle lies outside of it, and a room beside it. */
const outlines = [ring(0, 0, 6, 0, 6, 2, 2, 2, 2, 5, 0, 5), ring(7, 0, 9, 0, 9, 3, 7, 3)];

function planHere(): FloorPlan {
  const rooms = outlines.map((outer, i) => ({
    ...{ name: ['Hall', 'Room 2'][i], outline: { outer, holes: [] } },
    ...{ height: 2.5, confidence: 1 },
  }));
  const plan = planOf({ storeys: [{ rooms }, { rooms }] });
  const planOrigin = [691_000_000, 5_336_000_000, 0] as const;
  return { ...plan, frame: { ...plan.frame, planOrigin, metresPerUnit: 0.001, unit: 'mm' } };
}

const namesOf = (facts: Partial<NamedStorey> = {}) =>
  new PlanRoomNames({ plan: planHere(), storey: 0, text: 'none', isSaved: false, ...facts });

/** What the core makes of the parameter. */
function called(roomNames: string, storey = 0): string[] {
  const plan = planHere();
  const options = { ...plan.options, roomNames };
  const storeys = nameRooms({ ...plan, options }, ({ message }) => {
    throw new Error(message);
  });
  return storeys[storey].rooms.map(({ name }) => name);
}

describe('names of rooms in the drawing', () => {
  it('finds the room at a place', () => {
    const names = namesOf();
    expect([names.at([1, 4]), names.at([8, 1]), names.at([4, 4])]).toEqual([0, 1, -1]);
  });

  it('names every room, whatever its shape, at a place in it that is short to read', () => {
    const names = namesOf();
    const text = names.with(0, 'Kitchen; bar');
    expect(text).toMatch(/^69100\d{4},533600\d{4}=Kitchen;; bar$/);
    expect(called(text)).toEqual(['Kitchen; bar', 'Room 2']);
    const both = namesOf({ text }).with(1, 'مطبخ');
    expect(called(both)).toEqual(['Kitchen; bar', 'مطبخ']);
    expect(namesOf({ text: both }).nameOf(1)).toBe('مطبخ');
  });

  it('names rooms of the storey shown', () => {
    const text = namesOf({ storey: 1 }).with(1, 'Attic');
    expect(called(text, 1)).toEqual(['Hall', 'Attic']);
    expect(called(text, 0)).toEqual(['Hall', 'Room 2']);
    expect(namesOf({ text }).nameOf(1)).toBe('Room 2');
  });

  it('keeps the place of a name that was given, and one entry a room', () => {
    const text = '691001000,5336004000=A;691008000,5336001000=B;691000500,5336000500=C';
    const names = namesOf({ text });
    expect(names.nameOf(0)).toBe('C');
    expect(names.with(0, 'D')).toBe('691008000,5336001000=B;691001000,5336004000=D');
  });

  it('forgets a name that is taken away', () => {
    const text = namesOf().with(1, 'Bath');
    const names = namesOf({ text });
    expect(names.with(1, '')).toBe('none');
    expect(names.with(1, 'Room 2')).toBe('none');
    // The plan shown has it until the run is done.
    expect(namesOf({ text: 'none' }).nameOf(0)).toBe('Room 1');
  });

  it('of a saved plan keeps what it came with, and numbers a room whose name is taken away', () => {
    const names = namesOf({ isSaved: true });
    expect(names.nameOf(0)).toBe('Hall');
    expect(called(names.with(0, ''))).toEqual(['Room 1', 'Room 2']);
    expect(called(names.with(0, 'Room 1'))).toEqual(['Room 1', 'Room 2']);
  });
});
