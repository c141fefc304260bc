import fc from 'fast-check';
import { describe, expect, it, test } from 'vitest';
import { FloorPlanError } from '../../../src/core/errors.ts';
import { nameRooms } from '../../../src/core/name-rooms.ts';
import { parseParam, resolveOptions } from '../../../src/core/options.ts';
import { formatRoomNames, parseRoomNames } from '../../../src/core/room-names.ts';
import type { FloorPlan, Warning } from '../../../src/core/types.ts';
import { type PlanFacts, planOf, rectangle } from '../solid/plans.ts';

describe('the list of names', () => {
  it.each([
    ['none', []],
    ['3.2,1.5=Kitchen', [{ x: 3.2, y: 1.5, storey: 0, name: 'Kitchen' }]],
    [
      '691823.12,5336027.5=Bath;; laundry;-3,4,2=a = b',
      [
        { x: 691823.12, y: 5336027.5, storey: 0, name: 'Bath; laundry' },
        { x: -3, y: 4, storey: 2, name: 'a = b' },
      ],
    ],
    ['0,0=a;;;1,0=;;b', [0, 1].map((x) => ({ x, y: 0, storey: 0, name: ['a;', ';b'][x] }))],
    ['1,2=מטבח 👩‍👩‍👧 <b>&', [{ x: 1, y: 2, storey: 0, name: 'מטבח 👩‍👩‍👧 <b>&' }]],
  ])('%s is read and written', (text, names) => {
    expect(parseRoomNames(text)).toEqual(names);
    expect(formatRoomNames(names)).toBe(text);
  });

  it('takes blanks, and leaves none around a name nor line ends in it', () => {
    expect(formatRoomNames(parseRoomNames(' 1, 2 , 0 = Living\r\nroom\t; 3,4=B '))).toBe(
      '1,2=Living room;3,4=B',
    );
  });

  it('gives any name back', () => {
    const name = fc.string({ unit: 'grapheme', minLength: 1, maxLength: 30 });
    const place = { x: fc.double({ noNaN: true, noDefaultInfinity: true }), y: fc.integer() };
    const entry = fc.record({ ...place, storey: fc.nat(9), name });
    fc.assert(
      fc.property(fc.array(entry, { minLength: 1, maxLength: 4 }), (entries) => {
        const names = entries.map(({ name: text, x, ...rest }) => ({
          ...rest,
          x: x + 0,
          name: text.replace(/[\t-\r\u0085\u2028\u2029]+/g, ' ').trim() || 'x',
        }));
        expect(parseRoomNames(formatRoomNames(names))).toEqual(names);
      }),
    );
  });

  it.each([
    ['', 1, '""'],
    ['Kitchen', 1, '"Kitchen"'],
    ['1,2=', 1, '"1,2="'],
    ['1,2= ', 1, '"1,2="'],
    ['1,2=A;', 2, '""'],
    ['1,2=A;B', 2, '"B"'],
    ['1=A', 1, '"1=A"'],
    ['1,,0=A', 1, '"1,,0=A"'],
    ['1,2,0.5=A', 1, '"1,2,0.5=A"'],
    ['1,2,-1=A', 1, '"1,2,-1=A"'],
    ['1,2,0,0=A', 1, '"1,2,0,0=A"'],
    ['1e999,2=A', 1, '"1e999,2=A"'],
    ['none;1,2=A', 1, '"none"'],
    [`1,2=${'A'.repeat(201)}`, 1, '201'],
  ])('refuses "%s", naming entry %i and what was found', (text, entry, told) => {
    let found: unknown;
    try {
      parseParam('roomNames', text);
    } catch (error) {
      found = error;
    }
    expect(found).toBeInstanceOf(FloorPlanError);
    expect(found).toMatchObject({ code: 'option/invalid', detail: { option: 'roomNames', entry } });
    expect((found as FloorPlanError).message).toContain(`entry ${entry} `);
    expect((found as FloorPlanError).message).toMatch(new RegExp(`found ${told.replace('.', '\\.')}$`));
    expect(() => resolveOptions({ roomNames: text })).toThrow(FloorPlanError);
  });

  it('takes the longest name, and refuses what is no text', () => {
    expect(parseRoomNames(`1,2=${'A'.repeat(200)}`)[0].name).toHaveLength(200);
    expect(() => resolveOptions({ roomNames: 3 } as never)).toThrow(FloorPlanError);
  });
});

/** Two rooms of 4 m × 3 m side by side, a wall of 0.2 m between them; what they name is theirs. */
function storeyOf(names: readonly [string, string] = ['Room 1', 'Room 2']) {
  const outline = (x: number) => ({ outer: rectangle(x, 0, 4, 3), holes: [] });
  return {
    primary: [{ outer: rectangle(0, 0, 8.2, 3), holes: [] }],
    rooms: names.map((name, i) => ({ name, outline: outline(4.2 * i), height: 2.5, confidence: 1 })),
    gaps: [
      { from: [4, 1], to: [4, 2], width: 1, room: names[0] },
      { from: [4.2, 1], to: [4.2, 2], width: 1, room: names[1] },
      { from: [0, 1], to: [0, 2], width: 1 },
    ],
    furniture: names.map((room, i) => ({
      ...{ outline: { outer: rectangle(4.2 * i + 1, 1, 1, 1), holes: [] }, height: 0.7 },
      ...{ confidence: 1, room },
    })),
  } as const;
}

function name(roomNames: string, facts: PlanFacts = { storeys: [storeyOf()] }) {
  const plan: FloorPlan = planOf({ ...facts, options: { roomNames } });
  const warnings: Warning[] = [];
  const storeys = nameRooms(plan, (warning) => warnings.push(warning));
  const called = storeys.map(({ rooms }) => rooms.map((room) => room.name));
  return { plan, storeys, called, warnings, messages: warnings.map(({ message }) => message) };
}

test('a room is called as the place in it says, and what is of it says so too', () => {
  const { storeys, called, warnings } = name('6,1=Kitchen');
  expect(called).toEqual([['Room 1', 'Kitchen']]);
  expect(storeys[0].gaps.map(({ room }) => room)).toEqual(['Room 1', 'Kitchen', undefined]);
  expect(storeys[0].furniture!.map(({ room }) => room)).toEqual(['Room 1', 'Kitchen']);
  expect(warnings).toEqual([]);
});

test('without names nothing is made anew', () => {
  const { plan, storeys } = name('none');
  expect(storeys).toBe(plan.storeys);
});

test('the last name for a room counts, and rooms may be called alike or change names', () => {
  expect(name('1,1=A;2,2=B').called).toEqual([['B', 'Room 2']]);
  expect(name('1,1=Office;6,1=Office').called).toEqual([['Office', 'Office']]);
  const { storeys, called } = name('1,1=Room 2;6,1=Room 1');
  expect(called).toEqual([['Room 2', 'Room 1']]);
  expect(storeys[0].gaps.map(({ room }) => room)).toEqual(['Room 2', 'Room 1', undefined]);
});

test('of rooms called alike each keeps what is its own', () => {
  const facts = { storeys: [storeyOf(['Office', 'Office'])] };
  const { storeys } = name('6,1=Archive', facts);
  expect(storeys[0].gaps.map(({ room }) => room)).toEqual(['Office', 'Archive', undefined]);
  expect(storeys[0].furniture!.map(({ room }) => room)).toEqual(['Office', 'Archive']);
});

test('storeys are told by their number, the lowest where none is given', () => {
  const storeys = [storeyOf(), storeyOf()];
  expect(name('1,1=Shop;1,1,1=Flat', { storeys }).called).toEqual([
    ['Shop', 'Room 2'],
    ['Flat', 'Room 2'],
  ]);
});

test("places are in the source's unit and coordinates", () => {
  const frame = { planOrigin: [691_000_000, 5_336_000_000, 0], metresPerUnit: 0.001 } as const;
  const facts = { storeys: [storeyOf()], frame };
  expect(name('691006000,5336001000=Kitchen', facts).called).toEqual([['Room 1', 'Kitchen']]);
});

test('a place in no room, and one in a storey that is not there, are told of with their names', () => {
  const { called, warnings, messages } = name('4.1,1=Wall;1,1,3=Attic;1,1=Hall');
  expect(called).toEqual([['Hall', 'Room 2']]);
  expect(warnings.map(({ code }) => code)).toEqual(Array(2).fill('plan/no-such-room'));
  expect(messages).toEqual([
    'No room is called "Wall": the place 4.1, 1 lies in no room.',
    'No room is called "Attic": the place 1, 1 is in storey 3, which the plan lacks.',
  ]);
  expect(warnings[0].hint).toContain('source coordinates');
});

test('a plan of outlines has no rooms to name', () => {
  const { warnings, messages, plan, storeys } = name('1,1=Hall;2,2=Bath', { storeys: [{}] });
  expect(storeys).toBe(plan.storeys);
  expect(warnings.map(({ code }) => code)).toEqual(['plan/no-such-room']);
  expect(messages[0]).toContain('The 2 names given are of no use');
});
