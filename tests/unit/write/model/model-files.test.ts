import { expect, test } from 'vitest';
import type { Solid } from '../../../../src/core/types.ts';
import { checkSolid } from '../../../../src/solid/check-solid.ts';
import { weld } from '../../../../src/solid/weld.ts';
import { modelParts } from '../../../../src/write/model/model-parts.ts';
import { writeObj } from '../../../../src/write/model/obj.ts';
import { writePly } from '../../../../src/write/model/ply.ts';
import { writeStl } from '../../../../src/write/model/stl.ts';
import type { Product } from '../../../../src/write/plan-writer.ts';
import { productOf } from '../products.ts';
import { FURNISHED, furnished, HOSTILE_NAME } from './model-plans.ts';

const UTM = {
  frame: {
    origin: [691_000.1234, 5_334_000.7654, 512.5],
    planOrigin: [691_000.1234, 5_334_000.7654, 512.5],
    crs: 'EPSG:25832',
  },
} as const;

const whole = (positions: Float64Array, indices: Uint32Array): Solid => ({
  positions,
  indices,
  groups: [{ name: 'wall-0', kind: 'wall', storey: 0, start: 0, count: indices.length }],
});

const volumeOf = (product: Product): number =>
  modelParts(product)
    .flatMap(({ surfaces }) => surfaces)
    .reduce((sum, { mesh }) => sum + checkSolid(whole(mesh.positions, mesh.indices)).volume, 0);

function readObj(text: string) {
  const vertices: number[] = [];
  const faces: number[] = [];
  const objects: string[] = [];
  for (const line of text.split('\n')) {
    const [key, ...values] = line.split(' ');
    if (key === 'v') vertices.push(...values.map(Number));
    if (key === 'f') faces.push(...values.map((value) => Number(value) - 1));
    if (key === 'o') objects.push(values.join(' '));
  }
  return { mesh: whole(Float64Array.from(vertices), Uint32Array.from(faces)), objects };
}

function readPly(bytes: Uint8Array<ArrayBuffer>) {
  const text = new TextDecoder('latin1').decode(bytes);
  const start = text.indexOf('end_header\n') + 'end_header\n'.length;
  const header = text.slice(0, start);
  const count = (name: string) => Number(new RegExp(`element ${name} (\\d+)`).exec(header)![1]);
  const view = new DataView(bytes.buffer, start);
  const positions = Float64Array.from({ length: 3 * count('vertex') }, (_, i) =>
    view.getFloat64(8 * i, true),
  );
  const faces = 8 * positions.length;
  const indices = Uint32Array.from({ length: 3 * count('face') }, (_, i) =>
    view.getInt32(faces + 17 * Math.floor(i / 3) + 1 + 4 * (i % 3), true),
  );
  expect(view.byteLength).toBe(faces + 17 * count('face'));
  return { header, mesh: whole(positions, indices) };
}

function readStl(bytes: Uint8Array<ArrayBuffer>) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const count = view.getUint32(80, true);
  expect(bytes.length).toBe(84 + 50 * count);
  const corners = Float64Array.from({ length: 9 * count }, (_, i) =>
    view.getFloat32(84 + 50 * Math.floor(i / 9) + 12 + 4 * (i % 9), true),
  );
  return { header: new TextDecoder().decode(bytes.subarray(0, 80)), corners };
}

test('every part is named by what it is, closed, and of a volume of its own', async () => {
  const parts = modelParts(await productOf(furnished()));
  expect(parts.map(({ name }) => name)).toEqual([
    ...['wall-0', 'floor-0', 'column-0', 'structure-0', 'column-1', 'door-0', 'window-0'],
  ]);
  for (const { surfaces } of parts) {
    for (const { mesh } of surfaces) {
      expect(checkSolid(whole(mesh.positions, mesh.indices))).toMatchObject({
        watertight: true,
        openEdges: 0,
      });
    }
  }
});

test('a door has a lining as deep as its wall, a window a frame and a pane in its middle', async () => {
  const [door, window] = modelParts(
    await productOf(furnished({ storeys: [{ ...FURNISHED, floor: 5 }] })),
  ).slice(-2);
  const measure = ({ surfaces }: typeof door) =>
    surfaces.map(({ mesh }) => checkSolid(whole(mesh.positions, mesh.indices)).volume);
  expect(measure(door)[0]).toBeCloseTo((0.9 * 2 - 0.8 * 1.95) * 0.2, 9);
  expect(measure(window)[0]).toBeCloseTo((1.2 * 1.1 - 1.1 * 1) * 0.07, 9);
  expect(measure(window)[1]).toBeCloseTo(1.1 * 1 * 0.024, 9);
  const span = (axis: number, { surfaces }: typeof door) => {
    const values = surfaces[0].mesh.positions.filter((_, i) => i % 3 === axis);
    return [Math.min(...values), Math.max(...values)];
  };
  const near = (values: number[]) => values.map((value) => expect.closeTo(value, 6));
  expect([0, 1, 2].map((axis) => span(axis, door))).toEqual([
    near([0.5, 1.4]),
    near([-0.2, 0]),
    near([5, 7]),
  ]);
  expect([0, 1, 2].map((axis) => span(axis, window))).toEqual([
    ...[near([2, 3.2]), near([-0.135, -0.065]), near([5.9, 7])],
  ]);
});

test('an opening too small for a frame, or off every wall, has none', async () => {
  const [door] = FURNISHED.openings!;
  const openings = [
    { ...door, to: [0.6, -0.1] as const },
    { ...door, from: [0.5, 1.5] as const, to: [1.4, 1.5] as const },
    { ...door, sill: 1.95 },
  ];
  const parts = modelParts(await productOf({ storeys: [{ openings }] }));
  expect(parts.map(({ name }) => name)).toEqual(['wall-0', 'floor-0']);
});

test('OBJ: an object a part, true source coordinates to 0.1 mm, the volume of the model', async () => {
  const product = await productOf(furnished(UTM));
  const [{ content }, materials] = writeObj(product);
  const { mesh, objects } = readObj(content as string);
  expect(objects).toEqual(modelParts(product).map(({ name }) => name));
  expect(mesh.positions[0] - 691_000.1234).toBeCloseTo(
    modelParts(product)[0].surfaces[0].mesh.positions[0],
    4,
  );
  expect(checkSolid(mesh)).toMatchObject({ watertight: true, volume: expect.closeTo(volumeOf(product), 3) });
  const used = new Set([...(content as string).matchAll(/^usemtl (.+)$/gm)].map(([, name]) => name));
  const defined = [...(materials.content as string).matchAll(/^newmtl (.+)$/gm)].map(([, name]) => name);
  expect(defined).toEqual([...used]);
});

test('PLY: doubles at true source coordinates, bit for bit', async () => {
  const product = await productOf(furnished(UTM));
  const { header, mesh } = readPly(writePly(product));
  expect(mesh.positions[1]).toBe(
    modelParts(product)[0].surfaces[0].mesh.positions[1] + UTM.frame.planOrigin[1],
  );
  expect(header).toContain('comment crs: EPSG:25832');
  expect(checkSolid(mesh)).toMatchObject({ watertight: true, volume: expect.closeTo(volumeOf(product), 3) });
});

test('a column cut out of the slabs goes through them, in the print too', async () => {
  const product = await productOf(furnished());
  const { floor, height } = product.plan.storeys[0];
  const column = modelParts(product).find(({ name }) => name === 'column-1')!.surfaces[0].mesh;
  const heights = column.positions.filter((_, i) => i % 3 === 2);
  const low = floor - product.plan.options.slabThickness;
  expect([Math.min(...heights), Math.max(...heights)]).toEqual([low, floor + height]);
  const { corners } = readStl(writeStl(product));
  const own = column.positions.map((value) => Math.fround(1000 * value));
  const has = (x: number) => corners.some((value, i) => i % 3 === 0 && value === x);
  expect(own.filter((_, i) => i % 3 === 0).every(has)).toBe(true);
});

test('STL: all but frames and panes in millimetres from the origin that the header names', async () => {
  const product = await productOf(furnished(UTM));
  const { header, corners } = readStl(writeStl(product));
  expect(header).toContain('mm, z up, from 691000.1234 5334000.7654 512.5 m');
  // Shells that stand on each other share places, so each is looked at by itself.
  for (const { start, count } of product.solid.groups) {
    const { positions, indices } = weld(corners.slice(3 * start, 3 * (start + count)), 1e-3);
    const { volume, watertight } = checkSolid(whole(positions, indices));
    expect(watertight).toBe(true);
    const own = product.solid.indices.subarray(start, start + count);
    expect(volume / 1e9).toBeCloseTo(checkSolid(whole(product.solid.positions, own)).volume, 5);
  }
});

test('a scan in feet is written in feet', async () => {
  const product = await productOf(furnished({ frame: { unit: 'ft', metresPerUnit: 0.3048 } }));
  const { mesh } = readObj(writeObj(product)[0].content as string);
  expect(checkSolid(mesh).volume * 0.3048 ** 3).toBeCloseTo(volumeOf(product), 3);
  expect(writeObj(product)[0].content).toContain('# unit: ft (1 = 0.3048 m)');
});

test('no name of a scan or room breaks out of its comment', async () => {
  const product = await productOf(furnished(), HOSTILE_NAME);
  const plain = await productOf(furnished());
  const text = writeObj(product)[0].content as string;
  expect(readObj(text).mesh).toEqual(readObj(writeObj(plain)[0].content as string).mesh);
  expect(Math.max(...text.split('\n').map((line) => line.length))).toBeLessThan(400);
  const { header, mesh } = readPly(writePly(product));
  expect(mesh).toEqual(readPly(writePly(plain)).mesh);
  expect(header).toMatch(/^[\n -~]*$/);
  expect(header.match(/end_header/g)).toHaveLength(1);
  expect(writeStl(product)).toEqual(writeStl(plain));
});

test('an empty model is an empty file of each format', async () => {
  const solid: Solid = { positions: new Float64Array(0), indices: new Uint32Array(0), groups: [] };
  const product = { ...(await productOf()), solid };
  expect(readObj(writeObj(product)[0].content as string).objects).toEqual([]);
  expect(readPly(writePly(product)).mesh.indices).toHaveLength(0);
  expect(readStl(writeStl(product)).corners).toHaveLength(0);
});
