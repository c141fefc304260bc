import { describe, expect, it } from 'vitest';
import { FloorPlanError } from '../../src/core/errors.ts';
import { parseParam, resolveOptions } from '../../src/core/options.ts';
import { kebabCase, PARAM_NAMES, PARAMS, type ParamRow } from '../../src/core/params.ts';
import { STAGES } from '../../src/core/stages.ts';

function codeOf(act: () => unknown): string {
  try {
    act();
  } catch (error) {
    if (error instanceof FloorPlanError) return error.code;
    throw error;
  }
  return 'none';
}

describe('the tables', () => {
  it('give every stage a share of a whole run', () => {
    const sum = Object.values(STAGES).reduce((total, { share }) => total + share, 0);
    expect(sum).toBeCloseTo(1, 9);
  });

  it('give every parameter an own spelling, a sentence and a default within its range', () => {
    expect(new Set(PARAM_NAMES.map(kebabCase)).size).toBe(PARAM_NAMES.length);
    for (const name of PARAM_NAMES) {
      const row: ParamRow = PARAMS[name];
      expect(row.doc).toMatch(/^\S.*\.$/);
      expect(row.label.length).toBeGreaterThan(2);
      expect(codeOf(() => resolveOptions({ [name]: row.default }))).toBe('none');
    }
  });
});

describe('resolveOptions', () => {
  it('takes building for scans and paper for ready slices', () => {
    expect(resolveOptions({}).preset).toBe('building');
    expect(resolveOptions({}, { isSlice: true }).preset).toBe('paper');
    expect(resolveOptions({ preset: 'paper' }).levelRule).toBe('count');
  });

  it("turns the paper's pixels into metres and square metres", () => {
    const options = resolveOptions({ preset: 'paper', pixelsPerMetre: 50 });
    expect(options.epsilon).toBeCloseTo(0.048, 12);
    expect(options.visvalingamEpsilon).toBeCloseTo(0.2 / 2500, 12);
    expect(options.alpha).toBeCloseTo(3, 12);
    expect(options.strokeWidth).toBeCloseTo(0.2, 12);
  });

  it('lets a given value win over the preset', () => {
    expect(resolveOptions({ preset: 'paper', epsilon: 0.5 }).epsilon).toBe(0.5);
  });

  it.each([
    [{ epsilon: -1 }],
    [{ epsilon: Number.NaN }],
    [{ secondaryCount: 1.5 }],
    [{ level: '3:1' }],
    [{ level: '' }],
    [{ boundary: 'round' }],
    [{ secondaryOperation: [] }],
    [{ floorSlab: 'yes' }],
  ])('refuses %j', (given) => {
    expect(codeOf(() => resolveOptions(given as never))).toBe('option/invalid');
  });

  it('refuses an unknown option', () => {
    expect(codeOf(() => resolveOptions({ colour: 1 } as never))).toBe('option/unknown');
    expect(codeOf(() => resolveOptions({ toString: 1 } as never))).toBe('option/unknown');
  });
});

describe('parseParam', () => {
  it.each([
    ['epsilon', 'auto', { epsilon: 'auto' }],
    ['epsilon', '0.05', { epsilon: 0.05 }],
    ['floorSlab', '', { floorSlab: true }],
    ['floorSlab', 'false', { floorSlab: false }],
    ['level', '0.5:2', { level: '0.5:2' }],
    ['secondaryOperation', 'subtract, add', { secondaryOperation: ['subtract', 'add'] }],
  ])('reads %s = "%s"', (name, text, value) => {
    expect(parseParam(name, text)).toEqual(value);
  });

  it.each([
    ['epsilon', ''],
    ['epsilon', '1e999'],
    ['up', 'north'],
    ['floorSlab', 'maybe'],
    ['secondaryOperation', 'subtract,,add'],
  ])('refuses %s = "%s"', (name, text) => {
    expect(codeOf(() => parseParam(name, text))).toBe('option/invalid');
  });
});
