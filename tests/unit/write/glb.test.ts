import { validateBytes } from 'gltf-validator';
import { expect, test } from 'vitest';
import { checkSolid } from '../../../src/solid/check-solid.ts';
import { weld } from '../../../src/solid/weld.ts';
import { writeGlb } from '../../../src/write/glb.ts';
import type { Product } from '../../../src/write/plan-writer.ts';
import { home, productOf } from './products.ts';

interface Gltf {
  readonly asset: { readonly extras: { readonly frame: { readonly origin: number[] } } };
  readonly nodes: { readonly name: string; readonly mesh: number; readonly extras: object }[];
  readonly meshes: {
    readonly primitives: {
      readonly attributes: Record<string, number>;
      readonly indices: number;
      readonly material: number;
    }[];
  }[];
  readonly materials: { readonly name: string }[];
  readonly accessors: {
    readonly bufferView: number;
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
  const offsetOf = (accessor: number) =>
    start + gltf.bufferViews[gltf.accessors[accessor].bufferView].byteOffset;
  return {
    gltf,
    floats: (accessor: number) =>
      new Float32Array(glb.buffer, offsetOf(accessor), 3 * gltf.accessors[accessor].count),
    shorts: (accessor: number) =>
      new Uint16Array(glb.buffer, offsetOf(accessor), gltf.accessors[accessor].count),
  };
}

async function issuesOf(product: Product): Promise<unknown> {
  const { issues } = await validateBytes(writeGlb(product));
  return { errors: issues.numErrors, warnings: issues.numWarnings, messages: issues.messages };
}

const CLEAN = { errors: 0, warnings: 0, messages: [] };

test('the Khronos validator has nothing to say', async () => {
  const everything = { ...home(), options: { ceilingSlab: true } };
  expect(await issuesOf(await productOf(everything, 'a "name" \u0007 with \ud800'))).toEqual(CLEAN);
  expect(await issuesOf(await productOf({ storeys: [{}, {}] }))).toEqual(CLEAN);
});

test('an empty solid is still a valid file', async () => {
  const product = await productOf();
  const solid = { positions: new Float64Array(0), indices: new Uint32Array(0), groups: [] };
  expect(await issuesOf({ ...product, solid })).toEqual(CLEAN);
});

test('read back it is the solid: y up, metres, every group closed', async () => {
  const product = await productOf(home());
  const { gltf, floats, shorts } = read(writeGlb(product));
  expect(gltf.nodes.map(({ name }) => name)).toEqual(product.solid.groups.map(({ name }) => name));
  let volume = 0;
  for (const { mesh } of gltf.nodes) {
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
  const { gltf, floats } = read(writeGlb(await productOf(home())));
  const [{ attributes }] = gltf.meshes[0].primitives;
  const depths = floats(attributes.POSITION).filter((_, i) => i % 3 === 2);
  expect([Math.min(...depths), Math.max(...depths)].map((value) => value + 0)).toEqual([-9, 0]);
});

test('faces are flat: every normal is a unit vector square to its triangle', async () => {
  const { gltf, floats, shorts } = read(writeGlb(await productOf(home())));
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
  const { gltf } = read(writeGlb(await productOf({ ...home(), frame: { origin } })));
  expect(gltf.materials.map(({ name }) => name)).toEqual(['wall', 'floor', 'secondary']);
  expect(gltf.asset.extras.frame.origin).toEqual([...origin]);
});
