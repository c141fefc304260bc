import { expect, it } from 'vitest';
import { sayCoordinates, sayCrs, sayScale } from '../../../src/core/source-coordinates.ts';
import { UPRIGHT_FRAME } from './made-scan.ts';

it('the unit is a fact in a few words', () => {
  expect(sayScale('ft', 0.3048)).toBe('in ft');
  expect(sayScale('custom', 0.37212)).toBe('1 unit = 0.3721 m');
});

it('a coordinate system is its code, or the name that its WKT gives it', () => {
  expect(sayCrs('EPSG:25832')).toBe('EPSG:25832');
  expect(sayCrs('PROJCS["Site 7 grid",GEOGCS["WGS 84"]]')).toBe('Site 7 grid');
  expect(sayCrs('\n COMPOUNDCRS [ "Grid + height", PROJCRS["Grid"]]')).toBe('Grid + height');
  expect(sayCrs('PROJCS("Site 7 grid")')).toBe('Site 7 grid');
});

it('a long description of a coordinate system is cut', () => {
  const words = sayCrs(`+proj=tmerc ${'+lat_0=0 '.repeat(20)}`);
  expect(words).toHaveLength(40);
  expect(words).toMatch(/^\+proj=tmerc \+lat_0=0 .*…$/);
});

it('a place is told in source units and coordinates, and no zero is negative', () => {
  const frame = { ...UPRIGHT_FRAME, planOrigin: [691_000, 0, 0], metresPerUnit: 0.001, unit: 'mm' } as const;
  expect(sayCoordinates(frame, [1.2344, 0.5], 0.01)).toBe('692234, 500');
  expect(sayCoordinates(UPRIGHT_FRAME, [-0.001, 2], 0.01)).toBe('0.00, 2.00');
});
