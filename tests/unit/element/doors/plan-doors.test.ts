import { describe, expect, it, test } from 'vitest';
import { placeDoors } from '../../../../src/core/place-doors.ts';
import type { FloorPlan, Gap, Opening } from '../../../../src/core/types.ts';
import { isLowest, PlanDoors } from '../../../../src/element/doors/plan-doors.ts';
import { planOf, ring, wallAround } from '../../solid/plans.ts';

const room = ring(0, 0, 6, 0, 6, 4, 0, 4);
const gaps: readonly Gap[] = [
  { from: [2, 0], to: [3.2, 0], width: 1.2 },
  { from: [6, 1], to: [6, 1.8], width: 0.8 },
];
const walls = [{ outline: wallAround(room, 0.2), thickness: 0.2, confidence: 1 }];

/** A room of 6 × 4 m with two gaps, in a source far from its own origin, in millimetres. */
function planHere(): FloorPlan {
  const plan = planOf({ storeys: [{ primary: [{ outer: room, holes: [] }], walls, gaps }] });
  const frame = { ...plan.frame, planOrigin: [691_000_000, 5_336_000_000, 0] as const };
  return { ...plan, frame: { ...frame, metresPerUnit: 0.001, unit: 'mm' } };
}

function doorsOf(text: string) {
  return new PlanDoors(planHere(), text);
}

/** What the core makes of the parameter. */
function openingsOf(doors: string): Opening[] {
  const { frame, options } = planHere();
  const outlines = [{ polygon: { outer: room, holes: [] }, confidence: 1 }];
  return placeDoors(
    { outlines, gaps, frame, height: 2.5, options: { ...options, doors } },
    {
      warn: ({ message }) => {
        throw new Error(message);
      },
    },
  );
}

const rounded = ({ from, to }: Pick<Opening, 'from' | 'to'>) =>
  [...from, ...to].map((value) => Math.round(value * 1e3) / 1e3 + 0);

describe('a door where a person points', () => {
  it.each([
    ['on the wall', [1, -0.1], [0.55, -0.1, 1.45, -0.1]],
    ['in the room near it', [1, 0.3], [0.55, -0.1, 1.45, -0.1]],
    ['at the start of a wall, moved along', [0.2, 0], [0, -0.1, 0.9, -0.1]],
    ['at the end of a wall, moved along', [5.9, -0.1], [5.1, -0.1, 6, -0.1]],
  ] as const)('%s', (_, place, expected) => {
    const doors = doorsOf('none');
    const opening = doors.fit(place, { width: 0.9 })!;
    expect(rounded(opening)).toEqual(expected);
    const text = doors.with(opening);
    expect(openingsOf(text).map(rounded)).toEqual([expected]);
  });

  it('is as wide as the wall where that is shorter, and no warning comes of it', () => {
    const opening = doorsOf('none').fit([6.1, 2], { width: 5 })!;
    expect(rounded(opening)).toEqual([6.1, 0, 6.1, 4]);
    expect(openingsOf(doorsOf('none').with(opening)).map(rounded)).toEqual([rounded(opening)]);
  });

  it('is none off every wall', () => {
    expect(doorsOf('none').fit([3, 2], { width: 0.9 })).toBeNull();
  });

  it('has the height given', () => {
    const opening = doorsOf('none').fit([1, 0], { width: 0.9, height: 2.2 })!;
    expect(opening.head).toBe(2.2);
    expect(doorsOf('gaps').with(opening, 2.2)).toBe('gaps;691001000,5335999900,0.9,2.2');
  });
});

test('a door is found where it stands, and nowhere else', () => {
  const doors = doorsOf('691001000,5335999900,0.9');
  const [door] = doors.doors;
  expect(doors.at([1.3, -0.05], 0)).toBe(door);
  expect(doors.at([1.5, -0.1], 0)).toBeNull();
  expect(doors.at([1.5, -0.1], 0.1)).toBe(door);
  expect(doors.at([1, 1], 0.1)).toBeNull();
});

test('a gap becomes a door of its width, and is then no free gap', () => {
  const none = doorsOf('none');
  expect(none.gapAt([2.5, 0], 0)).toBe(gaps[0]);
  const text = none.with(gaps[0]);
  expect(text).toBe('691002600,5336000000,1.2');
  expect(openingsOf(text).map(rounded)).toEqual([[2, -0.1, 3.2, -0.1]]);
  expect(rounded(none.fitGap(gaps[0])!)).toEqual([2, -0.1, 3.2, -0.1]);
  const after = doorsOf(text);
  expect(after.gapAt([2.5, 0], 0)).toBeNull();
  expect(after.inGap(gaps[0])).toBe(after.doors[0]);
  expect(after.inGap(gaps[1])).toBeNull();
});

test('a gap too narrow for a door makes none', () => {
  expect(doorsOf('none').fitGap({ from: [2, 0], to: [2.05, 0], width: 0.05 })).toBeNull();
});

test('a door is taken away, and the others stay where they were', () => {
  const three = doorsOf('691001000,5335999900,0.9;691001000,5336004100,1;691006100,5336003000,1');
  expect(three.without(three.doors[1])).toBe('691001000,5335999900,0.9;691006100,5336003000,1');
  const one = doorsOf('691001000,5335999900,0.9');
  expect(one.without(one.doors[0])).toBe('none');
});

test('where every gap is a door, taking one away leaves the others as doors', () => {
  const all = doorsOf('gaps;691001000,5336004100,1');
  expect(all.doors).toHaveLength(3);
  const text = all.without(all.inGap(gaps[0])!);
  expect(openingsOf(text).map(rounded)).toEqual([
    [6.1, 1, 6.1, 1.8],
    [1.5, 4.1, 0.5, 4.1],
  ]);
});

test('a place is said in the source, without a negative zero', () => {
  expect(doorsOf('none').sayPlace(gaps[0])).toBe('691002600, 5336000000 mm');
  const plan = planOf({ storeys: [{ primary: [{ outer: room, holes: [] }], walls, gaps }] });
  const beside = { from: [2, -0.001], to: [3.2, -0.001] } as const;
  expect(new PlanDoors(plan, 'none').sayPlace(beside)).toBe('2.60, 0.00 m');
});

test('in a plan of rooms a door is cut where the plan gets it: in the wall between two', () => {
  const outlines = [ring(0, 0, 3, 0, 3, 4, 0, 4), ring(3.12, 0, 6, 0, 6, 4, 3.12, 4)];
  const rooms = outlines.map((outer, i) => ({
    name: `Room ${i + 1}`,
    outline: { outer, holes: [] },
    height: 2.5,
    confidence: 0.9,
  }));
  const { storeys, ...plan } = planHere();
  const house = { ...plan, storeys: [{ ...storeys[0], rooms }] };
  const doors = new PlanDoors(house, 'none');
  expect(doorsOf('none').fit([3.11, 2], { width: 0.9 })).toBeNull();
  const { from, to } = doors.fit([3.11, 2], { width: 0.9 })!;
  expect([from[0], to[0]]).toEqual([3.1, 3.1]);
  expect(Math.abs(to[1] - from[1])).toBeCloseTo(0.9, 9);
});

test('the lowest storey alone gets doors', () => {
  const { storeys, ...plan } = planHere();
  const house = { ...plan, storeys: [storeys[0], { ...storeys[0], index: 1 }] };
  expect([0, 1].map((storey) => isLowest(house, storey))).toEqual([true, false]);
  expect(isLowest(planHere(), 1)).toBe(true);
});
