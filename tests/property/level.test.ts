import fc from 'fast-check';
import { expect, test } from 'vitest';
import { FloorPlanError } from '../../src/core/errors.ts';
import { chooseLevel } from '../../src/core/level.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { createRandom } from '../../src/core/random.ts';
import { everyIndex, listen, makeCloud, shuffled } from '../unit/core/made-scan.ts';

const points = fc
  .array(
    fc.tuple(
      fc.integer({ min: 0, max: 800 }),
      fc.integer({ min: 0, max: 800 }),
      fc.integer({ min: 0, max: 300 }),
    ),
    {
      minLength: 30,
      maxLength: 200,
    },
  )
  .map((list) => list.flat().map((value) => value / 100));

function run(positions: ArrayLike<number>, given: Parameters<typeof resolveOptions>[0] = {}) {
  const cloud = makeCloud(positions);
  return { cloud, ...chooseLevel(cloud, everyIndex(cloud), resolveOptions(given), listen().context) };
}

test('every point belongs to the level whose reference height is nearest', () => {
  fc.assert(
    fc.property(points, (positions) => {
      const z = Float32Array.from(positions).filter((_, i) => i % 3 === 2);
      const references = [Math.min(...z), z.reduce((a, b) => a + b, 0) / z.length, Math.max(...z)];
      const counts = [0, 0, 0];
      let ties = 0;
      for (const height of z) {
        const away = references.map((reference) => Math.abs(height - reference));
        const least = Math.min(...away);
        if (away.filter((distance) => distance - least < 1e-6).length > 1) ties++;
        counts[away.indexOf(least)]++;
      }
      const { levels } = run(positions, { level: '0:1000' });
      levels.forEach((level, k) => {
        expect(Math.abs(level.points - counts[k])).toBeLessThanOrEqual(ties);
      });
      expect(levels.reduce((sum, level) => sum + level.points, 0)).toBe(z.length);
    }),
  );
});

/** Whether the level chosen holds points enough. */
function hasLevel(positions: readonly number[]): boolean {
  try {
    run(positions);
    return true;
  } catch (error) {
    if (error instanceof FloorPlanError && error.code === 'input/too-few-points') return false;
    throw error;
  }
}

test('the order of the points does not change the levels, nor does the height of the floor', () => {
  fc.assert(
    fc.property(points, fc.nat(50), (positions, seed) => {
      fc.pre(hasLevel(positions));
      const one = run(positions);
      const other = run(shuffled(positions, 3, createRandom(seed)));
      one.levels.forEach((level, k) => {
        expect(other.levels[k].points).toBe(level.points);
        expect(other.levels[k].low).toBeCloseTo(level.low, 9);
        expect(other.levels[k].densityPerM2).toBeCloseTo(level.densityPerM2, 6);
      });
      // Heights in 1/100 m stay apart by more than float32 rounding at 64 m.
      const lifted = run(positions.map((value, i) => (i % 3 === 2 ? value + 64 : value)));
      one.levels.forEach((level, k) => {
        expect(lifted.levels[k].low).toBeCloseTo(level.low, 4);
      });
    }),
  );
});
