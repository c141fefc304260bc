import { describe, expect, it } from 'vitest';
import { boxBetween, dragged, gripAt, HANDLES, handleAt } from '../../../../src/element/crop/grip.ts';

const BOX = { low: [1, 2], high: [5, 4] } as const;

describe('gripAt', () => {
  it('takes every handle where it is', () => {
    expect(HANDLES).toHaveLength(8);
    for (const handle of HANDLES) expect(gripAt(BOX, handleAt(BOX, handle), 0.1)).toEqual(handle);
  });

  it.each([
    [
      [5.05, 2.9],
      [1, 0],
    ],
    [
      [2, 1.95],
      [0, -1],
    ],
    [[3, 3], 'all'],
    [[6, 3], null],
    [[3, 4.2], null],
  ] as const)('takes at %j %j', (place, grip) => {
    expect(gripAt(BOX, place, 0.1)).toEqual(grip);
  });
});

describe('dragged', () => {
  it('moves the sides that are held', () => {
    expect(dragged(BOX, [1, 0], [2, 9])).toEqual({ low: [1, 2], high: [7, 4] });
    expect(dragged(BOX, [-1, 1], [-1, 1])).toEqual({ low: [0, 2], high: [5, 5] });
    expect(dragged(BOX, 'all', [1, -1])).toEqual({ low: [2, 1], high: [6, 3] });
  });

  it('turns over when a side is dragged past the other', () => {
    expect(dragged(BOX, [1, 0], [-6, 0])).toEqual({ low: [-1, 2], high: [1, 4] });
  });
});

it('makes a box of any two opposite corners', () => {
  expect(boxBetween([5, 2], [1, 4])).toEqual(BOX);
});
