import { bytesOf } from './memory-source.ts';

/** A GLB of a JSON and a data chunk, built byte by byte. */
export function glbBytes(json: unknown, data: Uint8Array = new Uint8Array(0)): Uint8Array<ArrayBuffer> {
  const text = bytesOf(JSON.stringify(json));
  const parts = [...chunk('JSON', text, 32), ...(data.length > 0 ? chunk('BIN\0', data, 0) : [])];
  return Uint8Array.from([...bytesOf('glTF'), ...uint32(2), ...uint32(12 + parts.length), ...parts]);
}

function chunk(kind: string, bytes: Uint8Array, filler: number): number[] {
  const padded = [...bytes, ...Array(-bytes.length & 3).fill(filler)];
  return [...uint32(padded.length), ...bytesOf(kind), ...padded];
}

function uint32(value: number): number[] {
  return [...new Uint8Array(Uint32Array.of(value).buffer)];
}

type Numbers = Float32Array | Uint32Array | Uint16Array | Int16Array | Uint8Array | Int8Array;

/** Arrays one after the other, each from a multiple of four on, with their buffer views. */
export function layOut(arrays: readonly Numbers[]) {
  const bytes: number[] = [];
  const bufferViews = arrays.map((array) => {
    const byteOffset = bytes.length;
    bytes.push(...new Uint8Array(array.buffer, array.byteOffset, array.byteLength));
    bytes.push(...Array(-bytes.length & 3).fill(0));
    return { buffer: 0, byteOffset, byteLength: array.byteLength };
  });
  return { data: Uint8Array.from(bytes), bufferViews, buffers: [{ byteLength: bytes.length }] };
}
