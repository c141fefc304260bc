/** What buffer views hold, of [glTF] §5. */
const VERTICES = 34962;
const ELEMENTS = 34963;

/** What one element of a buffer view is. */
export interface ViewElement {
  /** Bytes. */
  readonly stride: number;
  /** Three a triangle; else attributes of vertices. */
  readonly isIndices: boolean;
}

/** What all accessors of one sort share: so a file of thousands of meshes has a handful of buffer views. */
export interface SharedView extends ViewElement {
  readonly pieces: Uint8Array[];
  length: number;
}

/** Makes buffer views smaller. */
export interface ViewPacker {
  /** Of glTF, which tells how a view is packed. */
  readonly extension: string;
  /** @returns packed bytes, and what the extension is to say of them beside where they are */
  pack(bytes: Uint8Array, element: ViewElement): { readonly bytes: Uint8Array; readonly facts: object };
}

/** The lists of a file's views and buffers, and what its one chunk of data holds. */
interface Buffers {
  readonly bufferViews: readonly object[];
  readonly buffers: readonly object[];
  readonly data: Uint8Array;
  readonly extension?: string;
}

export function plainBuffers(views: readonly SharedView[]): Buffers {
  const { data, offsets } = joined(views.map(bytesOf));
  return {
    bufferViews: views.map((view, i) => ({ ...viewFacts(view, offsets[i]), buffer: 0 })),
    buffers: data.length > 0 ? [{ byteLength: data.length }] : [],
    data,
  };
}

/** Views then lie in a second buffer, which holds nothing: readers fill it. */
export function packedBuffers(views: readonly SharedView[], { extension, pack }: ViewPacker): Buffers {
  const plain = views.map(bytesOf);
  const packed = plain.map((bytes, i) => pack(bytes, views[i]));
  const { data, offsets } = joined(packed.map(({ bytes }) => bytes));
  const unpacked = joined(plain);
  const bufferViews = views.map((view, i) => {
    const { bytes, facts } = packed[i];
    const part = { buffer: 0, byteOffset: offsets[i], byteLength: bytes.length, ...facts };
    return {
      ...viewFacts(view, unpacked.offsets[i]),
      ...{ buffer: 1, extensions: { [extension]: part } },
    };
  });
  const empty = { byteLength: unpacked.data.length, extensions: { [extension]: { fallback: true } } };
  return data.length > 0
    ? { bufferViews, buffers: [{ byteLength: data.length }, empty], data, extension }
    : { bufferViews, buffers: [], data };
}

function viewFacts({ length, stride, isIndices }: SharedView, byteOffset: number): object {
  const target = isIndices ? { target: ELEMENTS } : { target: VERTICES, byteStride: stride };
  return { byteOffset, byteLength: length, ...target };
}

function bytesOf({ pieces, length }: SharedView): Uint8Array {
  const bytes = new Uint8Array(length);
  let offset = 0;
  for (const piece of pieces) {
    bytes.set(piece, offset);
    offset += piece.length;
  }
  return bytes;
}

/** Each part at a multiple of four bytes, as glTF asks. */
function joined(parts: readonly Uint8Array[]): { data: Uint8Array; offsets: number[] } {
  const offsets: number[] = [];
  let length = 0;
  for (const part of parts) {
    offsets.push(length);
    length = padded(length + part.length);
  }
  const data = new Uint8Array(length);
  parts.forEach((part, i) => {
    data.set(part, offsets[i]);
  });
  return { data, offsets };
}

/** A chunk and a view begin at multiples of four bytes. */
export const padded = (length: number): number => 4 * Math.ceil(length / 4);
