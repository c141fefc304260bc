import { countOf } from '../../core/count-words.ts';
import { viewOf } from '../bytes/view-of.ts';
import { malformedE57 } from './e57-error.ts';
import type { E57Scan } from './e57-scans.ts';
import type { PackedColumn } from './packed-column.ts';
import { logicalOffset, type PagedCursor } from './pages.ts';

const SECTION_HEADER_BYTES = 32;
const SECTION_MARK = 1;
const INDEX_PACKET = 0;
const DATA_PACKET = 1;
const IGNORED_PACKET = 2;
/** Of one field, ahead of the others: a file that lets them drift further apart would be kept in memory whole. */
const MOST_WAITING_BYTES = 1 << 26;

/** The binary section of one scan, from its header on ([E2807] §9). */
export class PacketReader {
  readonly #cursor: PagedCursor;
  readonly #scan: E57Scan;
  readonly #file: string;
  /** Where the section ends among the payloads' bytes. */
  #end = 0;

  constructor(cursor: PagedCursor, scan: E57Scan, file: string) {
    this.#cursor = cursor;
    this.#scan = scan;
    this.#file = file;
  }

  /** Moves to the first packet. @throws input/malformed, input/truncated */
  async begin(): Promise<void> {
    const { offset } = this.#scan;
    await this.#cursor.seek(offset);
    await this.#cursor.fill(SECTION_HEADER_BYTES);
    const view = this.#view();
    const mark = view.getUint8(0);
    if (mark !== SECTION_MARK) {
      throw malformedE57(
        this.#file,
        `expected the points of scan ${this.#scan.index} at byte ${offset}, found a section of type ${mark}`,
        { offset, scan: this.#scan.index },
      );
    }
    this.#end = logicalOffset(offset) + Number(view.getBigUint64(8, true));
    const packets = Number(view.getBigUint64(16, true));
    await this.#cursor.seek(packets);
  }

  /**
   * Hands the bytestreams of the next data packet to their columns; other packets are passed over.
   *
   * @param columns one a field, null where the field is of no use
   * @param left points that are still to come, for the message
   * @throws input/malformed, input/truncated
   */
  async next(columns: readonly (PackedColumn | null)[], left: number): Promise<void> {
    const cursor = this.#cursor;
    if (cursor.logical >= this.#end) throw this.#tooFew(left);
    await cursor.fill(4);
    const view = this.#view();
    const type = view.getUint8(0);
    const length = view.getUint16(2, true) + 1;
    if (type === INDEX_PACKET || type === IGNORED_PACKET) return cursor.skip(length);
    if (type !== DATA_PACKET || length < 6)
      throw this.#malformed(`a packet of type ${type}, ${length} bytes long`);
    await cursor.fill(length);
    this.#takeStreams(columns, length);
    cursor.position += length;
  }

  #takeStreams(columns: readonly (PackedColumn | null)[], length: number): void {
    const { bytes, position } = this.#cursor;
    const view = this.#view();
    const streams = view.getUint16(4, true);
    if (streams !== columns.length)
      throw this.#malformed(`a packet of ${streams} bytestreams for ${columns.length} fields`);
    let begin = 6 + 2 * streams;
    for (let i = 0; i < streams && begin <= length; i++) {
      const end = begin + view.getUint16(6 + 2 * i, true);
      if (end <= length) columns[i]?.append(bytes.subarray(position + begin, position + end));
      begin = end;
    }
    if (begin > length) throw this.#malformed(`a packet of ${length} bytes with bytestreams of ${begin}`);
    const drifted = columns.find((column) => column && column.waiting > MOST_WAITING_BYTES);
    if (drifted)
      throw this.#malformed(`${drifted.field.name} ${drifted.waiting} bytes ahead of other fields`);
  }

  #view(): DataView {
    const { bytes, position } = this.#cursor;
    return viewOf(bytes, position);
  }

  #malformed(found: string) {
    const { offset } = this.#cursor;
    const { index } = this.#scan;
    return malformedE57(
      this.#file,
      `expected a packet of points of scan ${index} at byte ${offset}, found ${found}`,
      { offset, scan: index },
    );
  }

  #tooFew(left: number) {
    const { offset } = this.#cursor;
    const { index, count } = this.#scan;
    return malformedE57(
      this.#file,
      `expected ${countOf(count, 'point')} in scan ${index} as the header says, found the end of its section at byte ${offset} after ${count - left}`,
      { offset, scan: index, announced: count },
    );
  }
}
