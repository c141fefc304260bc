import fc from 'fast-check';
import { expect, test } from 'vitest';
import { centroid, polygonArea } from '../../src/core/geometry/rings.ts';
import { meanSpacing } from '../../src/core/geometry/spacing.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { createRandom } from '../../src/core/random.ts';
import { findSecondary } from '../../src/core/secondary.ts';
import type { RegularisedBoundary, Slice } from '../../src/core/types.ts';
import { expectValidPolygons } from '../invariants.ts';
import { listen } from '../unit/core/made-scan.ts';

interface Column {
  readonly x: number;
  readonly y: number;
  readonly half: number;
  readonly turn: number;
  readonly isRound: boolean;
  readonly seed: number;
}

const columns: fc.Arbitrary<Column> = fc.record({
  x: fc.double({ min: 1.5, max: 8.5, noNaN: true }),
  y: fc.double({ min: 1.5, max: 4.5, noNaN: true }),
  half: fc.double({ min: 0.2, max: 0.6, noNaN: true }),
  turn: fc.double({ min: 0, max: 6.28, noNaN: true }),
  isRound: fc.boolean(),
  seed: fc.nat(1000),
});

const PRIMARY = Float64Array.of(0, 0, 10, 0, 10, 6, 0, 6);

function roomWith({ x, y, half, turn, isRound, seed }: Column, shift: readonly [number, number]) {
  const random = createRandom(seed);
  const points: number[] = [];
  const add = (px: number, py: number) =>
    points.push(px + shift[0] + 0.008 * (random() - 0.5), py + shift[1] + 0.008 * (random() - 0.5));
  for (let t = 0; t < 10; t += 0.03) for (const side of [0, 6]) add(t, side);
  for (let t = 0; t < 6; t += 0.03) for (const side of [0, 10]) add(side, t);
  for (let a = 0; a < 2 * Math.PI; a += 0.03 / half) {
    const reach = isRound ? half : half / Math.max(Math.abs(Math.cos(a)), Math.abs(Math.sin(a)));
    add(x + reach * Math.cos(a + turn), y + reach * Math.sin(a + turn));
  }
  const xy = Float64Array.from(points);
  const slice: Slice = { xy, band: [0, 0], spacing: meanSpacing(xy) };
  const outer = PRIMARY.map((value, i) => value + shift[i % 2]);
  const regularised: RegularisedBoundary = { passes: [], polygons: [{ outer, holes: [] }] };
  return { slice, regularised };
}

test('a free-standing column is found where it stands, wherever the room lies', () => {
  const shifts = fc.tuple(fc.integer({ min: -500, max: 500 }), fc.integer({ min: -500, max: 500 }));
  fc.assert(
    fc.property(columns, shifts, (column, shift) => {
      const { slice, regularised } = roomWith(column, shift);
      const options = resolveOptions({ secondaryCount: 1 });
      const { boundaries } = findSecondary(slice, regularised, options, listen().context);
      expect(boundaries.length).toBe(1);
      expectValidPolygons(boundaries.map(({ outline }) => outline));
      const [x, y] = centroid(boundaries[0].outline.outer);
      expect(Math.hypot(x - shift[0] - column.x, y - shift[1] - column.y)).toBeLessThan(0.05);
      const area = (column.isRound ? Math.PI : 4) * column.half ** 2;
      expect(polygonArea(boundaries[0].outline) / area).toBeGreaterThan(0.8);
      expect(polygonArea(boundaries[0].outline) / area).toBeLessThan(1.2);
      expect(boundaries[0].type).toBe(column.half <= 0.75 / Math.SQRT2 ? 'column' : boundaries[0].type);
    }),
    { numRuns: 60 },
  );
});
