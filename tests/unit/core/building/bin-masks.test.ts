import { expect, it } from 'vitest';
import {
  countBins,
  hasBin,
  highestBin,
  lowestBin,
  MOST_BINS,
  setBin,
} from '../../../../src/core/building/columns/bin-masks.ts';

it('every bin of a mask is told apart, its owner too', () => {
  for (let bin = 0; bin < MOST_BINS; bin++) {
    const masks = new Int32Array(6);
    setBin(masks, 1, bin);
    expect(Array.from({ length: MOST_BINS }, (_, k) => hasBin(masks, 1, k)).indexOf(true)).toBe(bin);
    expect(countBins(masks, 1, 0, MOST_BINS)).toBe(1);
    expect(highestBin(masks, 1)).toBe(bin);
    expect(lowestBin(masks, 1)).toBe(bin);
    expect([0, 2].map((owner) => highestBin(masks, owner))).toEqual([-1, -1]);
    expect([0, 2].map((owner) => lowestBin(masks, owner))).toEqual([-1, -1]);
    setBin(masks, 1, MOST_BINS - 1);
    expect(lowestBin(masks, 1)).toBe(bin);
  }
});

it('bins are counted from the first to before the last', () => {
  const masks = new Int32Array(2);
  for (const bin of [0, 29, 30, 31, 32, 61]) setBin(masks, 0, bin);
  expect(countBins(masks, 0, 29, 32)).toBe(3);
  expect(countBins(masks, 0, -3, 1)).toBe(1);
  expect(countBins(masks, 0, 33, 61)).toBe(0);
});
