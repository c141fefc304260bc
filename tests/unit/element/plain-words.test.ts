import { expect, it } from 'vitest';
import type { ParamRow } from '../../../src/core/param-rows.ts';
import { PARAMS } from '../../../src/core/params.ts';
import { sayChoice, sayLabels, saySentence } from '../../../src/element/plain-words.ts';

it('parameters are called by the label of their control', () => {
  expect(sayLabels('Raise the opening length, or bridgeGap, now 3.5 m.')).toBe(
    `Raise the opening length, or “${PARAMS.bridgeGap.label}”, now 3.5 m.`,
  );
  expect(sayLabels('samplesPer50M2 is low')).toBe(`“${PARAMS.samplesPer50M2.label}” is low`);
});

it('an error starts as a sentence unless a name comes first', () => {
  expect(saySentence('expected 3 points, found 2')).toBe('Expected 3 points, found 2');
  expect(saySentence('a.csv: expected 3 points')).toBe('a.csv: expected 3 points');
});

it('plain words and names of something else stay', () => {
  const text = 'Set the level, the unit or the seed of myScan; iPad and toString are no parameters.';
  expect(sayLabels(text)).toBe(text);
});

it('choices read as words, units and axes as they are', () => {
  expect(['gift-opening', 'add', 'bsp', 'us-ft', '-x', 'mm'].map(sayChoice)).toEqual([
    ...['Gift opening', 'Add', 'BSP', 'US survey foot', '-x', 'mm'],
  ]);
});

it('no two choices of a parameter read alike', () => {
  for (const row of Object.values(PARAMS) as ParamRow[]) {
    if (!('choices' in row)) continue;
    expect(new Set(row.choices.map(sayChoice)).size).toBe(row.choices.length);
  }
});
