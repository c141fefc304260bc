import { cloudBounds } from '../../core/cloud-bounds.ts';

/** Constants of [glTF] §4.4 and §5: GLB framing, accessor and buffer view types. */
const MAGIC = 0x46546c67;
const JSON_CHUNK = 0x4e4f534a;
const BIN_CHUNK = 0x004e4942;
const FLOAT = 5126;
const UNSIGNED_INT = 5125;
const UNSIGNED_SHORT = 5123;
const UNSIGNED_BYTE = 5121;
const VERTICES = 34962;
const ELEMENTS = 34963;
/** Indices of so many vertices fit two bytes; the highest number restarts primitives. */
const SHORT_LIMIT = 65535;

/** The lists of a glTF file that name each other by index. */
type List = 'nodes' | 'meshes' | 'materials';

/** What all accessors of one sort share: so a file of thousands of meshes has a handful of buffer views. */
interface SharedView {
  readonly pieces: Uint8Array[];
  readonly facts: object;
  length: number;
}

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
    return this.#access('colour', colours, facts, { target: VERTICES, byteStride: 4 });
  }

  /** @returns index of the accessor */
  addIndices(indices: Uint32Array, vertices: number): number {
    const isShort = vertices <= SHORT_LIMIT;
    const componentType = isShort ? UNSIGNED_SHORT : UNSIGNED_INT;
    const data = isShort ? Uint16Array.from(indices) : indices;
    const facts = { componentType, type: 'SCALAR', count: indices.length };
    return this.#access(isShort ? 'short' : 'long', data, facts, { target: ELEMENTS });
  }

  #vertices(view: string, data: Float32Array, range: object): number {
    const facts = { componentType: FLOAT, type: 'VEC3', count: data.length / 3, ...range };
    return this.#access(view, data, facts, { target: VERTICES, byteStride: 12 });
  }

  #access(
    name: string,
    data: Float32Array | Uint8Array | Uint16Array | Uint32Array,
    facts: object,
    viewFacts: object,
  ): number {
    const view = this.#views.get(name) ?? { pieces: [], facts: viewFacts, length: 0 };
    this.#views.set(name, view);
    const bufferView = [...this.#views.keys()].indexOf(name);
    this.#accessors.push({ bufferView, byteOffset: view.length, ...facts });
    view.pieces.push(new Uint8Array(data.buffer, data.byteOffset, data.byteLength));
    view.length += data.byteLength;
    return this.#accessors.length - 1;
  }

  /** @param root asset, scene and scenes */
  toBytes(root: object): Uint8Array<ArrayBuffer> {
    const views: object[] = [];
    let length = 0;
    for (const { facts, length: byteLength } of this.#views.values()) {
      views.push({ buffer: 0, byteOffset: length, byteLength, ...facts });
      length = padded(length + byteLength);
    }
    const buffers = length > 0 ? [{ byteLength: length }] : [];
    const lists = { ...this.#lists, accessors: this.#accessors, bufferViews: views, buffers };
    // glTF has no empty lists.
    const filled = Object.entries(lists).filter(([, list]) => list.length > 0);
    return frame(JSON.stringify({ ...root, ...Object.fromEntries(filled) }), this.#joined(length));
  }

  /** Each view at a multiple of four bytes, as glTF asks. */
  #joined(length: number): Uint8Array {
    const joined = new Uint8Array(length);
    let start = 0;
    for (const view of this.#views.values()) {
      let offset = start;
      for (const piece of view.pieces) {
        joined.set(piece, offset);
        offset += piece.length;
      }
      start = padded(offset);
    }
    return joined;
  }
}

const padded = (length: number): number => 4 * Math.ceil(length / 4);

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
