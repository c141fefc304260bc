import fc from 'fast-check';
import { expect, it } from 'vitest';
import { resolveOptions } from '../../../src/core/options.ts';
import { readScan } from '../../../src/read/read-scan.ts';
import { Thinning } from '../../../src/read/thin/thinning.ts';
import { memorySource } from '../../unit/read/memory-source.ts';

type Point = readonly [number, number, number];

/** Coordinates that meet in cells, repeat, and lie on cell borders. */
const coordinate = fc.oneof(
  fc.integer({ min: -40, max: 40 }).map((n) => n / 8),
  // Not the denormals of float64: a hundred zeros behind the point, cells are scaled past them.
  fc.float({ min: -5, max: 5, noNaN: true }),
  fc.constantFrom(0, -0, 1e6, 1e6 + 2 ** -9, -1e-300),
);
const points = fc.array(fc.tuple(coordinate, coordinate, coordinate), { minLength: 1, maxLength: 300 });
const shuffled = points.chain((list) =>
  fc.tuple(fc.constant(list), fc.shuffledSubarray(list, { minLength: list.length })),
);
const power = fc.integer({ min: -8, max: 2 });

function thin(list: readonly Point[], cell: number, budget = 1_000, chunk = list.length): Thinning {
  const thinning = new Thinning({ cell, budget });
  for (let begin = 0; begin < list.length; begin += chunk) {
    const part = list.slice(begin, begin + chunk);
    thinning.add({ count: part.length, xyz: Float64Array.from(part.flat()) });
  }
  return thinning;
}

const keptOf = (thinning: Thinning) => {
  const { positions, count } = thinning.inOrder([0, 0, 0], (length) => new Float64Array(length));
  return Array.from({ length: count }, (_, i) => [...positions.subarray(3 * i, 3 * i + 3)].join()).sort();
};

it('keeps the same points in any order, in any chunks, and of duplicates', () => {
  fc.assert(
    fc.property(shuffled, power, fc.integer({ min: 1, max: 300 }), ([list, other], exponent, chunk) => {
      const kept = keptOf(thin(list, 2 ** exponent));
      expect(keptOf(thin(other, 2 ** exponent, 1_000, chunk))).toEqual(kept);
      expect(keptOf(thin([...list, ...other], 2 ** exponent))).toEqual(kept);
    }),
  );
});

it('coarsens to what the coarse cells would have kept', () => {
  fc.assert(
    fc.property(points, power, fc.integer({ min: 0, max: 6 }), (list, exponent, steps) => {
      const coarsened = thin(list, 2 ** exponent);
      coarsened.coarsen(2 ** (exponent + steps));
      expect(keptOf(coarsened)).toEqual(keptOf(thin(list, 2 ** (exponent + steps))));
    }),
  );
});

it('ends at the same cells and points for every order under a budget', () => {
  fc.assert(
    // The lattice has a corner at zero, so points around it never meet in fewer than eight cells.
    fc.property(shuffled, power, fc.integer({ min: 8, max: 100 }), ([list, other], exponent, budget) => {
      const [a, b] = [thin(list, 2 ** exponent, budget), thin(other, 2 ** exponent, budget, 7)];
      expect(a.cell).toBe(b.cell);
      expect(a.count).toBeLessThanOrEqual(budget);
      expect(keptOf(a)).toEqual(keptOf(b));
      if (a.isOverBudget) expect(thin(list, a.cell / 2).count).toBeGreaterThan(budget);
    }),
  );
});

it('makes equal scans of any order of the rows and any split of the bytes', async () => {
  const options = resolveOptions({ resolution: 0.25, unit: 'm' });
  const columns = fc.constantFrom<readonly number[]>([0, 1, 2], [0, 1]);
  const pieces = fc.array(fc.integer({ min: 1, max: 99 }), { minLength: 1, maxLength: 3 });
  await fc.assert(
    fc.asyncProperty(shuffled, columns, pieces, async ([list, other], axes, split) => {
      // So that no list is refused for lying on a line.
      const corners: Point[] = [
        [0, 0, 0],
        [4, 0, 0],
        [0, 4, 4],
      ];
      const text = (rows: readonly Point[]) =>
        [...rows, ...corners].map((row) => axes.map((axis) => row[axis]).join(',')).join('\n');
      const read = (rows: readonly Point[], sizes?: number[]) =>
        readScan(memorySource(text(rows), 'a.csv', sizes), options);
      const [a, b] = [await read(list), await read(other, split)];
      expect(a.positions).toEqual(b.positions);
      expect({ ...a, facts: { ...a.facts, bytes: 0 } }).toEqual({ ...b, facts: { ...b.facts, bytes: 0 } });
    }),
    { numRuns: 60 },
  );
});
