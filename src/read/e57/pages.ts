import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { ReadProgress } from '../cloud-reader.ts';
import { cutOffAt } from '../cut-off.ts';
import { crc32c } from './crc32c.ts';
import { malformedE57 } from './e57-error.ts';

/** An E57 file is a row of pages of this size; each ends with the CRC-32C of what it carries ([E2807] §6.2). */
export const PAGE_BYTES = 1024;
/** What a page carries. */
export const PAYLOAD_BYTES = PAGE_BYTES - 4;
/** Pages taken over at once: no more than stay in cache until they are decoded. */
const MOST_PAGES = 128;

/** Place of a physical byte offset among the payloads' bytes; NaN where it lies in a checksum. */
export function logicalOffset(physical: number): number {
  const within = physical % PAGE_BYTES;
  return within < PAYLOAD_BYTES ? Math.floor(physical / PAGE_BYTES) * PAYLOAD_BYTES + within : Number.NaN;
}

/** Whole pages, one after the other. */
interface Pages {
  readonly name: string;
  readonly bytes: Uint8Array;
  readonly begin: number;
  readonly count: number;
  /** Number of the first of them in the file. */
  readonly first: number;
}

/**
 * Checks pages and copies what they carry into `target` from `at` on.
 *
 * A wrong sum is an error and no warning: one wrong bit of a packet's header shifts every point after it.
 *
 * @throws input/malformed, with page and offset
 */
function takePayloads({ name, bytes, begin, count, first }: Pages, target: Uint8Array, at: number): void {
  for (let page = 0; page < count; page++) {
    const from = begin + page * PAGE_BYTES;
    const end = from + PAYLOAD_BYTES;
    // The only number in the format that is stored big-endian.
    const stored =
      ((bytes[end] << 24) | (bytes[end + 1] << 16) | (bytes[end + 2] << 8) | bytes[end + 3]) >>> 0;
    const found = crc32c(bytes, from, end);
    if (found !== stored) throw wrongSum(name, first + page, stored, found);
    target.set(bytes.subarray(from, end), at + page * PAYLOAD_BYTES);
  }
}

function wrongSum(name: string, page: number, stored: number, found: number) {
  const offset = page * PAGE_BYTES;
  const [expected, actual] = [stored, found].map((sum) => sum.toString(16).padStart(8, '0'));
  return malformedE57(
    name,
    `expected the checksum ${expected} of page ${page} at byte ${offset}, found ${actual}: the file is damaged`,
    { page, offset },
  );
}

/** Reads `length` logical bytes from a physical offset on, by random access. @throws input/malformed, input/truncated */
export async function readLogical(source: ByteSource, offset: number, length: number): Promise<Uint8Array> {
  const { name } = source;
  const begin = logicalOffset(offset);
  if (Number.isNaN(begin)) throw inChecksum(name, offset);
  const first = Math.floor(begin / PAYLOAD_BYTES);
  const count = Math.ceil((begin + length) / PAYLOAD_BYTES) - first;
  const bytes = await source.slice(first * PAGE_BYTES, (first + count) * PAGE_BYTES);
  if (bytes.length < count * PAGE_BYTES) {
    throw cutOffAt(name, `${length} bytes at byte ${offset}`, first * PAGE_BYTES + bytes.length);
  }
  const payloads = new Uint8Array(count * PAYLOAD_BYTES);
  takePayloads({ name, bytes, begin: 0, count, first }, payloads, 0);
  return payloads.subarray(begin % PAYLOAD_BYTES, (begin % PAYLOAD_BYTES) + length);
}

function inChecksum(name: string, offset: number) {
  return malformedE57(name, `expected data at byte ${offset}, found the checksum of a page`, { offset });
}

/**
 * A window that moves forward over what the pages of a file carry.
 *
 * The file is streamed, not sliced: archives and servers without ranges would read it anew for each slice.
 */
export class PagedCursor {
  /** The window's bytes up to `end`; those before `position` are spent. */
  readonly bytes = new Uint8Array(2 * MOST_PAGES * PAYLOAD_BYTES);
  position = 0;
  readonly #name: string;
  readonly #cursor: ByteCursor;
  #end = 0;
  /** Number of the page after the window. */
  #next = 0;

  constructor(source: ByteSource, progress: ReadProgress) {
    this.#name = source.name;
    this.#cursor = new ByteCursor(source.stream(), progress);
  }

  get available(): number {
    return this.#end - this.position;
  }

  /** Place of `position` among the payloads' bytes. */
  get logical(): number {
    return this.#next * PAYLOAD_BYTES - this.available;
  }

  /** Physical byte offset of `position`. */
  get offset(): number {
    const { logical } = this;
    return Math.floor(logical / PAYLOAD_BYTES) * PAGE_BYTES + (logical % PAYLOAD_BYTES);
  }

  /** Moves forward to a physical offset. @throws input/malformed, input/truncated */
  async seek(offset: number): Promise<void> {
    const target = logicalOffset(offset);
    if (Number.isNaN(target)) throw inChecksum(this.#name, offset);
    const ahead = target - this.logical;
    if (ahead < 0) {
      throw malformedE57(
        this.#name,
        `expected a section after byte ${this.offset}, found one at byte ${offset} that overlaps the one before`,
        { offset },
      );
    }
    await this.skip(ahead);
  }

  /** Moves on by `length` bytes. @throws input/malformed, input/truncated */
  async skip(length: number): Promise<void> {
    const beyond = length - this.available;
    if (beyond <= 0) {
      this.position += length;
      return;
    }
    const pages = Math.floor(beyond / PAYLOAD_BYTES);
    this.position = 0;
    this.#end = 0;
    if (!(await this.#cursor.skip(pages * PAGE_BYTES))) throw this.#truncated(beyond);
    this.#next += pages;
    const rest = beyond % PAYLOAD_BYTES;
    if (rest === 0) return;
    await this.fill(rest);
    this.position += rest;
  }

  /** Makes at least `length` bytes, up to 128 pages, available. @throws input/malformed, input/truncated */
  async fill(length: number): Promise<void> {
    if (this.available >= length) return;
    this.bytes.copyWithin(0, this.position, this.#end);
    this.#end -= this.position;
    this.position = 0;
    while (this.#end < length) {
      if (!(await this.#cursor.fill(PAGE_BYTES))) throw this.#truncated(length);
      this.#takePages();
    }
  }

  /** Lets the source close what it opened. */
  async close(): Promise<void> {
    await this.#cursor.close();
  }

  #takePages(): void {
    const cursor = this.#cursor;
    const count = Math.min(Math.floor(cursor.available / PAGE_BYTES), MOST_PAGES);
    takePayloads(
      { name: this.#name, bytes: cursor.bytes, begin: cursor.position, count, first: this.#next },
      this.bytes,
      this.#end,
    );
    cursor.position += count * PAGE_BYTES;
    this.#next += count;
    this.#end += count * PAYLOAD_BYTES;
  }

  #truncated(length: number) {
    const { offset, available } = this.#cursor;
    return cutOffAt(this.#name, `${length} more bytes at byte ${this.offset}`, offset + available);
  }
}
