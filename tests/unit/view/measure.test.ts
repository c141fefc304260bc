import { describe, expect, it } from 'vitest';
import {
  formatBand,
  formatCount,
  formatDensity,
  formatDuration,
  formatLength,
  fromMetres,
  roundLengths,
  toMetres,
} from '../../../src/view/measure.ts';
import { formatArea, formatDimension } from '../../../src/write/sheet/measure-words.ts';

describe('formatLength', () => {
  it.each([
    [0, '0 m'],
    [3.4200001, '3.42 m'],
    [12, '12 m'],
    [0.005, '0.005 m'],
  ])('%f m reads %s', (metres, text) => expect(formatLength(metres, 'm')).toBe(text));

  it.each([
    [0.3048, '1′'],
    [3.429, '11′ 3″'],
    [0.0127, '0.5″'],
    // Just below twelve feet must not read 11′ 12″.
    [3.6575, '12′'],
  ])('%f m reads %s in feet', (metres, text) => expect(formatLength(metres, 'ft')).toBe(text));
});

describe('bands of heights', () => {
  it('keep their decimals, and whole inches', () => {
    expect(formatBand(0.651, 2, 'm')).toBe('0.65 to 2.00 m');
    expect(formatBand(0.03, 1.9299, 'ft')).toBe('0′ 1″ to 6′ 4″');
    expect(formatBand(0, 3.6575, 'ft')).toBe('0′ 0″ to 12′ 0″');
  });
  it('are typed in the unit shown and kept in metres', () => {
    expect([toMetres(1.2, 'm'), toMetres(4, 'ft')]).toEqual([1.2, 1.219]);
    expect([fromMetres(1.2, 'm'), fromMetres(1.219, 'ft')]).toEqual([1.2, 4]);
  });
});

describe('other measures', () => {
  it('densities', () => {
    expect(formatDensity(1234.4, 'm')).toBe('1,234 per m²');
    expect(formatDensity(100 / 0.09290304, 'ft')).toBe('100 per ft²');
  });
  it('areas', () => {
    expect(formatArea(14.24, 'm')).toBe('14.2 m²');
    expect(formatArea(9.290304, 'ft')).toBe('100 ft²');
    // A column or a shaft.
    expect([0.018, 0.25].map((area) => formatArea(area, 'm'))).toEqual(['0.02 m²', '0.25 m²']);
    expect(formatArea(0.0232, 'ft')).toBe('0.2 ft²');
  });
  it('counts and durations', () => {
    expect(formatCount(1234567)).toBe('1,234,567');
    expect([0.2, 12.4, 1250, 125_000].map(formatDuration)).toEqual(['< 1 ms', '12 ms', '1.3 s', '2 min']);
  });
});

describe('roundLengths', () => {
  it.each(['m', 'ft'] as const)('rise, and read as round numbers in %s', (unit) => {
    const lengths = roundLengths(unit);
    expect([...lengths].sort((a, b) => a - b)).toEqual([...lengths]);
    for (const length of lengths) expect(formatLength(length, unit)).toMatch(/^\d+(\.\d+)?( m|′|″)$/);
  });
});

it.each([
  [4.2, '4.20', `13'-9 3/8"`],
  [0.3048, '0.30', `1'-0"`],
  [0.0254, '0.03', '1"'],
  [0.009525, '0.01', '3/8"'],
  [3.047, '3.05', `10'-0"`],
  [0, '0.00', '0"'],
])('%s m stands at a dimension line as %s or %s', (metres, metric, imperial) => {
  expect([formatDimension(metres, 'm'), formatDimension(metres, 'ft')]).toEqual([metric, imperial]);
});
