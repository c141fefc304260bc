import { describe, expect, it } from 'vitest';
import { parseClasses } from '../../../src/core/classes.ts';
import { resolveOptions } from '../../../src/core/options.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { CORNERS, lasBytes } from './las/las-bytes.ts';
import { memorySource } from './memory-source.ts';

const codesOf = (text: string) => [...parseClasses(text)!.keys()].filter((code) => parseClasses(text)![code]);

describe('parseClasses', () => {
  it.each([
    ['2', [2]],
    ['2,6', [2, 6]],
    [' 6 , 2 ', [2, 6]],
    ['1-3,2,255', [1, 2, 3, 255]],
    ['0', [0]],
  ])('%j', (text, codes) => {
    expect(codesOf(text)).toEqual(codes);
  });

  it('is null for all', () => {
    expect(parseClasses('all')).toBeNull();
  });

  it.each(['', 'ground', '256', '6-2', '-1', '2;6', '2,', '1.5', '1-2-3', 'all,2'])('refuses %j', (text) => {
    expect(() => parseClasses(text)).toThrow(expect.objectContaining({ code: 'option/invalid' }));
    expect(() => resolveOptions({ classes: text })).toThrow(
      expect.objectContaining({ code: 'option/invalid' }),
    );
  });
});

describe('reading by class', () => {
  // Class i lies at corner i.
  const las = memorySource(lasBytes({ format: 2, minor: 2, points: CORNERS }), 'a.las', [60]);
  const read = (classes: string, source = las) => readScan(source, resolveOptions({ classes, unit: 'm' }));

  it('keeps the points of the classes with all they bear', async () => {
    const { facts, attributes, bounds, warnings } = await read('1,4-6');
    expect(facts.pointsKept).toBe(4);
    expect([...attributes.classification!].sort()).toEqual([1, 4, 5, 6]);
    attributes.classification!.forEach((code, i) => {
      const red = Math.round((8000 * code * 255) / 65_535);
      expect(attributes.colour![3 * i]).toBe(red);
      expect(attributes.intensity![i]).toBeCloseTo((8191 * code) / 65_535, 6);
    });
    expect(bounds).toEqual({ min: [0, 0, 0], max: [4, 3, 2.5] });
    expect(warnings).toEqual([]);
  });

  it('keeps all where none is left, and names those there are', async () => {
    const { facts, warnings } = await read('40-50');
    expect(facts.pointsKept).toBe(8);
    expect(warnings).toMatchObject([
      { code: 'read/classes-ignored', message: expect.stringContaining('0, 1, 2, 3, 4, 5, 6, 7') },
    ]);
  });

  it('keeps all where the points have no classes', async () => {
    const csv = CORNERS.map(({ at }) => at.map((value) => value / 100).join()).join('\n');
    const { facts, warnings } = await read('2', memorySource(`x,y,z\n${csv}\n`, 'a.csv'));
    expect(facts.pointsKept).toBe(8);
    expect(warnings).toMatchObject([{ code: 'read/classes-ignored' }]);
  });
});
