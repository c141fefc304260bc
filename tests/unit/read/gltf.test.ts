import { readFileSync } from 'node:fs';
import { describe, expect, it } from 'vitest';
import { openScan } from '../../../src/read/open-scan.ts';
import { glbBytes, layOut } from './glb-bytes.ts';
import { bytesOf, memorySource, readAll } from './memory-source.ts';

const FLOAT = 5126;
/** A triangle with legs of 2 and 1. */
const CORNERS = [0, 0, 0, 2, 0, 0, 0, 0, 1];
const positions = { bufferView: 0, componentType: FLOAT, count: 3, type: 'VEC3' };
const layout = layOut([Float32Array.from(CORNERS)]);
const MODEL = {
  asset: { version: '2.0' },
  scene: 0,
  scenes: [{ nodes: [0] }],
  nodes: [{ mesh: 0 }] as object[],
  meshes: [{ primitives: [{ attributes: { POSITION: 0 } }] as object[] }],
  accessors: [positions] as object[],
  bufferViews: layout.bufferViews as object[],
  buffers: layout.buffers as object[],
};

async function open(json: unknown, data: Uint8Array = layout.data, pieces?: number[]) {
  return openScan([memorySource(glbBytes(json, data), 'a.glb', pieces)]);
}

/** Area by the number of points, 200,000 rough ones in all, and the box around them. */
async function read(json: unknown, data: Uint8Array = layout.data, pieces?: number[]) {
  const { xyz, colour } = await readAll(memorySource(glbBytes(json, data), 'a.glb', pieces));
  const axis = (k: number) => xyz.map((point) => point[k]);
  const bounds = [0, 1, 2].map((k) => [
    axis(k).reduce((a, b) => Math.min(a, b)),
    axis(k).reduce((a, b) => Math.max(a, b)),
  ]);
  return { xyz, colour, bounds };
}

function expectBox(bounds: number[][], expected: number[][]) {
  bounds.forEach(([low, high], axis) => {
    // Samples come within two steps of the corners.
    expect(Math.abs(low - expected[axis][0])).toBeLessThan(0.03);
    expect(Math.abs(high - expected[axis][1])).toBeLessThan(0.03);
  });
}

describe('glTF', () => {
  it('is in metres, and needs the spacing', async () => {
    const { format, cloud } = await open(MODEL);
    expect({ format, unit: cloud.unit, isAdaptive: cloud.isAdaptive }).toEqual({
      format: 'glb',
      unit: 'm',
      isAdaptive: true,
    });
  });

  it('samples triangles, whatever the pieces', async () => {
    const { bounds } = await read(MODEL);
    expectBox(bounds, [
      [0, 2],
      [0, 0],
      [0, 1],
    ]);
    expectBox((await read(MODEL, layout.data, [7, 100])).bounds, [
      [0, 2],
      [0, 0],
      [0, 1],
    ]);
  });

  it('places nodes within nodes: translation, rotation, scale, matrix', async () => {
    const half = Math.SQRT1_2;
    const nodes = [
      { children: [1], translation: [10, 0, 0] },
      // A quarter turn about y takes x to −z.
      { children: [2], rotation: [0, half, 0, half], scale: [2, 1, 1] },
      { mesh: 0, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 1, 5, 0, 1] },
    ];
    // (x, 0, z) → (x + 1, 5, z) → scaled (2x + 2, 5, z) → turned (z, 5, −2x − 2) → moved.
    expectBox((await read({ ...MODEL, nodes })).bounds, [
      [10, 11],
      [5, 5],
      [-6, -2],
    ]);
  });

  it('counts every place a mesh stands at', async () => {
    const nodes = [{ children: [1, 2] }, { mesh: 0 }, { mesh: 0, translation: [100, 0, 0] }];
    const { xyz } = await read({ ...MODEL, nodes });
    const far = xyz.filter(([x]) => x > 50).length;
    expect(far / xyz.length).toBeCloseTo(0.5, 2);
  });

  it('takes nodes without a scene', async () => {
    const { scene, scenes, ...rest } = MODEL;
    expectBox((await read({ ...rest, nodes: [{ children: [1] }, { mesh: 0 }] })).bounds, [
      [0, 2],
      [0, 0],
      [0, 1],
    ]);
    expect([scene, scenes]).toBeDefined();
  });

  it.each([
    ['8 bits', 5121, Uint8Array.of(0, 1, 2)],
    ['16 bits', 5123, Uint16Array.of(0, 1, 2)],
    ['32 bits', 5125, Uint32Array.of(0, 1, 2)],
  ])('reads indices of %s', async (_, componentType, indices) => {
    const { data, bufferViews, buffers } = layOut([Float32Array.from(CORNERS), indices]);
    const accessors = [positions, { bufferView: 1, componentType, count: 3, type: 'SCALAR' }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0 }, indices: 1 }] }];
    expectBox((await read({ ...MODEL, accessors, meshes, bufferViews, buffers }, data)).bounds, [
      [0, 2],
      [0, 0],
      [0, 1],
    ]);
  });

  it.each([
    ['strip', 5, [0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 1]],
    ['fan', 6, [0, 0, 0, 1, 0, 0, 1, 0, 1, 0, 0, 1]],
  ])('reads a %s', async (_, mode, square) => {
    const { data, bufferViews, buffers } = layOut([Float32Array.from(square)]);
    const accessors = [{ ...positions, count: 4 }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0 }, mode }] }];
    const { xyz, bounds } = await read({ ...MODEL, accessors, meshes, bufferViews, buffers }, data);
    expectBox(bounds, [
      [0, 1],
      [0, 0],
      [0, 1],
    ]);
    const quarter = xyz.filter(([x, , z]) => x < 0.5 && z < 0.5).length;
    expect(quarter / xyz.length).toBeCloseTo(0.25, 2);
  });

  it('keeps points as they are and passes over lines', async () => {
    const meshes = [
      {
        primitives: [
          { attributes: { POSITION: 0 }, mode: 0 },
          { attributes: { POSITION: 0 }, mode: 1 },
        ],
      },
    ];
    expect((await read({ ...MODEL, meshes })).xyz).toEqual([
      [0, 0, 0],
      [2, 0, 0],
      [0, 0, 1],
    ]);
  });

  it('reads interleaved, quantised and sparse values', async () => {
    // 16-bit positions, normalised, two bytes of something else after each: 8 bytes a vertex.
    const rows = Int16Array.from([0, 0, 0, 9, 32767, 0, 0, 9, 0, 0, 9, 9]);
    const { data, bufferViews, buffers } = layOut([rows, Uint16Array.of(2), Int16Array.of(0, 0, 32767)]);
    const accessors = [
      {
        ...{ bufferView: 0, componentType: 5122, count: 3, type: 'VEC3', normalized: true },
        sparse: { count: 1, indices: { bufferView: 1, componentType: 5123 }, values: { bufferView: 2 } },
      },
    ];
    const views = [{ ...bufferViews[0], byteStride: 8 }, ...bufferViews.slice(1)];
    const model = {
      ...MODEL,
      extensionsRequired: ['KHR_mesh_quantization'],
      accessors,
      bufferViews: views,
      buffers,
    };
    const nodes = [{ mesh: 0, scale: [2, 1, 1] }];
    expectBox((await read({ ...model, nodes }, data)).bounds, [
      [0, 2],
      [0, 0],
      [0, 1],
    ]);
    expect((await open({ ...model, nodes }, data)).cloud.warnings).toEqual([]);
  });

  it.each([
    ['floats', FLOAT, Float32Array.of(1, 0.5, 0, 1, 0.5, 0, 1, 0.5, 0), 'VEC3', false],
    ['bytes', 5121, Uint8Array.of(255, 128, 0, 9, 255, 128, 0, 9, 255, 128, 0, 9), 'VEC4', true],
    ['shorts', 5123, Uint16Array.of(65535, 32896, 0, 65535, 32896, 0, 65535, 32896, 0), 'VEC3', true],
  ])('reads colours of %s', async (_, componentType, colours, type, normalized) => {
    const { data, bufferViews, buffers } = layOut([Float32Array.from(CORNERS), colours]);
    const accessors = [positions, { bufferView: 1, componentType, count: 3, type, normalized }];
    const meshes = [{ primitives: [{ attributes: { POSITION: 0, COLOR_0: 1 } }] }];
    const { colour } = await read({ ...MODEL, accessors, meshes, bufferViews, buffers }, data);
    expect(new Set(colour?.map(String))).toEqual(new Set(['255,128,0']));
  });

  it('reads text with the data inside', async () => {
    const uri = `data:application/octet-stream;base64,${btoa(String.fromCharCode(...layout.data))}`;
    const text = JSON.stringify({ ...MODEL, buffers: [{ uri, byteLength: layout.data.length }] });
    const { xyz } = await readAll(memorySource(text, 'a.gltf'));
    expect(xyz.length).toBeGreaterThan(1000);
  });

  it('asks for one file where the data lies beside it', async () => {
    const text = JSON.stringify({ ...MODEL, buffers: [{ uri: 'room.bin', byteLength: 36 }] });
    await expect(readAll(memorySource(bytesOf(text), 'a.gltf'))).rejects.toMatchObject({
      code: 'input/unreadable',
      hint: expect.stringContaining('GLB'),
      message: expect.stringContaining('room.bin'),
    });
  });

  it('names an extension that keeps places elsewhere', async () => {
    const name = 'EXT_mesh_gpu_instancing';
    await expect(open({ ...MODEL, extensionsRequired: [name] })).rejects.toMatchObject({
      code: 'input/unreadable',
      message: expect.stringContaining(name),
    });
  });

  it('warns of an extension it does not know', async () => {
    const { cloud } = await open({ ...MODEL, extensionsRequired: ['ACME_shape'] });
    expect(cloud.warnings).toMatchObject([{ code: 'read/extension-unknown' }]);
  });
});

describe('a spoilt glTF', () => {
  const primitive = { attributes: { POSITION: 0 } };
  it.each<[string, object]>([
    ['a cycle of nodes', { nodes: [{ children: [0] }] }],
    ['a node with two parents', { nodes: [{ children: [1, 2] }, { children: [2] }, { mesh: 0 }] }],
    ['a node that is not there', { nodes: [{ children: [7] }] }],
    ['a mesh that is not there', { nodes: [{ mesh: 3 }] }],
    ['a matrix of three', { nodes: [{ mesh: 0, matrix: [1, 2, 3] }] }],
    ['an accessor past its view', { accessors: [{ ...positions, count: 4 }] }],
    [
      'an accessor of endless zeros',
      { accessors: [{ ...positions, bufferView: undefined, count: 2 ** 40 }] },
    ],
    ['a view past its buffer', { bufferViews: [{ buffer: 0, byteOffset: 30, byteLength: 36 }] }],
    [
      'a buffer longer than the chunk',
      { bufferViews: [{ buffer: 0, byteLength: 2 ** 40 }], buffers: [{ byteLength: 2 ** 40 }] },
    ],
    ['a negative offset', { bufferViews: [{ buffer: 0, byteOffset: -4, byteLength: 36 }] }],
    ['flat positions', { accessors: [{ ...positions, type: 'VEC2' }] }],
    ['an unknown component type', { accessors: [{ ...positions, componentType: 1 }] }],
    [
      'colours for other vertices',
      {
        meshes: [{ primitives: [{ attributes: { POSITION: 0, COLOR_0: 1 } }] }],
        accessors: [positions, { ...positions, count: 2 }],
      },
    ],
    [
      'indices past the vertices',
      {
        meshes: [{ primitives: [{ ...primitive, indices: 1 }] }],
        accessors: [positions, { bufferView: 0, componentType: 5121, count: 36, type: 'SCALAR' }],
      },
    ],
    ['version 1', { asset: { version: '1.0' } }],
    ['lists that are none', { nodes: 'many' }],
  ])('with %s is malformed', async (_, part) => {
    await expect(read({ ...MODEL, ...part })).rejects.toMatchObject({ code: 'input/malformed' });
  });

  it('that is cut off says so', async () => {
    const whole = glbBytes(MODEL, layout.data);
    for (const length of [14, 100, whole.length - 20]) {
      await expect(readAll(memorySource(whole.subarray(0, length), 'a.glb'))).rejects.toMatchObject({
        code: 'input/truncated',
      });
    }
    const ofUnknownSize = { ...memorySource(whole.subarray(0, whole.length - 20), 'a.glb'), size: undefined };
    await expect(readAll(ofUnknownSize)).rejects.toMatchObject({ code: 'input/truncated' });
  });

  it('that is no JSON says so', async () => {
    await expect(readAll(memorySource('{"asset": {', 'a.gltf'))).rejects.toMatchObject({
      code: 'input/malformed',
    });
  });

  it('without anything in it is empty', async () => {
    await expect(read({ ...MODEL, nodes: [{}] })).rejects.toMatchObject({ code: 'input/empty' });
  });
});

describe('a packed model', () => {
  const fixture = (name: string) =>
    new Uint8Array(readFileSync(new URL(`../../../fixtures/foreign/${name}.glb`, import.meta.url)));
  const jsonEnd = (bytes: Uint8Array) => 20 + new DataView(bytes.buffer).getUint32(12, true);
  const PACKED = ['flat-meshopt', 'flat-filtered', 'flat-draco'];

  /** Box and mean colour, from samples. */
  async function factsOf(name: string): Promise<number[]> {
    const { xyz, colour = [] } = await readAll(memorySource(fixture(name), `${name}.glb`));
    const columns = [...[0, 1, 2].map((axis) => xyz.map((point) => point[axis]))];
    const means = [0, 1, 2].map((k) => colour.reduce((sum, rgb) => sum + rgb[k], 0) / colour.length / 255);
    const box = columns.flatMap((values) => [
      values.reduce((a, b) => Math.min(a, b)),
      values.reduce((a, b) => Math.max(a, b)),
    ]);
    return [...box, ...means];
  }

  it('is the model it was before', async () => {
    const facts = await factsOf('flat');
    for (const name of ['flat-quantised', ...PACKED]) {
      const found = await factsOf(name);
      expect(found.length).toBe(9);
      // Samples come within two steps of the corners.
      for (const [i, value] of found.entries())
        expect(Math.abs(value - facts[i]), `${name} ${i}`).toBeLessThan(0.03);
    }
  });

  it.each(PACKED)('%s, spoilt, is refused', async (name) => {
    const bytes = fixture(name);
    bytes.fill(0, jsonEnd(bytes) + 8 + 2);
    await expect(readAll(memorySource(bytes, 'a.glb'))).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringMatching(/packed by (meshopt|Draco)/),
    });
  });

  it.each([
    ['a count beyond what bytes can grow to', '"count":60}', '"count":6000000}', 'at most'],
    ['an element of no size', '"byteStride":8,"mode"', '"byteStride":7,"mode"', 'elements of ATTRIBUTES'],
    ['an unknown mode', '"mode":"ATTRIBUTES"', '"mode":"WAVELETS"', 'a known mode'],
    ['triangles of four corners', '"count":258}', '"count":256}', 'elements of TRIANGLES'],
    ['fewer values than are looked for', '"count":60}', '"count":59}', '60 values'],
  ])('with %s is refused', async (_, from, to, message) => {
    const bytes = fixture('flat-meshopt');
    const end = jsonEnd(bytes);
    const text = new TextDecoder().decode(bytes.subarray(20, end));
    expect(text).toContain(from);
    const spoilt = glbBytes(JSON.parse(text.replace(from, to)), bytes.subarray(end + 8));
    await expect(readAll(memorySource(spoilt, 'a.glb'))).rejects.toMatchObject({
      code: 'input/malformed',
      message: expect.stringContaining(message),
    });
  });
});
