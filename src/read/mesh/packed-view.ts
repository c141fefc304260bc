import type { GltfJson, JsonObject } from './gltf-json.ts';

/** How meshopt has packed a buffer view (EXT_meshopt_compression, KHR_meshopt_compression). */
export interface Packing {
  readonly mode: 'ATTRIBUTES' | 'TRIANGLES' | 'INDICES';
  readonly filter: 'NONE' | 'OCTAHEDRAL' | 'QUATERNION' | 'EXPONENTIAL' | 'COLOR';
  /** Elements that come out, and bytes of each. */
  readonly count: number;
  readonly stride: number;
}

const EXTENSIONS = ['EXT_meshopt_compression', 'KHR_meshopt_compression'];
const MODES: readonly Packing['mode'][] = ['ATTRIBUTES', 'TRIANGLES', 'INDICES'];
/** Bytes an element may have that a filter restores. */
const FILTERS: Readonly<Record<Packing['filter'], (stride: number) => boolean>> = {
  NONE: () => true,
  OCTAHEDRAL: (stride) => stride === 4 || stride === 8,
  QUATERNION: (stride) => stride === 8,
  EXPONENTIAL: () => true,
  COLOR: (stride) => stride === 4 || stride === 8,
};
/** An element of attributes is four bytes or a multiple up to this. */
const MOST_STRIDE = 256;
/**
 * Most that packed bytes may grow: 256 elements that do not change take a quarter of a byte for each of their own.
 * More is a header that lies.
 */
const MOST_GROWTH = 1024;
/** Of one view, which is unpacked as a whole. */
const MOST_BYTES = 2 ** 29;

/** The packed bytes that a buffer view stands for; null where it is not packed. */
export function packedPart(view: JsonObject, from: string, gltf: GltfJson): JsonObject | null {
  const extensions = view.extensions === undefined ? {} : gltf.object(view.extensions, `${from}.extensions`);
  const name = EXTENSIONS.find((extension) => extensions[extension] !== undefined);
  return name === undefined ? null : gltf.object(extensions[name], `${from}.extensions.${name}`);
}

/** Checks everything the decoder takes for granted. @throws input/malformed */
export function readPacking(part: JsonObject, from: string, gltf: GltfJson): Packing {
  const where = `${from}, packed,`;
  const mode = MODES.find((known) => known === part.mode);
  const filter = (Object.keys(FILTERS) as Packing['filter'][]).find(
    (known) => known === (part.filter ?? 'NONE'),
  );
  if (!mode || !filter)
    throw gltf.malformed(`a known mode and filter at ${where}`, `${part.mode}, ${part.filter}`);
  const count = gltf.count(part.count, `${where} count`);
  const stride = gltf.count(part.byteStride, `${where} byteStride`);
  const isElement =
    mode === 'ATTRIBUTES'
      ? stride > 0 && stride % 4 === 0 && stride <= MOST_STRIDE && FILTERS[filter](stride)
      : (stride === 2 || stride === 4) && filter === 'NONE' && (mode === 'INDICES' || count % 3 === 0);
  if (!isElement) throw gltf.malformed(`elements of ${mode} at ${where}`, `${count} of ${stride} bytes`);
  const packed = gltf.count(part.byteLength, `${where} byteLength`);
  const most = Math.min(MOST_BYTES, MOST_GROWTH * packed);
  if (count * stride > most) throw gltf.malformed(`at most ${most} bytes at ${where}`, `${count * stride}`);
  return { mode, filter, count, stride };
}
