import { expect, test } from 'vitest';
import { inverse, type LayerName, mapped, type Sheet, type SheetItem } from '../../../../src/core/sheet.ts';
import type { Ring } from '../../../../src/core/types.ts';
import { frameFacts } from '../../../../src/write/drawing/frame-json.ts';
import { drawSheet } from '../../../../src/write/sheet/draw-sheet.ts';
import { disc, planOf, rectangle, ring, wallAround } from '../../solid/plans.ts';
import { home, productOf } from '../products.ts';

const layer = (sheet: Sheet, name: LayerName): readonly SheetItem[] =>
  sheet.layers.find((each) => each.name === name)!.items;
const texts = (items: readonly SheetItem[]): string[] =>
  items.flatMap((item) => (item.kind === 'text' ? [item.text] : []));

async function sheetOf(inner: Ring, thickness = 0.2): Promise<Sheet> {
  const walls = [{ outline: wallAround(inner, thickness), thickness, confidence: 1 }];
  return drawSheet(await productOf({ storeys: [{ primary: [{ outer: inner, holes: [] }], walls }] }), 0);
}

test.each([
  ['a cupboard', rectangle(0, 0, 1.6, 1.2), 20, 'A4'],
  ['a room', rectangle(0, 0, 4, 3), 50, 'A4'],
  ['a home', rectangle(0, 0, 11, 8), 100, 'A4'],
  ['a house', rectangle(0, 0, 18, 14), 100, 'A3'],
  ['a tall house', rectangle(0, 0, 9, 17), 100, 'A4'],
  ['an office', rectangle(0, 0, 45, 30), 200, 'A3'],
  ['a hall', rectangle(0, 0, 120, 80), 500, 'A3'],
  ['a factory', rectangle(0, 0, 400, 250), 500, 'A0'],
  ['a campus', rectangle(0, 0, 1500, 900), 2000, 'A1'],
  ['a town', rectangle(0, 0, 6000, 3000), 10_000, 'A1'],
])('%s gets a fitting scale and paper', async (_, inner, scale, paper) => {
  const sheet = await sheetOf(inner);
  expect([sheet.scale, sheet.paper.name]).toEqual([scale, paper]);
});

test('a deep plan is drawn on paper standing upright', async () => {
  const { paper } = await sheetOf(rectangle(0, 0, 9, 17));
  expect(paper.height).toBeGreaterThan(paper.width);
});

/** A rectangle of w × h metres turned about the origin. */
function slanted(width: number, height: number, degrees: number): Ring {
  const [cos, sin] = [Math.cos((degrees * Math.PI) / 180), Math.sin((degrees * Math.PI) / 180)];
  const corners = [0, 0, width, 0, width, height, 0, height];
  return Float64Array.from(corners, (value, i) =>
    i % 2 === 0 ? cos * value - sin * corners[i + 1] : sin * corners[i - 1] + cos * value,
  );
}

test.each([17, -31, 44])(
  'a plan slanted by %i° stands square and is measured along its walls',
  async (by) => {
    const straight = await sheetOf(rectangle(0, 0, 11, 8));
    const sheet = await sheetOf(slanted(11, 8, by));
    expect(texts(layer(sheet, 'dimensions')).sort()).toEqual(texts(layer(straight, 'dimensions')).sort());
    expect([sheet.scale, sheet.paper]).toEqual([straight.scale, straight.paper]);
    const [a, b] = sheet.planToSheet;
    expect((Math.atan2(b, a) * 180) / Math.PI).toBeCloseTo(by, 6);
    expect(texts(layer(sheet, 'title')).join()).toContain(`turned by ${Math.abs(by)}.0°`);
    const { sheetToSource } = frameFacts((await productOf()).plan, sheet).sheet;
    const there = mapped(Float64Array.of(3, 4), sheet.planToSheet);
    const back = mapped(there, sheetToSource);
    expect([back[0], back[1]]).toEqual([expect.closeTo(3, 9), expect.closeTo(4, 9)]);
  },
);

test('a straight plan and a round one keep the axes of the scan', async () => {
  for (const inner of [rectangle(0, 0, 11, 8), slanted(11, 8, 0.1), disc(0, 0, 9, 60)]) {
    const [a, b, c, d] = (await sheetOf(inner)).planToSheet;
    expect([b, c]).toEqual([0, 0]);
    expect(d).toBe(-a);
  }
});

test('nothing leaves the sheet or runs into the title block', async () => {
  for (const inner of [
    rectangle(0, 0, 4, 3),
    rectangle(-40, 7, 30, 2),
    rectangle(3, 3, 2, 14),
    disc(0, 0, 9, 60),
    slanted(12, 5, 30),
  ]) {
    const sheet = await sheetOf(inner);
    const { width, height } = sheet.paper;
    for (const { name, items } of sheet.layers) {
      const lowest = name === 'title' ? height : height - 40;
      for (const item of items) {
        const xy =
          item.kind === 'path'
            ? item.lines.flatMap((line) => [...line])
            : item.kind === 'text'
              ? [item.x, item.y]
              : [];
        xy.forEach((value, i) => {
          expect(value).toBeGreaterThan(0);
          expect(value).toBeLessThan(i % 2 === 0 ? width : lowest);
        });
      }
    }
  }
});

test('width and depth are measured over the walls, to the centimetre', async () => {
  const sheet = await sheetOf(rectangle(0, 0, 4.123, 3));
  expect(texts(layer(sheet, 'dimensions'))).toEqual(['4.52', '3.40']);
});

test('steps of the outline get a chain on the side they are seen from', async () => {
  const sheet = drawSheet(await productOf(home()), 0);
  expect(texts(layer(sheet, 'dimensions'))).toEqual(['12.00', '7.00', '5.00', '9.00', '5.40', '3.60']);
});

test('a round outline has no steps', async () => {
  const sheet = await sheetOf(disc(0, 0, 9, 90), 0.3);
  expect(texts(layer(sheet, 'dimensions'))).toHaveLength(2);
});

test('the area stands inside the room, rooms with their names', async () => {
  const corner = ring(0, 0, 9, 0, 9, 1.2, 1.2, 1.2, 1.2, 9, 0, 9);
  const unnamed = await sheetOf(corner);
  expect(texts(layer(unnamed, 'labels'))).toEqual(['20.2 m²']);
  const rooms = [
    { name: 'Kitchen', outline: { outer: rectangle(0, 0, 4, 3), holes: [] }, height: 2.5, confidence: 1 },
  ];
  const named = drawSheet(await productOf({ storeys: [{ rooms }] }), 0);
  expect(texts(layer(named, 'labels'))).toEqual(['Kitchen', '12.0 m²']);
  const [label] = layer(named, 'labels');
  const [k, , , , e] = named.planToSheet;
  expect(label.kind === 'text' && (label.x - e) / k).toBeCloseTo(2, 1);
});

test('the legend names what is drawn and nothing else', async () => {
  const plain = texts(layer(await sheetOf(rectangle(0, 0, 4, 3)), 'title'));
  expect(plain).toContain('Wall');
  expect(plain.filter((text) => /Structure|Inferred/.test(text))).toEqual([]);
  const full = texts(layer(drawSheet(await productOf(home()), 0), 'title'));
  expect(full.filter((text) => /Structure|Inferred/.test(text))).toHaveLength(4);
});

test('points are drawn when asked for', async () => {
  const product = await productOf();
  expect(layer(drawSheet(product, 0), 'points')).toEqual([]);
  const [points] = layer(
    drawSheet({ ...product, options: { ...product.options, drawPoints: true } }, 0),
    'points',
  );
  expect(points.kind === 'points' && points.xy.length).toBe(product.slice.xy.length);
});

test('a storey without anything is still a sheet', async () => {
  const product = { ...(await productOf()), plan: planOf({ storeys: [{ primary: [], walls: [] }] }) };
  const sheet = drawSheet(product, 0);
  expect(sheet.planToSheet.every(Number.isFinite)).toBe(true);
});

test('a door interrupts the wall: both jambs and the leaf in thin lines, and the legend says what is not known', async () => {
  const openings = [
    { type: 'door', from: [1, -0.1], to: [1.9, -0.1], sill: 0, head: 2, confidence: 1 } as const,
    { type: 'door', from: [1, 3.1], to: [2.5, 3.1], sill: 0, head: 2, confidence: 1 } as const,
  ];
  const gaps = [{ from: [0.9, 3], to: [2.6, 3], width: 1.7 } as const];
  const sheet = drawSheet(await productOf({ storeys: [{ openings, gaps }] }), 0);
  const walls = layer(sheet, 'walls');
  expect(walls).toHaveLength(2);
  const doors = layer(sheet, 'openings');
  expect(doors.map((item) => item.kind === 'path' && item.data)).toEqual([
    { kind: 'door', opening: 0, from: '1 -0.1', to: '1.9 -0.1' },
    { kind: 'door', opening: 1, from: '1 3.1', to: '2.5 3.1' },
  ]);
  const back = inverse(sheet.planToSheet);
  const [first] = doors.map((item) => (item.kind === 'path' ? item.lines : []));
  const lines = first.map((line) =>
    [...mapped(line, back)].map((value) => Math.round(value * 1e4) / 1e4 + 0),
  );
  expect(lines).toEqual([
    [1, -0.2, 1, 0],
    [1.9, -0.2, 1.9, 0],
    [1, -0.1, 1.9, -0.1],
  ]);
  // What the door leaves of a bridged gap stays inferred, and says which gap it is of.
  const left = layer(sheet, 'gaps').map((item) => item.kind === 'path' && item.data);
  expect(left).toEqual([
    { kind: 'gap', gap: 0, from: '0.9 3', to: '2.6 3' },
    { kind: 'gap', gap: 0, from: '0.9 3', to: '2.6 3' },
  ]);
  expect(texts(layer(sheet, 'title'))).toContain('Door, hinge unknown');
  expect(texts(layer(drawSheet(await productOf(), 0), 'title'))).not.toContain('Door, hinge unknown');
});

test('a window has a line on either face and one between, a passage dashed lines on the faces', async () => {
  const openings = [
    { type: 'window', from: [1, -0.1], to: [1.9, -0.1], sill: 0.9, head: 2, confidence: 1 } as const,
    { type: 'passage', from: [1, 3.1], to: [2.5, 3.1], sill: 0, head: 2.4, confidence: 1 } as const,
  ];
  const sheet = drawSheet(await productOf({ storeys: [{ openings }] }), 0);
  const back = inverse(sheet.planToSheet);
  const drawn = layer(sheet, 'openings').flatMap((item) =>
    item.kind === 'path'
      ? item.lines.map((line) => ({
          style: item.style,
          line: [...mapped(line, back)].map((value) => Math.round(value * 1e4) / 1e4 + 0),
        }))
      : [],
  );
  expect(drawn).toEqual([
    { style: 'opening', line: [1, -0.2, 1, 0] },
    { style: 'opening', line: [1.9, -0.2, 1.9, 0] },
    { style: 'opening', line: [1, -0.2, 1.9, -0.2] },
    { style: 'opening', line: [1, -0.1, 1.9, -0.1] },
    { style: 'opening', line: [1, 0, 1.9, 0] },
    { style: 'opening', line: [1, 3, 1, 3.2] },
    { style: 'opening', line: [2.5, 3, 2.5, 3.2] },
    { style: 'passage', line: [1, 3, 2.5, 3] },
    { style: 'passage', line: [1, 3.2, 2.5, 3.2] },
  ]);
  expect(texts(layer(sheet, 'title'))).toEqual(expect.arrayContaining(['Window', 'Passage']));
});
