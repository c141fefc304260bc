import { countOf } from '../../core/count-words.ts';
import { FloorPlanError } from '../../core/errors.ts';
import type { PointChunk } from '../cloud-reader.ts';
import { bufferFor, type PointBuffer } from '../point-buffer.ts';
import { decodeRecords, type RecordLayout } from '../records.ts';
import { wasmError } from '../wasm.ts';
import { type LasHeader, malformed } from './las-header.ts';
import type { LaszipRecord } from './laszip-record.ts';
import { type LazChunk, wantedLayers, writeWantedLayers } from './laz-layers.ts';
import { createLazModule, type LazModule } from './laz-module.ts';
import type { LasFile, ReadCount } from './open-las.ts';
import { FIRST_EXTENDED, POINT_FORMATS } from './point-formats.ts';

/** Points decompressed at once: their records stay in the processor's cache. */
const RUN_POINTS = 4096;
/** A chunk lies in memory as a whole; usual are some hundred kilobytes. */
const MOST_CHUNK_BYTES = 2 ** 29;
/** A real point takes 20 bits and more: a chunk of more points a byte than this is made up, and would take hours. */
const MOST_POINTS_PER_BYTE = 64;
/** The same of the decompressed bytes, for records may be long: as many as those points have in the shortest format. */
const MOST_GROWTH = 20 * MOST_POINTS_PER_BYTE;
/** The decoder may look past the end of a chunk. */
const MARGIN_BYTES = 256;

/** Decompresses chunk after chunk into one buffer. */
export class LazDecoder {
  readonly buffer: PointBuffer;
  readonly #module: LazModule;
  readonly #name: string;
  readonly #header: LasHeader;
  readonly #laszip: LaszipRecord;
  readonly #layout: RecordLayout;
  /** Format and record that the module decodes to. */
  readonly #format: number;
  readonly #records: number;
  #decoded = 0;
  #kept = 0;

  private constructor(module: LazModule, { source, header, layout }: LasFile, laszip: LaszipRecord) {
    const isLayered = header.format >= FIRST_EXTENDED;
    // Layers of no use are left away before: what remains is a format without them.
    this.#format = isLayered ? (POINT_FORMATS[header.format].colour ? 7 : 6) : header.format;
    const stride = isLayered ? POINT_FORMATS[this.#format].bytes : header.recordBytes;
    this.#layout = { ...layout, stride };
    this.#module = module;
    this.#name = source.name;
    this.#header = header;
    this.#laszip = laszip;
    this.#records = module.allocate(RUN_POINTS * stride);
    this.buffer = bufferFor(layout.fields);
  }

  /** @throws environment/wasm, where WebAssembly may not be used */
  static async create(file: LasFile, laszip: LaszipRecord): Promise<LazDecoder> {
    let module: LazModule;
    try {
      module = await createLazModule();
    } catch (cause) {
      throw wasmError('LAZ', 'the cloud as LAS', cause);
    }
    return new LazDecoder(module, file, laszip);
  }

  /** Full buffers of points; what is left over waits for the next chunk. @throws input/malformed, input/too-large */
  *decode(chunk: LazChunk): Generator<PointChunk> {
    const { buffer } = this;
    const stride = this.#layout.stride;
    const perByte = Math.min(MOST_POINTS_PER_BYTE, MOST_GROWTH / stride);
    const most = Math.floor(perByte * chunk.bytes.length);
    if (chunk.points > most)
      throw malformed(this.#name, chunk.offset, `at most ${countOf(most, 'point')}`, chunk.points);
    if (chunk.bytes.length > MOST_CHUNK_BYTES) throw tooLarge(this.#name, chunk);
    const { pointer, decoder } = this.#guard(chunk, () => this.#open(chunk));
    let left = chunk.points;
    while (left > 0) {
      const count = Math.min(left, buffer.free, RUN_POINTS);
      this.#guard(chunk, () => {
        for (let i = 0; i < count; i++) decoder.next(this.#records + i * stride);
      });
      const before = buffer.count;
      decodeRecords(this.#module.heap(), this.#records, count, this.#layout, buffer);
      this.#kept += buffer.count - before;
      this.#decoded += count;
      left -= count;
      if (buffer.free === 0) yield buffer.take();
    }
    this.#guard(chunk, () => {
      decoder.close();
      this.#module.free(pointer);
    });
  }

  /** The last points. */
  *flush(): Generator<PointChunk> {
    if (this.buffer.count > 0) yield this.buffer.take();
  }

  get count(): ReadCount {
    return { decoded: this.#decoded, kept: this.#kept };
  }

  #open(chunk: LazChunk) {
    const { bytes } = chunk;
    const module = this.#module;
    const pointer = module.allocate(bytes.length + MARGIN_BYTES);
    const place = module.heap().subarray(pointer, pointer + bytes.length + MARGIN_BYTES);
    if (this.#laszip.layers.length > 0) {
      const wanted = wantedLayers(this.#laszip, this.#format);
      writeWantedLayers(chunk, { name: this.#name, recordBytes: this.#header.recordBytes, ...wanted }, place);
    } else {
      place.set(bytes);
      place.fill(0, bytes.length);
    }
    return { pointer, decoder: module.openChunk(this.#format, this.#layout.stride, pointer) };
  }

  /** What the module throws is no error of ours: an exception without a name, or a step out of its memory. */
  #guard<T>({ offset, points, bytes }: LazChunk, work: () => T): T {
    try {
      return work();
    } catch (cause) {
      if (cause instanceof FloorPlanError) throw cause;
      throw new FloorPlanError(
        'input/malformed',
        `${this.#name}: expected ${countOf(points, 'compressed point')} in ${bytes.length} bytes at byte ${offset}, found bytes that cannot be decompressed`,
        { hint: 'The file seems damaged; copy or export it again.', detail: { offset }, cause },
      );
    }
  }
}

function tooLarge(name: string, { offset, bytes }: LazChunk): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected chunks of up to ${MOST_CHUNK_BYTES} bytes, found one of ${bytes.length} at byte ${offset}`,
    { hint: 'Save the cloud as LAS, or as LAZ in chunks of 50,000 points.', detail: { offset } },
  );
}
