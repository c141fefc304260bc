import { describe, expect, it } from 'vitest';
import { FloorPlanError } from '../../src/core/errors.ts';
import { parseParam, resolveOptions } from '../../src/core/options.ts';
import type { ParamRow } from '../../src/core/param-rows.ts';
import { kebabCase, PARAM_NAMES, PARAMS } from '../../src/core/params.ts';
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

  it.each([1, 5_000])(
    'names pixelsPerMetre where %d makes the sizes of the paper absurd',
    (pixelsPerMetre) => {
      expect(() => resolveOptions({ preset: 'paper', pixelsPerMetre })).toThrow(
        /^pixelsPerMetre: .* of the paper/,
      );
      const own = { strokeWidth: 0.1, wallThickness: 0.1, secondaryEpsilon: 0.1 };
      expect(resolveOptions({ preset: 'paper', pixelsPerMetre, ...own }).strokeWidth).toBe(0.1);
    },
  );

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
    [{ pixelsPerMetre: 0, epsilon: '2px' }],
    [{ pixelsPerMetre: '100' }],
    [{ seed: '3' }],
    [{ epsilon: '' }],
  ])('refuses %j', (given) => {
    expect(codeOf(() => resolveOptions(given as never))).toBe('option/invalid');
  });

  it("turns a person's units into metres and square metres, and auto stays auto", () => {
    const options = resolveOptions({
      epsilon: '2.4px',
      visvalingamEpsilon: '0.2px²',
      wallThickness: '24 cm',
      bridgeGap: '10ft',
      openingLength: 'auto',
      pixelsPerMetre: 50,
    });
    expect(options.epsilon).toBeCloseTo(0.048, 12);
    expect(options.visvalingamEpsilon).toBeCloseTo(0.2 / 2500, 12);
    expect(options).toMatchObject({ wallThickness: 0.24, bridgeGap: 3.048, openingLength: 'auto' });
  });

  it('gives what it was given in one unit as in another', () => {
    const millimetres = (epsilon: number) => resolveOptions({ epsilon: `${epsilon}mm` }).epsilon;
    for (const mm of [1, 3, 7, 9, 24, 111]) expect(millimetres(mm)).toBe(Number(`${mm}e-3`));
  });

  it('names the units a quantity may have, and judges pixels by their size', () => {
    expect(() => resolveOptions({ epsilon: '5 yards' } as never)).toThrow(
      'epsilon: expected auto or a number from 0 to 10 m, or with a unit (px, mm, cm, m, in or ft), found "5 yards"',
    );
    expect(() => resolveOptions({ visvalingamEpsilon: '5cm' } as never)).toThrow(
      '(px², mm², cm², m², in² or ft²)',
    );
    expect(resolveOptions({ epsilon: '500px' }).epsilon).toBe(5);
    expect(codeOf(() => resolveOptions({ epsilon: '500px', pixelsPerMetre: 10 }))).toBe('option/invalid');
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
    ['epsilon', '24mm', { epsilon: 0.024 }],
    ['epsilon', ' 2.4 cm ', { epsilon: 0.024 }],
    ['epsilon', '1in', { epsilon: 0.0254 }],
    ['bridgeGap', '10ft', { bridgeGap: 3.048 }],
    ['wallThickness', '2e-1M', { wallThickness: 0.2 }],
    ['visvalingamEpsilon', '5cm2', { visvalingamEpsilon: 0.0005 }],
    ['visvalingamEpsilon', '500 mm²', { visvalingamEpsilon: 0.0005 }],
    ['epsilon', '2.4px', { epsilon: '2.4px' }],
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
    ['epsilon', '24 furlongs'],
    ['epsilon', '5cm2'],
    ['epsilon', 'mm'],
    ['epsilon', '20m'],
    ['visvalingamEpsilon', '5cm'],
    ['secondaryCount', '2px'],
    ['wallThickness', 'auto'],
  ])('refuses %s = "%s"', (name, text) => {
    expect(codeOf(() => parseParam(name, text))).toBe('option/invalid');
  });
});
