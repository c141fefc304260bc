import { expect, test } from 'vitest';
import { writeSvg } from '../../../../src/write/drawing/svg.ts';
import type { Product } from '../../../../src/write/plan-writer.ts';
import { rectangle, secondary } from '../../solid/plans.ts';
import { home, productOf } from '../products.ts';
import { parseXml, type XmlElement } from './strict-xml.ts';

const drawn = (product: Product): XmlElement => parseXml(writeSvg(product, 0));
const numbers = (text: string | null): number[] => (text ?? '').split(/[\s,]+/).map(Number);

/** Vertices of a path made of M and L. */
const vertices = (path: XmlElement): number[][] =>
  [...path.getAttribute('d')!.matchAll(/[ML]([-\d.]+) ([-\d.]+)/g)].map(([, x, y]) => [Number(x), Number(y)]);

test('the sheet is in millimetres, at the scale it says', async () => {
  const svg = drawn(await productOf(home(), 'Home'));
  const [, , width, height] = numbers(svg.getAttribute('viewBox'));
  expect([svg.getAttribute('width'), svg.getAttribute('height')]).toEqual([`${width}mm`, `${height}mm`]);
  expect([width, height]).toEqual([297, 210]);
  expect(svg.getAttribute('data-scale')).toBe('100');
  const [k, , , , e, f] = numbers(svg.getAttribute('data-plan-to-sheet'));
  const wall = vertices(svg.byId('wall-0')!);
  const [x, y] = wall.map((vertex) => vertex).reduce((a, b) => (a[0] + a[1] > b[0] + b[1] ? a : b));
  // The south-east corner of the home, 12 m east and 0 m north.
  expect(x).toBeCloseTo(12 * k + e, 3);
  expect(y).toBeCloseTo(f, 3);
  expect(k).toBe(1000 / 100);
});

test('every layer is a group with an id, and points are off', async () => {
  const svg = drawn(await productOf(home()));
  const layers = svg.childNodes.filter(({ nodeName }) => nodeName === 'g');
  expect(layers.map((layer) => layer.getAttribute('id'))).toEqual([
    ...['points', 'walls', 'secondary', 'gaps', 'openings', 'dimensions', 'labels', 'title'],
  ]);
  expect(layers[0].getAttribute('display')).toBe('none');
});

test('ids are unique', async () => {
  const svg = drawn(await productOf(home()));
  const ids = [...svg.all('g'), ...svg.all('path'), ...svg.all('text'), ...svg.all('rect')].flatMap(
    (element) => element.getAttribute('id') ?? [],
  );
  expect(new Set(ids).size).toBe(ids.length);
});

test('nothing in it needs a style or a script', async () => {
  const text = writeSvg(await productOf(home()), 0);
  expect(text).not.toMatch(/style|script|href|\bon\w+=|class=/i);
});

test('a place on the sheet can be turned back into the scan', async () => {
  const frame = { planOrigin: [691_000.123, 5_334_000.456, 500] as const, metresPerUnit: 1 };
  const svg = drawn(await productOf({ ...home(), frame }));
  const { sheet } = JSON.parse(svg.byId('frame')!.text) as { sheet: Record<string, number[]> };
  const [k, , , , e, f] = numbers(svg.getAttribute('data-plan-to-sheet'));
  const [x, y] = [7 * k + e, -2 * k + f];
  const [a, b, c, d, u, v] = sheet.sheetToSource;
  expect(a * x + c * y + u).toBeCloseTo(691_007.123, 6);
  expect(b * x + d * y + v).toBeCloseTo(5_334_002.456, 6);
  expect(sheet.planToSheet).toEqual(numbers(svg.getAttribute('data-plan-to-sheet')));
});

test('a gap is cut out of the wall and drawn dashed', async () => {
  const svg = drawn(await productOf(home()));
  const gap = svg.byId('gap-0')!;
  expect(gap.getAttribute('stroke-dasharray')).toBe('3 1');
  const xs = vertices(gap).map(([x]) => x);
  const [k, , , , e] = numbers(svg.getAttribute('data-plan-to-sheet'));
  expect((Math.min(...xs) - e) / k).toBeCloseTo(8.9, 3);
  expect((Math.max(...xs) - e) / k).toBeCloseTo(10.1, 3);
  // The wall is open there: one ring of material no longer goes all the way round.
  expect(svg.byId('wall-0')!.getAttribute('d')!.match(/Z/g)).toHaveLength(1);
});

test('hatches tell the operations apart, and stay inside their outlines', async () => {
  const operations = ['subtract', 'add', 'independent'] as const;
  const hatches = await Promise.all(
    operations.map(async (operation) => {
      const svg = drawn(
        await productOf({ storeys: [{ secondary: [secondary(rectangle(1, 1, 1, 1), operation)] }] }),
      );
      const [hatch, outline] = svg.byId('secondary')!.childNodes;
      const [xs, ys] = [0, 1].map((axis) => vertices(outline).map((vertex) => vertex[axis]));
      for (const [x, y] of vertices(hatch)) {
        expect(x).toBeGreaterThanOrEqual(Math.min(...xs) - 1e-3);
        expect(x).toBeLessThanOrEqual(Math.max(...xs) + 1e-3);
        expect(y).toBeGreaterThanOrEqual(Math.min(...ys) - 1e-3);
        expect(y).toBeLessThanOrEqual(Math.max(...ys) + 1e-3);
      }
      expect(outline.getAttribute('data-operation')).toBe(operation);
      const slopes = vertices(hatch).flatMap(([x, y], i, all) =>
        i % 2 ? [Math.sign((y - all[i - 1][1]) / (x - all[i - 1][0]))] : [],
      );
      return [...new Set(slopes)].sort();
    }),
  );
  expect(hatches).toEqual([[1], [-1, 1], [-1]]);
});

test('hostile names are shown as they are and change nothing', async () => {
  const name = '</title><script>alert(1)</script>&"\'\u0000\u0007\ud800 ok';
  const svg = drawn(await productOf({ name }, name));
  expect(svg.all('script')).toHaveLength(0);
  expect(svg.all('title')[0].text).toBe('</title><script>alert(1)</script>&"\' ok');
});

test('a name too long for its place is shortened, and whole in the title', async () => {
  const name = 'A very long name of a building with many words that no title block could hold. '
    .repeat(3)
    .trim();
  const svg = drawn(await productOf({}, name));
  expect(svg.byId('sheet-title')!.text).toMatch(/^A very long name /);
  expect(svg.all('text').filter(({ text }) => text.endsWith('…'))).toHaveLength(1);
  expect(svg.all('title')[0].text).toBe(name);
});
