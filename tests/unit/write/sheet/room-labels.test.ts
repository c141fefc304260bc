import fc from 'fast-check';
import { expect, test } from 'vitest';
import { type Bounds, boundsMeet, boundsOf } from '../../../../src/core/geometry/rings.ts';
import { type Affine, mapped } from '../../../../src/core/sheet.ts';
import { meetsEdges } from '../../../../src/write/sheet/clear-box.ts';
import { type PlacedLabel, placeLabels } from '../../../../src/write/sheet/room-labels.ts';
import { planOf, rectangle } from '../../solid/plans.ts';

/** 1:100, y down. */
const TO_SHEET: Affine = [10, 0, 0, -10, 30, 200];

function labelsOf(rooms: readonly { name: string; outer: Float64Array }[]): PlacedLabel[] {
  const { storeys } = planOf({
    storeys: [
      {
        rooms: rooms.map(({ name, outer }) => ({
          ...{ name, outline: { outer, holes: [] }, height: 2.5, confidence: 1 },
        })),
      },
    ],
  });
  const all = boundsOf(Float64Array.from(rooms.flatMap(({ outer }) => [...mapped(outer, TO_SHEET)])));
  return [...placeLabels({ storey: storeys[0], planToSheet: TO_SHEET, unit: 'm', extent: all }).labels];
}

const isLedOut = ({ items }: PlacedLabel) => items.some(({ kind }) => kind === 'path');

test('a label stands in its room: whole, small, turned, and led out where none of these fits', () => {
  const sizes = [
    [3, 3],
    [1.2, 0.85],
    [0.9, 2.4],
    [0.5, 0.5],
  ];
  const labels = labelsOf(
    sizes.map(([w, h], i) => ({ name: `Room ${i}`, outer: rectangle(4 * i, 0, w, h) })),
  );
  const looks = labels.map((label) => {
    const [text] = label.items.filter((item) => item.kind === 'text');
    return [text.size, text.isUpright ?? false, isLedOut(label)];
  });
  expect(looks).toEqual([
    ['room', false, false],
    ['label', false, false],
    ['label', true, false],
    ['label', false, true],
  ]);
});

test('where many names do not fit, their rooms bear numbers, and a key says what they are', () => {
  const storeys = (count: number) =>
    planOf({
      storeys: [
        {
          rooms: Array.from({ length: count }, (_, i) => ({
            ...{ name: i === 3 ? 'Bath' : `Room ${i + 1}`, height: 2.5, confidence: 1 },
            outline: { outer: i === 0 ? rectangle(-4, 0, 3, 3) : rectangle(0.8 * i, 0, 0.7, 0.7), holes: [] },
          })),
        },
      ],
    }).storeys;
  const place = (count: number) => {
    const [storey] = storeys(count);
    const extent = boundsOf(mapped(rectangle(-4, 0, 4 + 0.8 * count, 3), TO_SHEET));
    return placeLabels({ storey, planToSheet: TO_SHEET, unit: 'm', extent });
  };
  expect(place(7).key).toEqual([]);
  expect(place(7).labels.filter(isLedOut)).toHaveLength(6);
  const { labels, key } = place(8);
  expect(labels.filter(isLedOut)).toEqual([]);
  expect(key.map(({ number }) => number)).toEqual(['2', '3', '4', '5', '6', '7', '8']);
  expect(key[2].words).toBe('Bath, 0.49 m²');
  const texts = labels.flatMap(({ items }) => items.map((item) => item.kind === 'text' && item.text));
  for (const { number } of key) expect(texts).toContain(number);
});

test('no label leaves its room but by a line, and none lies on another', () => {
  const room = fc.record({
    width: fc.double({ min: 0.2, max: 6, noNaN: true }),
    depth: fc.double({ min: 0.2, max: 6, noNaN: true }),
  });
  fc.assert(
    fc.property(fc.array(room, { minLength: 1, maxLength: 12 }), (sizes) => {
      let x = 0;
      const rooms = sizes.map(({ width, depth }, i) => {
        const outer = rectangle(x, 0, width, depth);
        x += width + 0.1;
        return { name: `Room ${i + 1}`, outer };
      });
      const labels = labelsOf(rooms);
      expect(labels).toHaveLength(rooms.length);
      labels.forEach((label, i) => {
        for (const other of labels.slice(i + 1)) expect(boundsMeet(label.box, other.box)).toBe(false);
        if (isLedOut(label)) return;
        const { minX, minY, maxX, maxY } = boundsOf(mapped(rooms[i].outer, TO_SHEET));
        const { box } = label;
        expect(box.minX >= minX && box.minY >= minY && box.maxX <= maxX && box.maxY <= maxY).toBe(true);
      });
    }),
  );
});

test('a name that runs from right to left is set off where its area follows on its line', () => {
  const textsIn = (side: number) =>
    labelsOf([{ name: 'حمام', outer: rectangle(0, 0, side, side) }])[0].items.flatMap((item) =>
      item.kind === 'text' ? [item.text] : [],
    );
  expect(textsIn(0.4)).toEqual(['\u2068حمام\u2069, 0.16 m²']);
  expect(textsIn(4)).toEqual(['حمام', '16.0 m²']);
});

test('a room without area has no label', () => {
  expect(labelsOf([{ name: 'Nothing', outer: Float64Array.of(0, 0, 1, 0, 2, 0) }])).toEqual([]);
});

test('a name of ten thousand letters is cut, so that it stays on the sheet', () => {
  const [label] = labelsOf([{ name: 'x'.repeat(10_000), outer: rectangle(0, 0, 0.5, 0.5) }]);
  expect(isLedOut(label)).toBe(true);
  expect(label.box.maxX - label.box.minX).toBeLessThan(90);
});

test('control characters in a name are blanks: some canvases take none', () => {
  const [{ items }] = labelsOf([{ name: 'a\nb\u0000c', outer: rectangle(0, 0, 5, 4) }]);
  expect(items.map((item) => item.kind === 'text' && item.text)).toContain('a b c');
});

test('a label keeps off the edges of furniture, and stands on them only where nothing else is left', () => {
  const room = { name: 'Hall', outline: { outer: rectangle(0, 0, 5, 4), holes: [] } };
  const withTable = (table: Float64Array) => {
    const { storeys } = planOf({
      storeys: [
        {
          rooms: [{ ...room, height: 2.5, confidence: 1 }],
          furniture: [{ outline: { outer: table, holes: [] }, height: 0.7, confidence: 1, room: room.name }],
        },
      ],
    });
    const extent = boundsOf(mapped(room.outline.outer, TO_SHEET));
    const { labels } = placeLabels({ storey: storeys[0], planToSheet: TO_SHEET, unit: 'm', extent });
    const [label] = labels;
    return { label, meets: meetsEdges([mapped(table, TO_SHEET)], label.box) };
  };
  const beside = withTable(rectangle(2.2, 1.8, 0.5, 0.4));
  expect(beside.meets).toBe(false);
  expect(isLedOut(beside.label)).toBe(false);
  const everywhere = Array.from({ length: 40 }, (_, i) => [i / 8, (i % 2) * 4]).flat();
  expect(isLedOut(withTable(Float64Array.from(everywhere)).label)).toBe(false);
});

test('a name led out keeps off the chains of dimensions', () => {
  const rooms = [0, 1].map((i) => ({
    ...{ name: `Store ${i}`, outline: { outer: rectangle(i * 0.5, 0, 0.4, 0.4), holes: [] } },
    ...{ height: 2.5, confidence: 1 },
  }));
  const { storeys } = planOf({ storeys: [{ rooms }] });
  const extent = boundsOf(mapped(rectangle(0, 0, 0.9, 0.4), TO_SHEET));
  const place = (taken: readonly Bounds[]) =>
    placeLabels({ storey: storeys[0], planToSheet: TO_SHEET, unit: 'm', extent, taken }).labels;
  const chain = place([])[1].box;
  for (const { box } of place([chain])) expect(boundsMeet(box, chain)).toBe(false);
});
