import { expect, test } from 'vitest';
import { summaryText } from '../../../src/cli/summary.ts';
import { kebabCase } from '../../../src/core/params.ts';
import type { Report } from '../../../src/session/report.ts';

const INPUT: Report['input'] = {
  name: 'hall.xyz',
  format: 'csv',
  bytes: 1,
  pointsRead: 2_000_000,
  pointsKept: 345_678,
  up: 'y',
  unit: 'ft',
  metresPerUnit: 0.3048,
  bounds: { min: [0, 0, 0], max: [1, 1, 1] },
  stations: [],
};
const REPORT: Report = {
  version: 1,
  input: INPUT,
  levels: [],
  boundary: { method: 'gift-opening', vertices: 4, areaM2: 113.1126 },
  secondary: [],
  rooms: [],
  mesh: { vertices: 0, triangles: 0, watertight: true },
  stages: [],
  totalMs: 1,
  warnings: [{ code: 'a/b', message: 'The unit is ft: a guess.', hint: 'Set the unit, or metresPerUnit.' }],
};

test('a person at a terminal sees what was kept, unit, axis, area and warnings with flags', () => {
  expect(summaryText(REPORT)).toBe(
    'hall.xyz: kept 345,678 of 2,000,000 points, in ft, y up, 113.1 m² inside\n' +
      '  ! The unit is ft: a guess. Set the unit, or --metres-per-unit.\n',
  );
  const scaled = {
    ...REPORT,
    input: { ...INPUT, unit: 'custom', metresPerUnit: 2.5 },
    warnings: [],
  } as const;
  expect(summaryText(scaled)).toContain('1 unit = 2.5 m');
});

test('names with figures in them are flags too', () => {
  const warnings = [{ code: 'a/b', message: 'Few points.', hint: 'Raise samplesPer50M2.' }];
  expect(summaryText({ ...REPORT, warnings })).toContain(`Raise --${kebabCase('samplesPer50M2')}.`);
});
