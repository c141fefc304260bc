import { describe, expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import type { ParamRow } from '../../../src/core/param-rows.ts';
import { PARAM_NAMES, PARAMS, type ParamName } from '../../../src/core/params.ts';
import { fromTravel, hasSlider, toTravel } from '../../../src/element/slider-scale.ts';

const rows = PARAM_NAMES.flatMap((name) => {
  const row: ParamRow = PARAMS[name];
  return row.kind === 'number' || row.kind === 'auto-number' ? [[name, row] as const] : [];
});

describe.each(rows)('%s', (name: ParamName, row) => {
  it('takes every place of its slider', () => {
    for (let i = 0; i <= 100; i++) {
      const value = fromTravel(i / 100, row);
      expect(() => resolveOptions({ [name]: value })).not.toThrow();
    }
    expect(fromTravel(0, row)).toBe(row.min);
    expect(fromTravel(1, row)).toBe(row.max);
  });

  it('comes back to its default', () => {
    const value = typeof row.default === 'number' ? row.default : row.min;
    expect(Math.abs(fromTravel(toTravel(value, row), row) - value)).toBeLessThanOrEqual(row.step / 2);
  });
});

it('a seed is typed, a thickness slid', () => {
  expect(hasSlider(PARAMS.seed)).toBe(false);
  expect(hasSlider(PARAMS.wallThickness)).toBe(true);
});
