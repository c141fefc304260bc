import { expect, test } from 'vitest';
import {
  joinedOpenings,
  type PlacedOpening,
} from '../../../../src/core/building/openings/joined-openings.ts';
import type { Opening } from '../../../../src/core/types.ts';

const window = (x0: number, x1: number, y = 0): Opening => ({
  type: 'window',
  from: [x0, y],
  to: [x1, y],
  sill: 0.9,
  head: 2.1,
  confidence: 1,
});
const placed = (opening: Opening, isCutBefore: boolean, isCutAfter: boolean): PlacedOpening => ({
  opening,
  isCutBefore,
  isCutAfter,
});

test('halves on both sides of the end of a stretch are one opening', () => {
  const halves = [placed(window(0, 0.6), false, true), placed(window(0.6, 1.3), true, false)];
  for (const given of [halves, [...halves].reverse()]) {
    expect(joinedOpenings(given)).toEqual([window(0, 1.3)]);
  }
});

test('a half looked at from the other side of the wall is joined too', () => {
  const other = { ...window(0, 0), from: [1.3, 0], to: [0.6, 0] } as Opening;
  const joined = joinedOpenings([placed(window(0, 0.6), false, true), placed(other, false, true)]);
  expect(joined).toEqual([window(0, 1.3)]);
});

test('an opening over three stretches is one', () => {
  const thirds = [
    placed(window(0.5, 1), true, true),
    placed(window(0, 0.5), false, true),
    placed(window(1, 1.5), true, false),
  ];
  expect(joinedOpenings(thirds)).toEqual([window(0, 1.5)]);
});

test('openings that a jamb parts, that turn a corner or that are of two kinds stay apart', () => {
  const first = placed(window(0, 0.6), false, true);
  const others: Opening[] = [
    { ...window(0, 0), from: [0.6, 0], to: [0.6, 0.7] },
    { ...window(0.6, 1.3), type: 'door' },
    window(0.9, 1.6),
  ];
  for (const other of others) expect(joinedOpenings([first, placed(other, true, false)])).toHaveLength(2);
  const jamb = [placed(window(0, 0.6), false, false), placed(window(0.6, 1.3), false, false)];
  expect(joinedOpenings(jamb)).toHaveLength(2);
});
