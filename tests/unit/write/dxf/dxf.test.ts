import { expect, test } from 'vitest';
import { writeDxf } from '../../../../src/write/dxf/dxf.ts';
import { type PlanFacts, rectangle } from '../../solid/plans.ts';
import { home, productOf } from '../products.ts';
import { twoRooms } from './dxf-plans.ts';

/** Group codes and values, read by the rules of the format and nothing of our writer. */
function tagsOf(text: string): [number, string][] {
  const lines = text.split('\n');
  expect(lines.pop()).toBe('');
  expect(lines.length % 2).toBe(0);
  return Array.from({ length: lines.length / 2 }, (_, i) => {
    expect(lines[2 * i]).toMatch(/^ {0,2}\d{1,4}$/);
    return [Number(lines[2 * i]), lines[2 * i + 1]];
  });
}

interface Polyline {
  readonly layer: string;
  readonly isClosed: boolean;
  readonly announced: number;
  readonly places: [number, number][];
}

function sectionOf(tags: [number, string][], name: string): [number, string][] {
  const begin = tags.findIndex(
    ([code, value], i) => code === 2 && value === name && tags[i - 1][1] === 'SECTION',
  );
  const end = tags.findIndex(([code, value], i) => i > begin && code === 0 && value === 'ENDSEC');
  return tags.slice(begin + 1, end);
}

function polylinesOf(tags: [number, string][]): Polyline[] {
  const polylines: Polyline[] = [];
  const entities = sectionOf(tags, 'ENTITIES');
  entities.forEach(([code, value], begin) => {
    if (code !== 0 || value !== 'LWPOLYLINE') return;
    const rest = entities.slice(begin + 1);
    const end = rest.findIndex(([next]) => next === 0);
    const own = end < 0 ? rest : rest.slice(0, end);
    const of = (wanted: number) => own.filter(([each]) => each === wanted).map(([, each]) => each);
    const [xs, ys] = [of(10).map(Number), of(20).map(Number)];
    polylines.push({
      layer: of(8)[0],
      isClosed: of(70)[0] === '1',
      announced: Number(of(90)[0]),
      places: xs.map((x, i) => [x, ys[i]]),
    });
    expect(Number(of(38)[0])).toBe(0);
  });
  return polylines;
}

const written = async (facts: PlanFacts) => tagsOf(writeDxf(await productOf(facts), 0));
const header = (tags: [number, string][], name: string): string =>
  tags[tags.findIndex(([code, value]) => code === 9 && value === name) + 1][1];

test('the sections of an AutoCAD 2000 file, in order', async () => {
  const tags = await written({});
  const sections = tags
    .filter(([code], i) => code === 2 && tags[i - 1][1] === 'SECTION')
    .map(([, name]) => name);
  expect(sections).toEqual(['HEADER', 'CLASSES', 'TABLES', 'BLOCKS', 'ENTITIES', 'OBJECTS']);
  expect(header(tags, '$ACADVER')).toBe('AC1015');
  expect(tags.at(-1)).toEqual([0, 'EOF']);
});

test('rings are closed polylines on the layer of their kind', async () => {
  const polylines = polylinesOf(await written(home()));
  expect(polylines.map(({ layer, isClosed }) => [layer, isClosed])).toEqual([
    ['A-FLOR-OTLN', true],
    // The wall is a ring no more where the gap is.
    ['A-WALL', true],
    ['A-WALL-HIDD', true],
    ['A-COLS', true],
    ['A-COLS', true],
    ['A-COLS', true],
  ]);
  for (const { announced, places } of polylines) expect(places).toHaveLength(announced);
});

test('a gap that no wall stands along is a line', async () => {
  const storey = { walls: [], gaps: [{ from: [1, 0], to: [2, 0], width: 1 } as const] };
  const entities = sectionOf(await written({ storeys: [storey] }), 'ENTITIES');
  const line = entities.findIndex(([code, value]) => code === 0 && value === 'LINE');
  expect(entities.slice(line).find(([code]) => code === 8)).toEqual([8, 'A-WALL-HIDD']);
  const coordinates = entities.slice(line).filter(([code]) => [10, 20, 11, 21].includes(code));
  expect(coordinates.slice(0, 4).map(([, value]) => Number(value))).toEqual([1, 0, 2, 0]);
});

test('every layer used is in the table', async () => {
  const tags = await written(home());
  const tables = sectionOf(tags, 'TABLES');
  const layers = tables
    .filter(([code], i) => code === 2 && tables[i - 1]?.[1] === 'AcDbLayerTableRecord')
    .map(([, name]) => name);
  for (const { layer } of polylinesOf(tags)) expect(layers).toContain(layer);
});

test("coordinates are the scan's own, in its unit", async () => {
  const frame = {
    unit: 'mm',
    metresPerUnit: 0.001,
    planOrigin: [691_000_123.4, 5_334_000_456.7, 0],
  } as const;
  const tags = await written({ frame });
  const [outline] = polylinesOf(tags);
  expect(outline.places[2]).toEqual([691_004_123.4, 5_334_003_456.7]);
  // Two chains of dimensions are left of the walls, and text on the outer one.
  expect(Number(header(tags, '$EXTMIN'))).toBeLessThan(690_999_923.4 - 1000);
  expect(Number(header(tags, '$EXTMIN'))).toBeGreaterThan(690_999_923.4 - 3000);
});

test.each([
  ['m', 6, 1],
  ['cm', 5, 1],
  ['mm', 4, 1],
  ['ft', 2, 0],
  ['us-ft', 21, 0],
  ['px', 0, 1],
] as const)('the unit %s is announced', async (unit, insert, measurement) => {
  const tags = await written({ frame: { unit } });
  expect([Number(header(tags, '$INSUNITS')), Number(header(tags, '$MEASUREMENT'))]).toEqual([
    insert,
    measurement,
  ]);
});

test('handles are unique, and the seed is above them all', async () => {
  const tags = await written(home());
  const seed = Number.parseInt(header(tags, '$HANDSEED'), 16);
  const seedAt = tags.findIndex(([, value]) => value === '$HANDSEED') + 1;
  const handles = tags
    .filter(([code], i) => (code === 5 && i !== seedAt) || code === 105)
    .map(([, value]) => value);
  expect(new Set(handles).size).toBe(handles.length);
  expect(Math.max(...handles.map((handle) => Number.parseInt(handle, 16)))).toBeLessThan(seed);
});

test('hostile names stay one line of ASCII', async () => {
  const name = 'Küche\n  0\nSECTION\n^J𝄞';
  const rooms = [{ name, outline: { outer: rectangle(0, 0, 4, 3), holes: [] }, height: 2.5, confidence: 1 }];
  const text = writeDxf(await productOf({ storeys: [{ rooms }] }), 0);
  expect(text).toContain('\nK\\U+00FCche   0 SECTION ^ J\\U+D834\\U+DD1E\\P12.00 m2\n');
  // biome-ignore lint/suspicious/noControlCharactersInRegex: the point of the test
  expect(text).toMatch(/^[\x0a\x20-\x7e]*$/);
  expect(tagsOf(text).filter(([code, value]) => code === 0 && value === 'SECTION')).toHaveLength(6);
});

test('the extent holds all that is drawn', async () => {
  const tags = await written({ storeys: [twoRooms(0.3)] });
  const at = (name: string) => {
    const i = tags.findIndex(([code, value]) => code === 9 && value === name);
    return [Number(tags[i + 1][1]), Number(tags[i + 2][1])];
  };
  const [min, max] = [at('$EXTMIN'), at('$EXTMAX')];
  const blocks = sectionOf(tags, 'BLOCKS');
  const ofDimensions = blocks.slice(
    blocks.findIndex(([code, value]) => code === 2 && value.startsWith('*D')),
  );
  let count = 0;
  for (const [code, value] of [...sectionOf(tags, 'ENTITIES'), ...ofDimensions]) {
    const axis = [10, 11, 13, 14].includes(code) ? 0 : [20, 21, 23, 24].includes(code) ? 1 : -1;
    // Hatches and blocks have their own zero.
    if (axis < 0 || Number(value) === 0) continue;
    count++;
    expect(Number(value)).toBeGreaterThanOrEqual(min[axis]);
    expect(Number(value)).toBeLessThanOrEqual(max[axis]);
  }
  expect(count).toBeGreaterThan(100);
});
