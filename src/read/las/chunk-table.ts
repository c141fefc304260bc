import { countOf } from '../../core/count-words.ts';
import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import { tooFewBytes } from '../cut-off.ts';
import { type LasHeader, malformed } from './las-header.ts';
import type { LaszipRecord } from './laszip-record.ts';
import { NumberDecoder, RangeDecoder } from './range-decoder.ts';

/** Points and bytes of each chunk, in file order; the first begins at {@link begin}. */
export interface ChunkTable {
  readonly begin: number;
  readonly points: Uint32Array;
  readonly bytes: Uint32Array;
}

/** The place of the table stands before the first chunk. */
const POINTER_BYTES = 8;
/** Most bytes that two numbers of 32 bits take in the table; usual are two. */
const ENTRY_BYTES = 20;
const POINTS = 0;
const BYTES = 1;

/**
 * Reads where the chunks of a LAZ file lie [Isenburg13]: the table at its end, itself compressed.
 *
 * @throws input/truncated, input/malformed
 */
export async function readChunkTable(
  source: ByteSource,
  header: LasHeader,
  { chunkPoints }: LaszipRecord,
): Promise<ChunkTable> {
  const begin = header.pointsBegin + POINTER_BYTES;
  const at = await tablePlace(source, header);
  const head = await source.slice(at, at + 8);
  if (head.length < 8) throw tableCut(source, header, at);
  const count = viewOf(head).getUint32(4, true);
  // A chunk begins with its first point as it is, and holds one at least.
  const most = Math.min(header.count, Math.ceil((at - begin) / header.recordBytes));
  if (count === 0 || count > most) throw malformed(source.name, at + 4, `1 to ${most} chunks`, count);
  const packed = await source.slice(at + 8, at + 8 + ENTRY_BYTES * (count + 1));
  const table = { begin, points: new Uint32Array(count), bytes: new Uint32Array(count) };
  const numbers = new NumberDecoder(new RangeDecoder(packed), 2);
  let [points, bytes, left, end] = [0, 0, header.count, begin];
  for (let i = 0; i < count; i++) {
    points = chunkPoints ?? numbers.next(points, POINTS);
    bytes = numbers.next(bytes, BYTES);
    table.points[i] = Math.min(points, left);
    table.bytes[i] = bytes;
    if (chunkPoints === null && points > left) break;
    left -= table.points[i];
    end += bytes;
  }
  if (left === 0 && end <= at) return table;
  const found = `${countOf(header.count - left, 'point')} in ${end - begin} bytes`;
  throw malformed(
    source.name,
    at,
    `chunks of ${countOf(header.count, 'point')} in ${at - begin} bytes`,
    found,
  );
}

/** −1 where the writer could not go back to note it: then it stands at the end. */
async function tablePlace(source: ByteSource, header: LasHeader): Promise<number> {
  const { size, name } = source;
  const noted = await placeAt(source, header, header.pointsBegin);
  if (noted === -1 && size === undefined) {
    throw new FloorPlanError(
      'input/malformed',
      `${name}: expected the place of the chunk table, found that it stands at the end of a file of unknown size`,
      { hint: 'Download the file first and open it from disk.' },
    );
  }
  const place = noted === -1 ? await placeAt(source, header, (size ?? 0) - POINTER_BYTES) : noted;
  if (place <= header.pointsBegin + POINTER_BYTES)
    throw malformed(name, header.pointsBegin, 'the place of the chunk table', place);
  if (size !== undefined && place + 8 > size) throw tableCut(source, header, place);
  return place;
}

async function placeAt(source: ByteSource, header: LasHeader, at: number): Promise<number> {
  const bytes = await source.slice(at, at + POINTER_BYTES);
  if (bytes.length < POINTER_BYTES) throw tableCut(source, header, at);
  const place = Number(viewOf(bytes).getBigInt64(0, true));
  if (!Number.isSafeInteger(place)) throw malformed(source.name, at, 'the place of the chunk table', place);
  return place;
}

function tableCut({ name, size = 0 }: ByteSource, { count }: LasHeader, at: number): FloorPlanError {
  return tooFewBytes(name, { count, needed: at + 8 }, size);
}
