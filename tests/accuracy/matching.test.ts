import { describe, expect, it } from 'vitest';
import { seededRandom } from '../../fixtures/simulator/random.ts';
import type { XY } from '../../fixtures/simulator/ring.ts';
import { assign, countPairs } from './matching.ts';

function permutations(items: readonly number[]): number[][] {
  if (items.length === 0) return [[]];
  return items.flatMap((item) =>
    permutations(items.filter((other) => other !== item)).map((rest) => [item, ...rest]),
  );
}

const total = (
  gains: readonly (readonly number[])[],
  pairs: readonly (readonly [number, number])[],
): number => pairs.reduce((sum, [row, column]) => sum + gains[row][column], 0);

describe('assign', () => {
  it('gives up a best pair for a better whole', () => {
    const gains = [
      [0.9, 0.8],
      [0.8, 0.1],
    ];
    expect(assign(gains)).toEqual([
      [0, 1],
      [1, 0],
    ]);
  });

  it('is as good as the best permutation', () => {
    const random = seededRandom(1, 'assign');
    for (let round = 0; round < 60; round++) {
      const [rows, columns] = [random.integer(1, 5), random.integer(1, 5)];
      const gains = Array.from({ length: rows }, () => Array.from({ length: columns }, () => random.next()));
      const turned = rows > columns;
      const [short, long] = turned ? [columns, rows] : [rows, columns];
      const best = permutations([...Array(long).keys()]).map((order) =>
        total(
          gains,
          order.slice(0, short).map((k, i): readonly [number, number] => (turned ? [k, i] : [i, k])),
        ),
      );
      const pairs = assign(gains);
      expect(pairs).toHaveLength(short);
      expect(new Set(pairs.map(([row]) => row)).size).toBe(short);
      expect(new Set(pairs.map(([, column]) => column)).size).toBe(short);
      expect(total(gains, pairs)).toBeCloseTo(Math.max(...best), 12);
    }
  });

  it('has nothing to pair with nothing', () => {
    expect(assign([])).toEqual([]);
    expect(assign([[], []])).toEqual([]);
  });
});

describe('countPairs', () => {
  it('pairs one-to-one, as many as can be', () => {
    const found: XY[] = [
      [0, 0],
      [0.9, 0],
    ];
    // Greedy pairing of (0, 0) with (0.4, 0) would leave the second point alone with (−0.5, 0).
    const wanted: XY[] = [
      [0.4, 0],
      [-0.5, 0],
    ];
    expect(countPairs(found, wanted, 0.6)).toBe(2);
    expect(countPairs(found, wanted, 0.3)).toBe(0);
    expect(countPairs(found, [], 1)).toBe(0);
  });

  it('counts a point within the radius once', () => {
    expect(
      countPairs(
        [
          [0, 0],
          [0.01, 0],
          [0.02, 0],
        ],
        [[0, 0]],
        0.1,
      ),
    ).toBe(1);
  });
});
