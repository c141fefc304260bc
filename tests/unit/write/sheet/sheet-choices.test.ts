import { expect, test } from 'vitest';
import type { GivenValues } from '../../../../src/core/params.ts';
import type { LayerName, Sheet } from '../../../../src/core/sheet.ts';
import type { Warning } from '../../../../src/core/types.ts';
import { drawSheet } from '../../../../src/write/sheet/draw-sheet.ts';
import { type PlanFacts, rectangle, secondary, wallAround } from '../../solid/plans.ts';
import { home, productOf } from '../products.ts';

async function drawn(
  given: GivenValues,
  facts: PlanFacts = home(),
  warnings: Warning[] = [],
): Promise<Sheet> {
  const product = await productOf(facts);
  const options = { ...product.options, ...given } as typeof product.options;
  return drawSheet({ ...product, options }, 0, (warning) => warnings.push(warning));
}

const texts = (sheet: Sheet, name: LayerName): string[] =>
  sheet.layers
    .find((layer) => layer.name === name)!
    .items.flatMap((item) => (item.kind === 'text' ? [item.text] : []));

/** Two rooms of 3 m and 5 m by 4 m, a wall of 20 cm between, a window to the south and a door in between. */
function twoRooms(): PlanFacts {
  const whole = rectangle(0, 0, 8.2, 4);
  const outline = (x: number, width: number) => ({ outer: rectangle(x, 0, width, 4), holes: [] });
  const facts = { height: 2.5, confidence: 1 };
  return {
    storeys: [
      {
        primary: [{ outer: whole, holes: [] }],
        walls: [
          { outline: wallAround(whole, 0.3), thickness: 0.3, confidence: 1 },
          { outline: { outer: rectangle(3, 0, 0.2, 4), holes: [] }, thickness: 0.2, confidence: 1 },
        ],
        rooms: [
          { name: 'Room 1', outline: outline(0, 3), ...facts },
          { name: 'Room 2', outline: outline(3.2, 5), ...facts },
        ],
        openings: [
          { type: 'window', from: [5, -0.15], to: [6.2, -0.15], sill: 0.9, head: 2.1, confidence: 1 },
          { type: 'door', from: [3.1, 1], to: [3.1, 1.9], sill: 0, head: 2, confidence: 1 },
        ],
      },
    ],
  };
}

test('outside are measured the openings, then rooms and walls, then the whole; inside the width and depth of rooms', async () => {
  const sheet = await drawn({}, twoRooms());
  expect(texts(sheet, 'dimensions')).toEqual([
    ...['5.30', '1.20', '2.30'],
    ...['0.30', '3.00', '0.20', '5.00', '0.30', '8.80'],
    // Above there are no openings; at the left and right the rooms only.
    ...['0.30', '3.00', '0.20', '5.00', '0.30'],
    ...['0.30', '4.00', '0.30', '4.60'],
    ...['0.30', '4.00', '0.30'],
    ...['3.00', '4.00', '5.00', '4.00'],
  ]);
  expect(texts(await drawn({ dimensions: 'outside' }, twoRooms()), 'dimensions')).toHaveLength(21);
  expect(texts(await drawn({ dimensions: 'none' }, twoRooms()), 'dimensions')).toEqual([]);
});

test('feet and inches in dimensions, areas, title and scale bar', async () => {
  const sheet = await drawn({ displayUnits: 'ft' }, twoRooms());
  expect(texts(sheet, 'dimensions')).toContain(`28'-10 1/2"`);
  expect(texts(sheet, 'labels')).toEqual(['Room 1', '129 ft²', 'Room 2', '215 ft²']);
  const title = texts(sheet, 'title').join('|');
  expect(title).toMatch(/\d ft\|/);
  expect(title).toContain('feet and inches');
  expect(title).not.toMatch(/\bm²|\d m\b/);
});

test('paper and scale are as asked', async () => {
  const sheet = await drawn({ paperSize: 'A1', sheetScale: '1:50' });
  expect([sheet.paper.name, sheet.scale]).toEqual(['A1', 50]);
  expect((await drawn({ paperSize: 'A0' })).scale).toBe(20);
  expect((await drawn({ sheetScale: '1:20' })).paper.name).toBe('A1');
});

test('a scale that does not fit the paper gives way to the next that does, and says so', async () => {
  const warnings: Warning[] = [];
  const sheet = await drawn({ paperSize: 'A4', sheetScale: '1:20' }, home(), warnings);
  expect([sheet.paper.name, sheet.scale]).toEqual(['A4', 100]);
  expect(warnings.map(({ code }) => code)).toEqual(['sheet/scale-too-large']);
  expect(warnings[0].message).toContain('1:20');
  await drawn({ sheetScale: '1:100' }, home(), warnings);
  expect(warnings).toHaveLength(1);
});

test('project and date stand in the title block', async () => {
  const sheet = await drawn({ project: 'Town hall', sheetDate: '2 May 2026' });
  expect(sheet.title).toBe('Town hall');
  expect(texts(sheet, 'title')).toContain('Floor plan, 2 May 2026');
});

test('a long title takes two rows; what they do not hold is cut, and said so', async () => {
  const [building, warnings]: [string, Warning[]] = ['Extension of the administration building, ', []];
  const sheet = await drawn({ project: `${building}north wing` }, home(), warnings);
  expect(texts(sheet, 'title').join(' ')).toContain(`${building}north wing Floor plan`);
  expect(warnings).toEqual([]);
  await drawn({ project: building.repeat(4) }, home(), warnings);
  expect(warnings.map(({ code }) => code)).toEqual(['sheet/name-cut']);
});

test('the arrow shows north where it is told or the coordinate system is known, else the y axis', async () => {
  const letter = (sheet: Sheet) =>
    texts(sheet, 'title').filter((text) => text.length === 1 && /\D/.test(text));
  expect(letter(await drawn({}))).toEqual(['y']);
  expect(letter(await drawn({}, { ...home(), frame: { crs: 'EPSG:25832' } }))).toEqual(['N']);
  const turned = await drawn({ north: 90 });
  expect(letter(turned)).toEqual(['N']);
  const [tip] = turned.layers
    .find(({ name }) => name === 'title')!
    .items.flatMap((item) =>
      item.kind === 'path' && item.style === 'rule' && item.id === 'heading' ? item.lines : [],
    );
  // Clockwise by a quarter: to the right.
  expect(tip[2] - tip[0]).toBeCloseTo(9, 6);
  expect(tip[3] - tip[1]).toBeCloseTo(0, 6);
});

test('a structure in the middle of a room keeps its label and the lines off', async () => {
  const facts = twoRooms();
  const [storey] = facts.storeys!;
  const column = secondary(rectangle(5.4, 1.7, 0.6, 0.6), 'subtract');
  const sheet = await drawn({}, { storeys: [{ ...storey, secondary: [column] }] });
  const [k, , , d, e, f] = sheet.planToSheet;
  const label = sheet.layers
    .find(({ name }) => name === 'labels')!
    .items.find((item) => item.kind === 'text' && item.text === 'Room 2')!;
  const { x, y } = label as { x: number; y: number };
  const [planX, planY] = [(x - e) / k, (y - f) / d];
  const isBeside = planX < 5.4 || planX > 6 || planY < 1.7 || planY > 2.3;
  expect(isBeside).toBe(true);
});

test('the title block tells how much of the walls no point shows', async () => {
  const titleOf = (sheet: Sheet) => texts(sheet, 'title').join('|');
  expect(titleOf(await drawn({}))).toMatch(/point cloud; 3 % inferred, dashed/);
  const [storey] = home().storeys!;
  const seen = await drawn({}, { ...home(), storeys: [{ ...storey, gaps: [] }] });
  expect(titleOf(seen)).toMatch(/Approximate: from a point cloud(\||$)/);
});
