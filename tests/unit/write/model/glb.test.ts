import { validateBytes } from 'gltf-validator';
import { MeshoptDecoder } from 'meshoptimizer/decoder';
import { Mesh } from 'three';
import { GLTFLoader } from 'three/addons/loaders/GLTFLoader.js';
import { expect, test } from 'vitest';
import type { PointCloud } from '../../../../src/core/types.ts';
import { checkSolid } from '../../../../src/solid/check-solid.ts';
import { weld } from '../../../../src/solid/weld.ts';
import { writeCloudGlb, writeGlb } from '../../../../src/write/model/glb.ts';
import { modelParts } from '../../../../src/write/model/model-parts.ts';
import type { Product } from '../../../../src/write/plan-writer.ts';
import { home, productOf } from '../products.ts';
import { FURNISHED, furnished, HOSTILE_NAME } from './model-plans.ts';

interface Gltf {
  readonly asset: { readonly extras: { readonly frame: { readonly origin: number[] } } };
  readonly scenes: { readonly nodes?: number[] }[];
  readonly nodes: {
    readonly name: string;
    readonly mesh?: number;
    readonly children?: number[];
    readonly extras: object;
  }[];
  readonly meshes: {
    readonly primitives: {
      readonly attributes: Record<string, number>;
      readonly indices: number;
      readonly material: number;
    }[];
  }[];
  readonly materials: { readonly name: string; readonly alphaMode?: string }[];
  readonly accessors: {
    readonly bufferView: number;
    readonly byteOffset: number;
    readonly count: number;
    readonly componentType: number;
  }[];
  readonly bufferViews: { readonly byteOffset: number }[];
}

function read(glb: Uint8Array<ArrayBuffer>) {
  const view = new DataView(glb.buffer);
  const jsonLength = view.getUint32(12, true);
  const gltf = JSON.parse(new TextDecoder().decode(glb.subarray(20, 20 + jsonLength))) as Gltf;
  const start = 20 + jsonLength + 8;
  const offsetOf = (accessor: number) => {
    const { bufferView, byteOffset } = gltf.accessors[accessor];
    return start + gltf.bufferViews[bufferView].byteOffset + byteOffset;
  };
  return {
    gltf,
    floats: (accessor: number) =>
      new Float32Array(glb.buffer, offsetOf(accessor), 3 * gltf.accessors[accessor].count),
    bytes: (accessor: number) =>
      new Uint8Array(glb.buffer, offsetOf(accessor), 4 * gltf.accessors[accessor].count),
    shorts: (accessor: number) =>
      new Uint16Array(glb.buffer, offsetOf(accessor), gltf.accessors[accessor].count),
  };
}

async function issuesOf(product: Product, write = writeGlb): Promise<unknown> {
  const { issues } = await validateBytes(await write(product));
  return { errors: issues.numErrors, warnings: issues.numWarnings, messages: issues.messages };
}

const CLEAN = { errors: 0, warnings: 0, messages: [] };

test('the Khronos validator has nothing to say', async () => {
  const everything = { ...home(), options: { ceilingSlab: true } };
  expect(await issuesOf(await productOf(everything, 'a "name" \u0007 with \ud800'))).toEqual(CLEAN);
  expect(await issuesOf(await productOf({ storeys: [{}, {}] }))).toEqual(CLEAN);
  expect(await issuesOf(await productOf(furnished(), HOSTILE_NAME))).toEqual(CLEAN);
});

test('an empty solid is still a valid file', async () => {
  const product = await productOf();
  const solid = { positions: new Float64Array(0), indices: new Uint32Array(0), groups: [] };
  expect(await issuesOf({ ...product, solid })).toEqual(CLEAN);
});

test('read back it is the solid: y up, metres, every group closed', async () => {
  const facts = home();
  // What is subtracted stays a hole in the solid; as a column it would be a part of its own.
  const [storey] = facts.storeys!;
  const secondary = storey.secondary!.map((boundary) => ({ ...boundary, type: 'shaft' as const }));
  const product = await productOf({ ...facts, storeys: [{ ...storey, secondary }] });
  const { gltf, floats, shorts } = read(await writeGlb(product));
  let volume = 0;
  for (const { mesh } of gltf.nodes) {
    if (mesh === undefined) continue;
    const [{ attributes, indices }] = gltf.meshes[mesh].primitives;
    const positions = floats(attributes.POSITION);
    const corners = Float64Array.from(
      [...shorts(indices)].flatMap((i) => [...positions.subarray(3 * i, 3 * i + 3)]),
    );
    const welded = weld(corners, 1e-6);
    const group = { name: '', kind: 'wall', storey: 0, start: 0, count: welded.indices.length } as const;
    const check = checkSolid({ ...welded, groups: [group] });
    expect(check.watertight).toBe(true);
    volume += check.volume;
    const heights = positions.filter((_, i) => i % 3 === 1);
    expect(Math.max(...heights)).toBeLessThanOrEqual(2.5);
    expect(Math.min(...heights)).toBeGreaterThanOrEqual(Math.fround(-0.1));
  }
  expect(volume).toBeCloseTo(checkSolid(product.solid).volume, 4);
});

test('north in the plan is away from the viewer, not mirrored', async () => {
  const { gltf, floats } = read(await writeGlb(await productOf(home())));
  const [{ attributes }] = gltf.meshes[0].primitives;
  const depths = floats(attributes.POSITION).filter((_, i) => i % 3 === 2);
  expect([Math.min(...depths), Math.max(...depths)].map((value) => value + 0)).toEqual([-9, 0]);
});

test('faces are flat: every normal is a unit vector square to its triangle', async () => {
  const { gltf, floats, shorts } = read(await writeGlb(await productOf(home())));
  const [{ attributes, indices }] = gltf.meshes[0].primitives;
  const [p, n, order] = [floats(attributes.POSITION), floats(attributes.NORMAL), shorts(indices)];
  for (let i = 0; i < order.length; i += 3) {
    const normal = n.subarray(3 * order[i], 3 * order[i] + 3);
    expect(Math.hypot(...normal)).toBeCloseTo(1, 5);
    for (const corner of [1, 2]) {
      const along = [0, 1, 2].map((axis) => p[3 * order[i + corner] + axis] - p[3 * order[i] + axis]);
      expect(along[0] * normal[0] + along[1] * normal[1] + along[2] * normal[2]).toBeCloseTo(0, 4);
    }
  }
});

test('one material a kind, and the far origin kept with all its digits', async () => {
  const origin = [691_000.1234567, 5_334_000.7654321, 512.5] as const;
  const { gltf } = read(await writeGlb(await productOf({ ...home(), frame: { origin } })));
  expect(gltf.materials.map(({ name }) => name)).toEqual(['wall', 'floor', 'secondary']);
  expect(gltf.asset.extras.frame.origin).toEqual([...origin]);
});

test('a node a storey that tells its rooms, in it a node a part; glass lets light through', async () => {
  const product = await productOf(furnished({ storeys: [FURNISHED, FURNISHED] }));
  const { gltf } = read(await writeGlb(product));
  const storeys = gltf.scenes[0].nodes!.map((node) => gltf.nodes[node]);
  expect(storeys.map(({ name }) => name)).toEqual(['storey-0', 'storey-1']);
  const [{ name, height }] = FURNISHED.rooms!;
  expect(storeys[1].extras).toEqual({
    storey: 1,
    floor: 3,
    height: 2.5,
    rooms: [{ name, areaM2: 12, height }],
  });
  const inside = storeys.flatMap(({ children }) => children!.map((node) => gltf.nodes[node].name));
  expect(inside.toSorted()).toEqual(
    modelParts(product)
      .map((part) => part.name)
      .toSorted(),
  );
  expect(new Set(inside).size).toBe(inside.length);
  const door = gltf.nodes.find((node) => node.name === 'door-1')!;
  expect(door.extras).toMatchObject({ kind: 'door', storey: 1, opening: 0, head: 2 });
  expect(gltf.materials.filter(({ alphaMode }) => alphaMode === 'BLEND').map((m) => m.name)).toEqual([
    'glass',
  ]);
});

test('the cloud goes along where asked for: in place, without outliers, its colours linear', async () => {
  const product = await productOf();
  const cloud: PointCloud = {
    ...{ frame: product.plan.frame, stations: [], floor: 0, ceiling: null, isFlat: false },
    reasons: { unit: '', up: '' },
    positions: Float32Array.of(1, 2, 3, 9, 9, 9, 4, 5, 6),
    attributes: { colour: Uint8Array.of(255, 0, 188, 9, 9, 9, 0, 0, 0) },
  };
  const withCloud = { ...product, crop: cloud, outliers: Uint32Array.of(0, 2) };
  expect(await issuesOf(withCloud, writeCloudGlb)).toEqual(CLEAN);
  const { gltf, floats, bytes } = read(await writeCloudGlb(withCloud));
  const node = gltf.nodes.find(({ name }) => name === 'cloud')!;
  const [{ attributes }] = gltf.meshes[node.mesh!].primitives;
  expect([...floats(attributes.POSITION)]).toEqual([1, 3, -2, 4, 6, -5]);
  expect([...bytes(attributes.COLOR_0)]).toEqual([255, 0, 128, 255, 0, 0, 0, 255]);
  await expect(writeCloudGlb(product)).rejects.toMatchObject({ code: 'result/cannot-write' });
});

test('packed by meshopt, three reads the same numbers from fewer bytes', async () => {
  const plain = await productOf(furnished());
  const packed = { ...plain, options: { ...plain.options, glbPacking: 'meshopt' as const } };
  const [small, large] = [await writeGlb(packed), await writeGlb(plain)];
  expect(small.length).toBeLessThan(0.9 * large.length);
  const { issues } = await validateBytes(small);
  expect({ errors: issues.numErrors, warnings: issues.numWarnings }).toEqual({ errors: 0, warnings: 0 });
  const [got, wanted] = [await meshesOf(small), await meshesOf(large)];
  expect(got.size).toBeGreaterThan(2);
  expect(got).toEqual(wanted);
});

test('an empty solid has nothing to pack', async () => {
  const product = await productOf();
  const solid = { positions: new Float64Array(0), indices: new Uint32Array(0), groups: [] };
  const options = { ...product.options, glbPacking: 'meshopt' as const };
  expect(await issuesOf({ ...product, solid, options })).toEqual(CLEAN);
});

/** Corners and normals of each node's triangles, as three reads them. */
async function meshesOf(glb: Uint8Array<ArrayBuffer>): Promise<Map<string, number[][]>> {
  const loader = new GLTFLoader().setMeshoptDecoder(MeshoptDecoder);
  const { scene } = await loader.parseAsync(glb.buffer, '');
  const meshes = new Map<string, number[][]>();
  scene.traverse((object) => {
    if (!(object instanceof Mesh)) return;
    const { position, normal } = object.geometry.toNonIndexed().attributes;
    meshes.set(object.name, trianglesOf(position.array, normal.array));
  });
  return meshes;
}

/** Six numbers a corner, the least corner first: meshopt turns triangles. */
function trianglesOf(positions: ArrayLike<number>, normals: ArrayLike<number>): number[][] {
  const corner = (i: number) => [0, 1, 2].flatMap((k) => [positions[3 * i + k], normals[3 * i + k]]);
  return Array.from({ length: positions.length / 9 }, (_, t) => {
    const corners = [0, 1, 2].map((k) => corner(3 * t + k));
    const turns = [0, 1, 2].map((k) => [0, 1, 2].flatMap((i) => corners[(i + k) % 3]));
    return turns.toSorted((a, b) => (a.join() < b.join() ? -1 : 1))[0];
  });
}
