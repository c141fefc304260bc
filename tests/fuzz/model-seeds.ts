import type { Random } from '../../fixtures/simulator/random.ts';
import { glbBytes, layOut } from '../unit/read/glb-bytes.ts';
import { fixture, PLACES } from './binary-seeds.ts';
import { mutateJson } from './mutate-text.ts';
import { type Bytes, bytesOfLatin1, placesOf, type Seed, textOf } from './seed.ts';

const data = layOut([
  Float32Array.from(PLACES.flat()),
  Uint16Array.of(0, 1, 2, 0, 2, 3, 4, 9, 14, 7, 8, 11),
  Uint8Array.from({ length: 80 }, (_, i) => (i * 37) % 256),
  Uint8Array.of(1, 3),
  Float32Array.of(1, 2, 3, 3, 2, 1),
  Int16Array.from({ length: 60 }, (_, i) => 1000 * ((i * 7) % 31)),
]);
const accessor = (bufferView: number, componentType: number, count: number, type: string) => ({
  bufferView,
  componentType,
  count,
  type,
});
/** Nodes in a tree, one turned; colours; sparse and normalised values; every way to draw. */
const MODEL = {
  asset: { version: '2.0' },
  extensionsRequired: ['KHR_mesh_quantization', 'NEW_extension'],
  scene: 0,
  scenes: [{ nodes: [0, 3] }],
  nodes: [
    { children: [1, 2], scale: [1, 2, 3] },
    { mesh: 0, rotation: [0, 1, 0, 0], translation: [1, 2, 3] },
    { mesh: 1, matrix: [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1] },
    { mesh: 0 },
  ],
  meshes: [
    {
      primitives: [
        { attributes: { POSITION: 0, COLOR_0: 2 }, indices: 1 },
        { attributes: { POSITION: 0 }, mode: 0 },
        { attributes: { POSITION: 0 }, mode: 1 },
      ],
    },
    {
      primitives: [
        { attributes: { POSITION: 3 }, mode: 5 },
        { attributes: { POSITION: 4 }, indices: 1, mode: 6 },
        { attributes: { POSITION: 5 } },
      ],
    },
  ],
  accessors: [
    accessor(0, 5126, 20, 'VEC3'),
    accessor(1, 5123, 12, 'SCALAR'),
    { ...accessor(2, 5121, 20, 'VEC4'), normalized: true },
    {
      ...accessor(0, 5126, 19, 'VEC3'),
      byteOffset: 12,
      sparse: {
        count: 2,
        indices: { bufferView: 3, componentType: 5121 },
        values: { bufferView: 4, componentType: 5126 },
      },
    },
    { ...accessor(5, 5122, 20, 'VEC3'), normalized: true },
    { componentType: 5126, count: 3, type: 'VEC3' },
  ],
  bufferViews: data.bufferViews.map((view, i) => (i === 0 ? { ...view, byteStride: 12 } : view)),
};
const glbModel = { ...MODEL, buffers: data.buffers };
const textModel = {
  ...MODEL,
  buffers: [
    {
      ...data.buffers[0],
      uri: `data:application/octet-stream;base64,${Buffer.from(data.data).toString('base64')}`,
    },
  ],
};

/** Most of the JSON is read on opening: more would leave too few that get past it. */
const REMADE_SHARE = 0.2;

function glbSeed(name: string, bytes: Bytes, json: unknown, chunk: Uint8Array): Seed {
  const jsonEnd = 20 + new DataView(bytes.buffer).getUint32(12, true);
  const words = placesOf(bytes, ':').filter((at) => at < jsonEnd);
  return {
    name,
    bytes,
    boundaries: [4, 8, 12, 16, 20, jsonEnd, jsonEnd + 4, jsonEnd + 8, ...words],
    body: [Math.min(jsonEnd + 8, bytes.length), bytes.length],
    text: [[20, jsonEnd]],
    isRigid: true,
    remadeShare: REMADE_SHARE,
    remake: (random: Random) => glbBytes(mutateJson(json, random), chunk),
  };
}

function foreignGlb(name: string): Seed {
  const bytes = fixture(name);
  const jsonEnd = 20 + new DataView(bytes.buffer).getUint32(12, true);
  return glbSeed(
    'flat.glb',
    bytes,
    JSON.parse(textOf(bytes.subarray(20, jsonEnd))),
    bytes.subarray(jsonEnd + 8),
  );
}

function gltfSeed(name: string, json: unknown): Seed {
  const bytes = bytesOfLatin1(JSON.stringify(json));
  const [begin] = placesOf(bytes, 'base64,').slice(1);
  return {
    name,
    bytes,
    boundaries: [...placesOf(bytes, ':'), ...placesOf(bytes, '{')],
    body: [begin, Math.max(begin, bytes.length - 4)],
    text: [],
    isRigid: true,
    remadeShare: REMADE_SHARE,
    remake: (random: Random) => bytesOfLatin1(JSON.stringify(mutateJson(json, random))),
  };
}

const BARE = { ...glbModel, scene: undefined, scenes: undefined };

export const GLB_SEEDS: readonly Seed[] = [
  foreignGlb('foreign/flat.glb'),
  foreignGlb('foreign/flat-meshopt.glb'),
  foreignGlb('foreign/flat-filtered.glb'),
  foreignGlb('foreign/flat-draco.glb'),
  glbSeed('model.glb', glbBytes(glbModel, data.data), glbModel, data.data),
  glbSeed('bare.glb', glbBytes(BARE, data.data), BARE, data.data),
  gltfSeed('model.gltf', textModel),
];
