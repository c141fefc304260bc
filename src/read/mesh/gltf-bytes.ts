import { FloorPlanError } from '../../core/errors.ts';
import { ByteCursor, joinBytes } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import type { ReadProgress } from '../cloud-reader.ts';
import { cutOffAt } from '../cut-off.ts';
import { latin1 } from '../signatures.ts';
import { isGlb } from './glb-mark.ts';
import type { ByteRange, GltfJson } from './gltf-json.ts';
import { unpackMeshopt } from './meshopt.ts';

/** Longest JSON: engines hold no longer strings than about twice this. */
const MOST_JSON_BYTES = 1 << 28;
const JSON_CHUNK = 'JSON';
const BIN_CHUNK = 'BIN\0';
/** Magic, version, length; length and kind of the first chunk. */
const GLB_HEADER_BYTES = 20;
const CHUNK_HEADER_BYTES = 8;
const DATA_URI = /^data:[^,]{0,200};base64,/;

/** Where a model's text and data lie. */
export interface GltfFile {
  readonly text: string;
  /** Byte offset of a GLB's data chunk; undefined where there is none. */
  readonly dataBegin: number | undefined;
  readonly dataLength: number;
}

/** @throws input/malformed, input/truncated, input/too-large */
export async function readGltfText(source: ByteSource): Promise<GltfFile> {
  const head = await source.slice(0, GLB_HEADER_BYTES);
  if (!isGlb(head)) return readPlainText(source);
  if (head.length < GLB_HEADER_BYTES) throw tooShort(source.name, GLB_HEADER_BYTES, head.length);
  const view = viewOf(head);
  const [version, length] = [view.getUint32(4, true), view.getUint32(12, true)];
  const kind = latin1(head.subarray(16, 20));
  if (version !== 2 || kind !== JSON_CHUNK) {
    throw malformed(
      source.name,
      'version 2 and a JSON chunk at byte 4',
      `version ${version} and a chunk ${JSON.stringify(kind)}`,
    );
  }
  if (length > MOST_JSON_BYTES) throw tooLarge(source.name, length);
  const end = GLB_HEADER_BYTES + length;
  const bytes = await source.slice(GLB_HEADER_BYTES, end + CHUNK_HEADER_BYTES);
  if (bytes.length < length) throw tooShort(source.name, end, GLB_HEADER_BYTES + bytes.length);
  const text = new TextDecoder().decode(bytes.subarray(0, length));
  const next = bytes.subarray(length);
  if (next.length < CHUNK_HEADER_BYTES || latin1(next.subarray(4)) !== BIN_CHUNK) {
    return { text, dataBegin: undefined, dataLength: 0 };
  }
  const dataLength = viewOf(next).getUint32(0, true);
  const dataBegin = end + CHUNK_HEADER_BYTES;
  if (source.size !== undefined && dataBegin + dataLength > source.size) {
    throw tooShort(source.name, dataBegin + dataLength, source.size);
  }
  return { text, dataBegin, dataLength };
}

async function readPlainText(source: ByteSource): Promise<GltfFile> {
  const pieces: Uint8Array[] = [];
  let total = 0;
  for await (const piece of source.stream()) {
    total += piece.length;
    if (total > MOST_JSON_BYTES) throw tooLarge(source.name, source.size ?? total);
    pieces.push(piece);
  }
  return { text: new TextDecoder().decode(joinBytes(pieces, total)), dataBegin: undefined, dataLength: 0 };
}

/** The bytes of buffer views, without those between them, such as pictures. */
export class GltfBytes {
  readonly #runs: { readonly range: ByteRange; readonly bytes: Uint8Array }[] = [];
  readonly #unpacked = new Map<string, Uint8Array>();

  /** Reads what `ranges` need, in one pass. @throws input/malformed, input/truncated, input/too-large */
  static async read(
    source: ByteSource,
    { file, gltf }: { readonly file: GltfFile; readonly gltf: GltfJson },
    ranges: readonly ByteRange[],
    progress: ReadProgress,
  ): Promise<GltfBytes> {
    const bytes = new GltfBytes();
    for (const buffer of new Set(ranges.map((range) => range.buffer))) {
      const wanted = joinRanges(ranges.filter((range) => range.buffer === buffer));
      const { uri } = gltf.item('buffers', buffer, 'a buffer view');
      const isOwn = uri === undefined && buffer === 0 && file.dataBegin !== undefined;
      if (isOwn) await bytes.#readChunk(source, file, wanted, progress);
      else bytes.#decode(gltf, uri, wanted);
    }
    for (const range of ranges) await bytes.#unpack(gltf, range);
    return bytes;
  }

  /** A range that was asked for, unpacked. */
  of(range: ByteRange): Uint8Array {
    return this.#unpacked.get(keyOf(range)) ?? this.#raw(range);
  }

  async #unpack(gltf: GltfJson, range: ByteRange): Promise<void> {
    const { packing, begin } = range;
    if (!packing || this.#unpacked.has(keyOf(range))) return;
    const bytes = await unpackMeshopt(this.#raw(range), packing);
    if (!bytes)
      throw gltf.malformed(
        `${packing.count} values packed by meshopt`,
        `other bytes at ${begin} of their buffer`,
      );
    this.#unpacked.set(keyOf(range), bytes);
  }

  #raw({ buffer, begin, end }: ByteRange): Uint8Array {
    const run = this.#runs.find(
      ({ range }) => range.buffer === buffer && range.begin <= begin && range.end >= end,
    );
    if (!run) throw new Error(`bytes ${begin} to ${end} of buffer ${buffer} were not read`);
    return run.bytes.subarray(begin - run.range.begin, end - run.range.begin);
  }

  async #readChunk(source: ByteSource, file: GltfFile, ranges: readonly ByteRange[], progress: ReadProgress) {
    const begin = file.dataBegin ?? 0;
    const last = ranges[ranges.length - 1].end;
    if (last > file.dataLength) {
      throw malformed(
        source.name,
        `${last} bytes of data in the chunk at byte ${begin}`,
        `${file.dataLength}`,
      );
    }
    const cursor = new ByteCursor(source.stream(), progress);
    try {
      for (const range of ranges) {
        const isWhole =
          (await cursor.skip(begin + range.begin - cursor.offset)) &&
          (await cursor.fill(range.end - range.begin));
        if (!isWhole) throw tooShort(source.name, begin + range.end, cursor.offset + cursor.available);
        const bytes = cursor.bytes.slice(cursor.position, cursor.position + range.end - range.begin);
        this.#runs.push({ range, bytes });
      }
    } finally {
      await cursor.close();
    }
  }

  #decode(gltf: GltfJson, uri: unknown, ranges: readonly ByteRange[]): void {
    const bytes = bytesOfUri(gltf, uri);
    const last = ranges[ranges.length - 1].end;
    if (last > bytes.length)
      throw gltf.malformed(`${last} bytes in the data URI of a buffer`, `${bytes.length}`);
    this.#runs.push({ range: { buffer: ranges[0].buffer, begin: 0, end: bytes.length }, bytes });
  }
}

function keyOf({ buffer, begin, end, packing }: ByteRange): string {
  return packing ? JSON.stringify([buffer, begin, end, packing]) : '';
}

/** In order, those that touch as one. */
function joinRanges(ranges: readonly ByteRange[]): ByteRange[] {
  const joined: ByteRange[] = [];
  for (const range of [...ranges].sort((a, b) => a.begin - b.begin)) {
    const before = joined.at(-1);
    if (before && range.begin <= before.end) {
      joined[joined.length - 1] = { ...before, end: Math.max(before.end, range.end) };
    } else joined.push(range);
  }
  return joined;
}

function bytesOfUri({ name }: GltfJson, uri: unknown): Uint8Array {
  const prefix = typeof uri === 'string' ? DATA_URI.exec(uri) : null;
  if (typeof uri !== 'string' || !prefix) {
    const found = typeof uri === 'string' ? `"${uri.slice(0, 40)}"` : 'none';
    throw new FloorPlanError(
      'input/unreadable',
      `${name}: expected the model's data inside the file, found ${found} beside it`,
      {
        hint: 'Save the model as GLB, one file that holds everything.',
        detail: { uri: String(uri).slice(0, 40) },
      },
    );
  }
  try {
    const text = atob(uri.slice(prefix[0].length));
    const bytes = new Uint8Array(text.length);
    for (let i = 0; i < text.length; i++) bytes[i] = text.charCodeAt(i);
    return bytes;
  } catch {
    throw malformed(name, 'a buffer in base64', 'other characters');
  }
}

function malformed(name: string, expected: string, found: string): FloorPlanError {
  return new FloorPlanError('input/malformed', `${name}: expected ${expected}, found ${found}`, {
    hint: 'The file seems damaged; export the model again.',
  });
}

function tooLarge(name: string, bytes: number): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected up to ${MOST_JSON_BYTES} bytes of JSON, found ${bytes}`,
    { hint: 'Save the model as GLB, whose data is binary.', detail: { bytes } },
  );
}

function tooShort(name: string, needed: number, offset: number): FloorPlanError {
  return cutOffAt(name, `${needed} bytes as the header says`, offset, { needed });
}
