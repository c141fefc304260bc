import { expect, test } from 'vitest';
import { secondaryCases } from '../reproduction/secondary-cases.ts';

/** Of each half; `npm run reproduce` runs a hundred of each. */
const CASES = 30;
const LEAST_SHARE = 0.9;

test('robust finds the structure in nine of ten variations of the paper rooms, the plain method in few', async () => {
  const { development, keptBack } = await secondaryCases(CASES);
  expect(development.cases + keptBack.cases).toBe(2 * CASES);
  expect(development.robust).toBeGreaterThanOrEqual(LEAST_SHARE);
  expect(keptBack.robust).toBeGreaterThanOrEqual(LEAST_SHARE);
  expect(development.paper).toBeLessThan(development.robust);
  expect(keptBack.paper).toBeLessThan(keptBack.robust);
});
