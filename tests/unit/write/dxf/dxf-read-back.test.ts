import DxfParser, {
  type IDimensionEntity,
  type IDxf,
  type IEntity,
  type IInsertEntity,
  type ILwpolylineEntity,
  type IMtextEntity,
} from 'dxf-parser';
import { describe, expect, test } from 'vitest';
import { boundsOf, polygonArea, signedArea } from '../../../../src/core/geometry/rings.ts';
import type { Options } from '../../../../src/core/params.ts';
import type { FloorPlan, Storey } from '../../../../src/core/types.ts';
import { writeDxf } from '../../../../src/write/dxf/dxf.ts';
import { DXF_LAYERS } from '../../../../src/write/dxf/dxf-layers.ts';
import { disc, rectangle, reversed, rotated } from '../../solid/plans.ts';
import { productOf } from '../products.ts';
import { twoRooms } from './dxf-plans.ts';

/** What the file says, by a parser that is not ours. */
const FRAMES = {
  'near the origin': {},
  UTM: { planOrigin: [691_000.1234, 5_334_000.5678, 500], crs: 'EPSG:25832' },
  feet: { unit: 'ft', metresPerUnit: 0.3048, planOrigin: [2_000_000.5, 600_000.25, 0] },
  millimetres: { unit: 'mm', metresPerUnit: 0.001, planOrigin: [691_000_123.4, 5_334_000_456.7, 0] },
} as const satisfies Record<string, Partial<FloorPlan['frame']>>;

/** Written to 0.1 mm: half of that in either axis. */
const WRITTEN = 1e-4;

interface ReadBack {
  readonly dxf: IDxf;
  readonly plan: FloorPlan;
  /** Of one type on one layer. */
  all<T extends IEntity>(type: string, layer?: string): T[];
  /** A place of the drawing as plan metres. */
  metres(place: { readonly x: number; readonly y: number }): [number, number];
}

async function readBack(
  storey: Partial<Storey>,
  frame: Partial<FloorPlan['frame']> = {},
  choices: Partial<Options> = {},
): Promise<ReadBack> {
  const product = await productOf({ storeys: [storey], frame });
  const dxf = new DxfParser().parseSync(
    writeDxf({ ...product, options: { ...product.options, ...choices } }, 0),
  );
  if (dxf === null) throw new Error('no DXF');
  const { planOrigin, metresPerUnit } = product.plan.frame;
  return {
    dxf,
    plan: product.plan,
    all: <T extends IEntity>(type: string, layer?: string) =>
      dxf.entities.filter((each) => each.type === type && (layer ?? each.layer) === each.layer) as T[],
    metres: ({ x, y }) => [(x - planOrigin[0]) * metresPerUnit, (y - planOrigin[1]) * metresPerUnit],
  };
}

describe.each(Object.entries(FRAMES))('%s', (_name, frame) => {
  test('rooms come back to a tenth of a millimetre, with their areas', async () => {
    const { all, metres, plan } = await readBack(twoRooms(0.3), frame);
    const rooms = all<ILwpolylineEntity>('LWPOLYLINE', 'A-AREA');
    expect(rooms).toHaveLength(2);
    rooms.forEach(({ vertices, shape }, k) => {
      expect(shape).toBe(true);
      const { outer } = plan.storeys[0].rooms[k].outline;
      const xy = Float64Array.from(vertices.flatMap(metres));
      xy.forEach((value, i) => {
        expect(Math.abs(value - outer[i])).toBeLessThan(WRITTEN);
      });
      expect(signedArea(xy)).toBeCloseTo(signedArea(outer), 2);
    });
  });

  test('openings are blocks in the middle of their holes, as wide and as deep', async () => {
    const { all, dxf, metres, plan } = await readBack(twoRooms(0.3), frame);
    const inserts = all<IInsertEntity>('INSERT');
    const { openings } = plan.storeys[0];
    expect(inserts.map(({ name, layer }) => [name, layer])).toEqual([
      ['DOOR', 'A-DOOR'],
      ['WINDOW', 'A-GLAZ'],
      ['PASSAGE', 'A-WALL-HEAD'],
    ]);
    inserts.forEach(({ name, position, xScale, yScale, rotation }, i) => {
      const { from, to } = openings[i];
      const [x, y] = metres(position);
      expect(Math.hypot(x - (from[0] + to[0]) / 2, y - (from[1] + to[1]) / 2)).toBeLessThan(WRITTEN);
      const scale = plan.frame.metresPerUnit;
      expect(xScale * scale).toBeCloseTo(Math.hypot(to[0] - from[0], to[1] - from[1]), 4);
      expect(yScale * scale).toBeCloseTo(0.2, 4);
      const off = (rotation * Math.PI) / 180 - Math.atan2(to[1] - from[1], to[0] - from[0]);
      expect([Math.cos(off), Math.sin(off)]).toEqual([expect.closeTo(1, 8), expect.closeTo(0, 8)]);
      expect(dxf.blocks[name].entities!.some(({ type }) => type === 'ATTDEF')).toBe(true);
    });
  });

  test('dimensions measure what they stand between, in blocks of their own', async () => {
    const { all, dxf, plan } = await readBack(twoRooms(0.3), frame);
    const dimensions = all<IDimensionEntity>('DIMENSION', 'A-ANNO-DIMS');
    const scale = plan.frame.metresPerUnit;
    const lengths = dimensions.map(
      ({ block, linearOrAngularPoint1: a, linearOrAngularPoint2: b, angle, actualMeasurement }) => {
        const [cos, sin] = [Math.cos((angle * Math.PI) / 180), Math.sin((angle * Math.PI) / 180)];
        const along = Math.abs((b.x - a.x) * cos + (b.y - a.y) * sin) * scale;
        expect(Math.abs(along - Math.hypot(b.x - a.x, b.y - a.y) * scale)).toBeLessThan(1e-6);
        expect(Math.abs(actualMeasurement * scale - along)).toBeLessThan(2 * WRITTEN);
        const drawn = dxf.blocks[block].entities!.map(({ type }) => type).sort();
        // The line, two ticks, and around the plan two extension lines.
        expect([
          [...Array(5).fill('LINE'), 'MTEXT'],
          [...Array(3).fill('LINE'), 'MTEXT'],
        ]).toContainEqual(drawn);
        return along;
      },
    );
    // The whole, and the clear widths of both rooms.
    for (const wanted of [7.6, 3.4, 4, 3]) {
      expect(Math.min(...lengths.map((length) => Math.abs(length - wanted)))).toBeLessThan(3 * WRITTEN);
    }
    expect(new Set(dimensions.map(({ block }) => block)).size).toBe(dimensions.length);
  });
});

test('rooms are measured inside, chains around alone or nothing at all, as is asked for', async () => {
  const count = async (dimensions: Options['dimensions'], unit: Options['displayUnits'] = 'm') => {
    const { all } = await readBack(twoRooms(0.3), {}, { dimensions, displayUnits: unit });
    return all<IDimensionEntity>('DIMENSION').length;
  };
  expect(await count('none')).toBe(0);
  const outside = await count('outside');
  expect(outside).toBeGreaterThan(5);
  // Width and depth of two rooms.
  expect(await count('all')).toBe(outside + 4);
});

test('figures inside a room keep off its label and within its walls', async () => {
  const turn = 0.3;
  const { all, dxf, plan, metres } = await readBack(twoRooms(turn), FRAMES.UTM, { dimensions: 'all' });
  const rooms = plan.storeys[0].rooms.map(({ outline }) => boundsOf(rotated(outline.outer, -turn)));
  const inside = all<IDimensionEntity>('DIMENSION').filter(
    ({ block }) => dxf.blocks[block].entities!.filter(({ type }) => type === 'LINE').length === 3,
  );
  expect(inside).toHaveLength(4);
  for (const { linearOrAngularPoint1: a, linearOrAngularPoint2: b } of inside) {
    const ends = rotated(Float64Array.of(...metres(a), ...metres(b)), -turn);
    const [x, y] = [(ends[0] + ends[2]) / 2, (ends[1] + ends[3]) / 2];
    const room = rooms.find(({ minX, maxX, minY, maxY }) => x > minX && x < maxX && y > minY && y < maxY)!;
    const sizes = [room.maxX - room.minX, room.maxY - room.minY];
    const length = Math.hypot(ends[2] - ends[0], ends[3] - ends[1]);
    expect(Math.min(...sizes.map((size) => Math.abs(size - length)))).toBeLessThan(3 * WRITTEN);
  }
});

test('in feet and inches the figures and areas say so, whatever the unit of the drawing', async () => {
  const product = await productOf({ storeys: [twoRooms()], frame: FRAMES.millimetres });
  const text = writeDxf({ ...product, options: { ...product.options, displayUnits: 'ft' } }, 0);
  const lines = text.split(/\r?\n/).map((line) => line.trim());
  expect(lines).toContain(`24'-11 1/4"`);
  expect(lines.filter((line) => line.endsWith('ft2'))).toHaveLength(2);
  const style = lines.slice(lines.indexOf('PLAN'));
  const numberAt = (code: string) =>
    Number(style[style.findIndex((line, i) => line === code && i % 2 === 1) + 1]);
  expect(numberAt('144')).toBeCloseTo(1 / 25.4, 9);
  expect(numberAt('277')).toBe(4);
});

test('in a curved wall a block is as deep as the wall at the jambs', async () => {
  const ringWall = { outer: disc(0, 0, 4.3, 180), holes: [reversed(disc(0, 0, 4, 180))] };
  const reach = 0.15;
  const at = (angle: number) => [4.15 * Math.cos(angle), 4.15 * Math.sin(angle)] as const;
  const { all } = await readBack({
    walls: [{ outline: ringWall, thickness: 0.3, confidence: 1 }],
    openings: [{ type: 'window', from: at(-reach), to: at(reach), sill: 1, head: 2, confidence: 1 }],
  });
  const [{ position, yScale }] = all<IInsertEntity>('INSERT');
  // Square to the opening, not to the wall; as it bends it takes 0.05 m more.
  expect(yScale).toBeGreaterThan(0.3);
  expect(yScale).toBeLessThan(0.31);
  expect(position.x).toBeCloseTo(4.15 * Math.cos(reach), 2);
  expect(position.y).toBeCloseTo(0, 4);
});

test('walls are cut at openings, and filled', async () => {
  const { all, metres } = await readBack(twoRooms());
  const area = all<ILwpolylineEntity>('LWPOLYLINE', 'A-WALL').reduce(
    (sum, { vertices }) => sum + signedArea(Float64Array.from(vertices.flatMap(metres))),
    0,
  );
  const holes = 0.2 * (0.9 + 1.5 + 1.2);
  expect(area).toBeCloseTo(2 * 7.6 * 0.2 + 3 * 3 * 0.2 - holes, 3);
});

test('one text in each room, all of it within, however narrow the room and long the name', async () => {
  const storey = twoRooms(0, ['N'.repeat(10_000), '']);
  const corridor = {
    ...{ name: 'Corridor', height: 2.5, confidence: 1 },
    outline: { outer: rectangle(-1, 0, 0.5, 3), holes: [] },
  };
  const { all, metres } = await readBack({ ...storey, rooms: [...storey.rooms!, corridor] });
  const texts = all<IMtextEntity>('MTEXT', 'A-AREA-IDEN');
  expect(texts.map(({ text }) => text.replace(/N+/, 'N'))).toEqual([
    'N\\U+2026\\P12.00 m2',
    '9.00 m2',
    'Corridor\\P1.50 m2',
  ]);
  const boxes = [
    [0, 0, 4, 3],
    [4.2, 0, 7.2, 3],
    [-1, 0, -0.5, 3],
  ];
  texts.forEach(({ position, height, text, rotation }, k) => {
    const [minX, minY, maxX, maxY] = boxes[k];
    const lines = text.replace('\\U+2026', '.').split('\\P');
    const along = (0.55 * height * Math.max(...lines.map(({ length }) => length))) / 2;
    const across = (height * (1 + ((lines.length - 1) * 5) / 3)) / 2;
    const [halfX, halfY] = Math.abs(rotation - 90) < 1 ? [across, along] : [along, across];
    const [x, y] = metres(position);
    expect([x - halfX > minX, x + halfX < maxX, y - halfY > minY, y + halfY < maxY]).toEqual(
      Array(4).fill(true),
    );
    expect(height).toBeGreaterThan(0.04);
  });
});

test('what is no part of a room is on a layer of its own', async () => {
  const outline = { outer: rectangle(0, 0, 4, 3), holes: [reversed(rectangle(1, 1, 0.5, 0.5))] };
  const { all, metres } = await readBack({
    rooms: [{ name: 'Hall', outline, height: 2.5, confidence: 1 }],
  });
  const areas = (layer: string) =>
    all<ILwpolylineEntity>('LWPOLYLINE', layer).map(({ vertices }) =>
      Math.abs(signedArea(Float64Array.from(vertices.flatMap(metres)))),
    );
  expect(areas('A-AREA')[0] - areas('A-AREA-VOID')[0]).toBeCloseTo(polygonArea(outline), 6);
  expect(all<IMtextEntity>('MTEXT', 'A-AREA-IDEN')).toHaveLength(1);
});

test('local coordinates and the offset written beside the plan give the true ones', async () => {
  const choices = { dxfCoordinates: 'local' } as const;
  const truth = await readBack(twoRooms(), FRAMES.UTM);
  const local = await readBack(twoRooms(), FRAMES.UTM, choices);
  const [note] = local.all<IMtextEntity>('MTEXT', 'A-ANNO-TEXT');
  expect(note.text).toBe('Offset: add E 690999, N 5334000');
  const rooms = ({ all }: ReadBack) =>
    all<ILwpolylineEntity>('LWPOLYLINE', 'A-AREA').flatMap(({ vertices }) => vertices);
  rooms(local).forEach(({ x, y }, i) => {
    expect(Math.abs(x)).toBeLessThan(10);
    expect(x + 690_999).toBeCloseTo(rooms(truth)[i].x, 4);
    expect(y + 5_334_000).toBeCloseTo(rooms(truth)[i].y, 4);
  });
  expect(truth.all('MTEXT', 'A-ANNO-TEXT')).toEqual([]);
});

test.each(['ncs', 'iso13567'] as const)('every entity is on a layer of the standard %s', async (layers) => {
  const { dxf } = await readBack(twoRooms(), {}, { dxfLayers: layers });
  const names = Object.values(DXF_LAYERS).map((row) => row[layers]);
  expect(new Set(names).size).toBe(names.length);
  for (const { layer } of dxf.entities) expect(names).toContain(layer);
  const table = Object.keys(dxf.tables.layer.layers);
  for (const { layer } of dxf.entities) expect(table).toContain(layer);
});

test('names have the fields of their standard', () => {
  for (const { ncs, iso13567 } of Object.values(DXF_LAYERS)) {
    expect(ncs).toMatch(/^A-[A-Z]{4}(-[A-Z]{4})?$/);
    // Agent, element, presentation, status.
    expect(iso13567).toMatch(/^A-[A-Z-]{6}[EDTH]-E$/);
  }
});

test('structures are on the layer of their type', async () => {
  const secondary = (['column', 'shaft', 'other'] as const).map((type, i) => ({
    ...{ outline: { outer: rectangle(0.5 + i, 1, 0.4, 0.4), holes: [] }, type },
    ...{ operation: 'independent' as const, points: 9 },
  }));
  const { all } = await readBack({ secondary });
  for (const layer of ['A-COLS', 'A-FLOR-SHFT', 'A-FLOR-OTHR']) {
    expect(all('LWPOLYLINE', layer)).toHaveLength(1);
  }
});

describe('bad input', () => {
  test('the outline alone gives its area', async () => {
    const { all } = await readBack({ walls: [], rooms: [] });
    expect(all<IMtextEntity>('MTEXT', 'A-AREA-IDEN').map(({ text }) => text)).toEqual(['12.00 m2']);
    expect(all('LWPOLYLINE', 'A-FLOR-OTLN')).toHaveLength(1);
  });

  test('nothing at all gives an empty drawing', async () => {
    const product = await productOf();
    const [storey] = product.plan.storeys;
    const plan = { ...product.plan, storeys: [{ ...storey, primary: [], walls: [], rooms: [] }] };
    for (const dxfCoordinates of ['true', 'local'] as const) {
      const text = writeDxf({ ...product, plan, options: { ...product.options, dxfCoordinates } }, 0);
      expect(text).not.toMatch(/NaN|Infinity/);
      expect(new DxfParser().parseSync(text)!.entities.filter(({ type }) => type !== 'MTEXT')).toEqual([]);
    }
  });

  test('a room without area and an opening without width are left out', async () => {
    const flat = { outer: Float64Array.of(0, 0, 2, 0, 1, 0), holes: [] };
    const storey = twoRooms();
    const { all, dxf } = await readBack({
      ...storey,
      rooms: [...storey.rooms!, { name: 'Flat', outline: flat, height: 2.5, confidence: 1 }],
      openings: [{ ...storey.openings![0], to: storey.openings![0].from }],
    });
    expect(all('LWPOLYLINE', 'A-AREA')).toHaveLength(2);
    expect(all('MTEXT', 'A-AREA-IDEN')).toHaveLength(2);
    expect(all('INSERT')).toEqual([]);
    expect(JSON.stringify(dxf)).not.toMatch(/null|NaN/);
  });

  test('formats in names stay letters', async () => {
    const name = String.raw`{\C1;a} \P \U+0041 ^J 9%%%c`;
    const { all } = await readBack(twoRooms(0, [name, '<b>"&]]>😀שלום']));
    const [first, second] = all<IMtextEntity>('MTEXT', 'A-AREA-IDEN').map(({ text }) => text);
    expect(first).toMatch(/^\\\{\\\\C1;a\\\} \\\\P \\\\\\U\+0055\+0041 \^ J 9%\{\}%\{\}%c\\P12\.00 m2$/);
    expect(second).toMatch(/^<b>"&\]\]>\\U\+D83D\\U\+DE00(\\U\+05[0-9A-F]{2}){4}\\P9\.00 m2$/);
  });
});
