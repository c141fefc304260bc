import { cloudBounds } from '../../core/cloud-bounds.ts';
import {
  packedBuffers,
  padded,
  plainBuffers,
  type SharedView,
  type ViewElement,
  type ViewPacker,
} from './glb-buffers.ts';

/** Constants of [glTF] §4.4 and §5: GLB framing and types of accessors. */
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const UNSIGNED_SHORT = 5123;
const UNSIGNED_BYTE = 5121;
/** Indices of so many vertices fit two bytes; the highest number restarts primitives. */
const SHORT_LIMIT = 65535;

/** The lists of a glTF file that name each other by index. */
type List = 'nodes' | 'meshes' | 'materials';

/** A glTF file in the making: data goes into shared views, everything else into lists. */
export class GlbFile {
  readonly #lists: Record<List, object[]> = { nodes: [], meshes: [], materials: [] };
  readonly #accessors: object[] = [];
  readonly #views = new Map<string, SharedView>();

  /** @returns its index in its list */
  add(list: List, entry: object): number {
    return this.#lists[list].push(entry) - 1;
  }

  /** @returns index of the accessor */
  addPositions(positions: Float32Array): number {
    const { min, max } = cloudBounds(positions);
    return this.#vertices('position', positions, { min: [...min], max: [...max] });
  }

  /** @returns index of the accessor */
  addNormals(normals: Float32Array): number {
    return this.#vertices('normal', normals, {});
  }

  /** @param colours r, g, b, a a vertex, linear. @returns index of the accessor */
  addColours(colours: Uint8Array): number {
    const facts = { componentType: UNSIGNED_BYTE, normalized: true, type: 'VEC4', count: colours.length / 4 };
    return this.#access('colour', colours, facts, { stride: 4, isIndices: false });
  }

  /** @returns index of the accessor */
  addIndices(indices: Uint32Array, vertices: number): number {
    const isShort = vertices <= SHORT_LIMIT;
    const componentType = isShort ? UNSIGNED_SHORT : UNSIGNED_INT;
    const data = isShort ? Uint16Array.from(indices) : indices;
    const facts = { componentType, type: 'SCALAR', count: indices.length };
    const element = { stride: data.BYTES_PER_ELEMENT, isIndices: true };
    return this.#access(isShort ? 'short' : 'long', data, facts, element);
  }

  #vertices(view: string, data: Float32Array, range: object): number {
    const facts = { componentType: FLOAT, type: 'VEC3', count: data.length / 3, ...range };
    return this.#access(view, data, facts, { stride: 12, isIndices: false });
  }

  #access(
    name: string,
    data: Float32Array | Uint8Array | Uint16Array | Uint32Array,
    facts: object,
    element: ViewElement,
  ): number {
    const view = this.#views.get(name) ?? { ...element, pieces: [], length: 0 };
    this.#views.set(name, view);
    const bufferView = [...this.#views.keys()].indexOf(name);
    this.#accessors.push({ bufferView, byteOffset: view.length, ...facts });
    view.pieces.push(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    view.length += data.byteLength;
    return this.#accessors.length - 1;
  }

  /** @param root asset, scene and scenes @param packer of the views, which stay as they are without one */
  toBytes(root: object, packer?: ViewPacker): Uint8Array<ArrayBuffer> {
    const views = [...this.#views.values()];
    const { extension, data, ...buffers } = packer ? packedBuffers(views, packer) : plainBuffers(views);
    const used = extension === undefined ? [] : [extension];
    const lists = { ...this.#lists, ...buffers, accessors: this.#accessors };
    const named = { extensionsUsed: used, extensionsRequired: used, ...lists };
    // glTF has no empty lists.
    const filled = Object.entries(named).filter(([, list]) => list.length > 0);
    return frame(JSON.stringify({ ...root, ...Object.fromEntries(filled) }), data);
  }
}

/** GLB: a header of 12 bytes, then chunks of a length, a type and content padded to four bytes. */
function frame(gltf: string, binary: Uint8Array): Uint8Array<ArrayBuffer> {
  const json = new TextEncoder().encode(gltf);
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
