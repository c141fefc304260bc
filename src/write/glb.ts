import { cloudBounds } from '../core/cloud-bounds.ts';
import type { SolidGroup } from '../core/types.ts';
import { flattenMesh } from './flat-mesh.ts';
import type { Product } from './plan-writer.ts';

/** Base colours, linear RGB: clay walls, paper floors, muted blue structures. */
const COLOURS: Record<SolidGroup['kind'], readonly [number, number, number]> = {
  wall: [0.76, 0.74, 0.7],
  floor: [0.91, 0.9, 0.87],
  ceiling: [0.91, 0.9, 0.87],
  secondary: [0.36, 0.47, 0.7],
};

/** Constants of [glTF] §4.4 and §5: GLB framing, accessor and buffer view types. */
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const UNSIGNED_SHORT = 5123;
const VERTICES = 34962;
const ELEMENTS = 34963;
const SHORT_LIMIT = 65535;

interface Gltf {
  accessors: object[];
  bufferViews: object[];
  materials: object[];
  meshes: object[];
  nodes: object[];
}

/**
 * Writes plan.glb: glTF 2.0 in metres, y up, one node a group of the solid, flat-shaded.
 *
 * Coordinates are float32 relative to the frame's origin, which stands with full digits in `asset.extras.frame`, so
 * a building at UTM coordinates loses nothing.
 */
export function writeGlb({ name, plan, solid }: Product): Uint8Array<ArrayBuffer> {
  const gltf: Gltf = { accessors: [], bufferViews: [], materials: [], meshes: [], nodes: [] };
  const bytes = new ByteList();
  const kinds = [...new Set(solid.groups.map(({ kind }) => kind))];
  for (const kind of kinds) gltf.materials.push(material(kind));
  for (const group of solid.groups) {
    const { positions, normals, indices } = flattenMesh(solid, group);
    const isShort = positions.length / 3 <= SHORT_LIMIT;
    const position = addAccessor(gltf, bytes, { data: positions, ...bounds(positions) });
    const normal = addAccessor(gltf, bytes, { data: normals });
    const order = addAccessor(gltf, bytes, { data: isShort ? Uint16Array.from(indices) : indices });
    const attributes = { POSITION: position, NORMAL: normal };
    const primitive = { attributes, indices: order, material: kinds.indexOf(group.kind) };
    gltf.meshes.push({ name: group.name, primitives: [primitive] });
    const extras = { kind: group.kind, storey: group.storey };
    gltf.nodes.push({ name: group.name, mesh: gltf.meshes.length - 1, extras });
  }
  const nodes = gltf.nodes.map((_, i) => i);
  return frameGlb(
    {
      asset: { version: '2.0', generator: 'Grundriss', extras: { frame: plan.frame } },
      scene: 0,
      scenes: [nodes.length > 0 ? { name, nodes } : { name }],
      // glTF has no empty lists.
      ...Object.fromEntries(Object.entries(gltf).filter(([, list]) => list.length > 0)),
      ...(bytes.length > 0 ? { buffers: [{ byteLength: bytes.length }] } : {}),
    },
    bytes.join(),
  );
}

function material(kind: SolidGroup['kind']): object {
  const pbrMetallicRoughness = {
    baseColorFactor: [...COLOURS[kind], 1],
    metallicFactor: 0,
    roughnessFactor: 0.9,
  };
  return { name: kind, pbrMetallicRoughness };
}

function addAccessor(
  gltf: Gltf,
  bytes: ByteList,
  { data, ...range }: { data: Float32Array | Uint16Array | Uint32Array; min?: number[]; max?: number[] },
): number {
  const isVector = data instanceof Float32Array;
  const byteOffset = bytes.add(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
  const target = isVector ? VERTICES : ELEMENTS;
  gltf.bufferViews.push({ buffer: 0, byteOffset, byteLength: data.byteLength, target });
  gltf.accessors.push({
    bufferView: gltf.bufferViews.length - 1,
    componentType: isVector ? FLOAT : data instanceof Uint16Array ? UNSIGNED_SHORT : UNSIGNED_INT,
    count: isVector ? data.length / 3 : data.length,
    type: isVector ? 'VEC3' : 'SCALAR',
    ...range,
  });
  return gltf.accessors.length - 1;
}

function bounds(positions: Float32Array): { min: number[]; max: number[] } {
  const { min, max } = cloudBounds(positions);
  return { min: [...min], max: [...max] };
}

/** Bytes laid end to end, each piece at a multiple of four as glTF asks. */
class ByteList {
  readonly #pieces: Uint8Array[] = [];
  length = 0;

  /** @returns offset of the piece */
  add(piece: Uint8Array): number {
    const offset = this.length;
    this.#pieces.push(piece);
    this.length = padded(offset + piece.length);
    return offset;
  }

  join(): Uint8Array {
    const joined = new Uint8Array(this.length);
    let offset = 0;
    for (const piece of this.#pieces) {
      joined.set(piece, offset);
      offset = padded(offset + piece.length);
    }
    return joined;
  }
}

const padded = (length: number): number => 4 * Math.ceil(length / 4);

/** GLB: a header of 12 bytes, then chunks of a length, a type and content padded to four bytes. */
function frameGlb(gltf: object, binary: Uint8Array): Uint8Array<ArrayBuffer> {
  const json = new TextEncoder().encode(JSON.stringify(gltf));
  const jsonLength = padded(json.length);
  const total = 12 + 8 + jsonLength + (binary.length > 0 ? 8 + binary.length : 0);
  const file = new Uint8Array(total);
  const view = new DataView(file.buffer);
  [MAGIC, 2, total, jsonLength, JSON_CHUNK].forEach((word, i) => {
    view.setUint32(4 * i, word, true);
  });
  file.fill(0x20, 20, 20 + jsonLength);
  file.set(json, 20);
  if (binary.length > 0) {
    const start = 20 + jsonLength;
    view.setUint32(start, binary.length, true);
    view.setUint32(start + 4, BIN_CHUNK, true);
    file.set(binary, start + 8);
  }
  return file;
}
