import fc from 'fast-check';
import { expect, test } from 'vitest';
import { placeFigures, TICK } from '../../../../src/write/sheet/chain-figures.ts';
import { textWidth } from '../../../../src/write/sheet/text-width.ts';

const widthOf = (figure: string) => textWidth(figure, 2.5);

test('no figure above its line meets a tick', () => {
  const just = widthOf('0.69') + 2 * TICK;
  expect(placeFigures([0, just], ['0.69'])[0]?.isBelow).toBe(true);
  expect(placeFigures([0, just + 1], ['0.69'])[0]?.isBelow).toBe(false);
});

test('figures below make room to either side: widths in feet and inches side by side all stand', () => {
  const figures = ['4\'-3 1/8"', '2\'-3 1/8"', '4\'-3"'];
  const placed = placeFigures([0, 9, 16, 23], figures);
  expect(placed.every((figure) => figure?.isBelow)).toBe(true);
  expect(placed[0]!.at).toBeLessThan(4.5);
  expect(placed[2]!.at).toBeGreaterThan(19.5);
});

test('figures below never overlap nor stand far off, and what finds no place is left out', () => {
  const stretch = fc.double({ min: 0.2, max: 12, noNaN: true });
  fc.assert(
    fc.property(fc.array(stretch, { minLength: 1, maxLength: 30 }), (stretches) => {
      const places = [0];
      for (const each of stretches) places.push(places.at(-1)! + each);
      const figures = stretches.map((each) => each.toFixed(2));
      let end = Number.NEGATIVE_INFINITY;
      placeFigures(places, figures).forEach((figure, i) => {
        if (figure === null || !figure.isBelow) return;
        const half = widthOf(figures[i]) / 2;
        expect(figure.at - half).toBeGreaterThan(end + 0.9);
        expect(Math.abs(figure.at - (places[i] + places[i + 1]) / 2)).toBeLessThan(4 + 1e-9);
        end = figure.at + half;
      });
    }),
  );
});
