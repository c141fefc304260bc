import { countOf } from '../../core/count-words.ts';
import { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import type { OpenCloud, PointChunk, ReadProgress } from '../cloud-reader.ts';
import { goOnWith, isWorthReading, tooFewBytes } from '../cut-off.ts';
import { columnsOfFields } from '../field-names.ts';
import { BLUE, bufferFor, type ColourRange, type PointBuffer, RED, Z } from '../point-buffer.ts';
import { decodeRecords, type RecordField, readRecords } from '../records.ts';
import { BLANK } from '../text/characters.ts';
import { type PackedColour, readTextPoints, type TextPoints } from '../text/text-points.ts';
import { inflateLzf, mostInflated } from './lzf.ts';
import { type PcdField, type PcdHeader, readPcdHeader } from './pcd-header.ts';

/** Largest compressed body that is unpacked: it is one block, field by field, so it must be held whole. */
const MOST_INFLATED_BYTES = 2 ** 31;
/** The two sizes before a compressed body. */
const SIZES_BYTES = 8;

/** A PCD file whose header was read. */
interface Pcd {
  readonly source: ByteSource;
  readonly header: PcdHeader;
  /** Index in the header's fields by field number; −1 where there is none. */
  readonly columns: readonly number[];
  /** Field that holds a whole colour as 0xAARRGGBB, or −1. */
  readonly packed: number;
  /** Bytes of a point. */
  readonly stride: number;
  readonly warnings: Warning[];
}

/**
 * Reads the header of a PCD file. Points stand as they are: PCL and Open3D do not apply the rotation of VIEWPOINT either,
 * it tells where the scanner stood.
 *
 * @throws input/malformed, input/truncated, input/empty, input/too-large
 */
export async function openPcd(source: ByteSource): Promise<OpenCloud> {
  const header = await readPcdHeader(source);
  const names = header.fields.map(({ name }) => name);
  const packed = header.fields.findIndex(
    ({ name, size, count }) => /^rgba?$/i.test(name) && size === 4 && count > 0,
  );
  const columns = columnsOfFields(names);
  const stride = header.fields.reduce((bytes, { size, count }) => bytes + size * count, 0);
  const warnings: Warning[] = [];
  const pcd: Pcd = { source, header, columns, packed, stride, warnings };
  assertPoints(pcd);
  return {
    isSlice: false,
    pointsAnnounced: header.points,
    ...(header.viewpoint && { stations: [header.viewpoint] }),
    ...(header.isGrid && { hasEmptyPlaces: true }),
    chunks: (progress) => chunksOf(pcd, progress),
    warnings,
  };
}

function chunksOf(pcd: Pcd, progress: ReadProgress): AsyncIterable<PointChunk> {
  const { encoding } = pcd.header;
  if (encoding === 'ascii') return readTextPoints(pcd.source, textPoints(pcd), progress);
  return encoding === 'binary' ? readBinary(pcd, progress) : readCompressed(pcd, progress);
}

function textPoints({ header, columns, packed, warnings }: Pcd): TextPoints {
  const targets: number[] = header.fields.flatMap(({ count }, index) => {
    const field =
      index === packed ? RED : isColour(columns.indexOf(index)) && packed >= 0 ? -1 : columns.indexOf(index);
    return Array.from({ length: count }, (_, part) => (part === 0 ? field : -1));
  });
  const lastNeeded = targets.findLastIndex((target) => target >= 0);
  return {
    layout: { separator: BLANK, targets: Int8Array.from(targets.slice(0, lastNeeded + 1)) },
    begin: header.bodyBegin,
    line: header.bodyLine,
    rows: header.points,
    colourRange: colourRange(header, columns, packed),
    warnings,
    ...(packed >= 0 && { packedColour: packedColour(header.fields[packed]) }),
  };
}

function isColour(field: number): boolean {
  return field >= RED && field <= BLUE;
}

function packedColour({ type }: PcdField): PackedColour {
  return type === 'float32' ? 'float-bits' : 'integer';
}

function colourRange({ fields }: PcdHeader, columns: readonly number[], packed: number): ColourRange {
  const type = packed >= 0 ? 'uint8' : fields[columns[RED]]?.type;
  if (type === 'float32' || type === 'float64') return 'auto';
  return type === 'uint16' || type === 'int16' ? 'short' : 'byte';
}

/** What lies where: bytes from a point's begin. */
function recordFields({ header, columns, packed }: Pcd): (RecordField & { readonly index: number })[] {
  let offset = 0;
  return header.fields.flatMap(({ type, size, count }, index) => {
    const begin = offset;
    offset += size * count;
    if (index === packed) {
      return [RED, RED + 1, BLUE].map((field) => ({
        ...{ field, index, type: 'uint8' as const },
        offset: begin + BLUE - field,
      }));
    }
    const field = columns.indexOf(index);
    if (field < 0 || !type || (packed >= 0 && isColour(field))) return [];
    return [{ field, index, type, offset: begin }];
  });
}

function bufferOf({ header, columns, packed }: Pcd, fields: readonly RecordField[]): PointBuffer {
  return bufferFor(fields, colourRange(header, columns, packed));
}

async function* readBinary(pcd: Pcd, progress: ReadProgress): AsyncGenerator<PointChunk> {
  const cursor = new ByteCursor(pcd.source.stream(), progress);
  const fields = recordFields(pcd);
  const count = pcd.header.points;
  const endEarly = (found: number) =>
    goOnWith({ found, announced: count }, cutOff(pcd, cursor), pcd.warnings);
  try {
    if (!(await cursor.skip(pcd.header.bodyBegin))) endEarly(0);
    const layout = { fields, stride: pcd.stride, isLittleEndian: true };
    yield* readRecords({ cursor, layout, count, buffer: bufferOf(pcd, fields), endEarly });
  } finally {
    await cursor.close();
  }
}

/** One block of LZF, in which each field's values for all points follow each other. */
async function* readCompressed(pcd: Pcd, progress: ReadProgress): AsyncGenerator<PointChunk> {
  const bytes = await inflateBody(pcd, progress);
  const { points } = pcd.header;
  const blocks: number[] = [];
  let begin = 0;
  for (const { size, count } of pcd.header.fields) {
    blocks.push(begin);
    begin += size * count * points;
  }
  const fields = recordFields(pcd).map((field) => {
    const { size, count } = pcd.header.fields[field.index];
    const inValue = field.index === pcd.packed ? BLUE - field.field : 0;
    return { ...field, stride: size * count, offset: blocks[field.index] + inValue };
  });
  const buffer = bufferOf(pcd, fields);
  for (let first = 0; first < points; ) {
    const count = Math.min(buffer.free, points - first);
    const moved = fields.map((field) => ({ ...field, offset: field.offset + first * field.stride }));
    decodeRecords(bytes, 0, count, { fields: moved, stride: pcd.stride, isLittleEndian: true }, buffer);
    first += count;
    yield buffer.take();
  }
}

async function inflateBody(pcd: Pcd, progress: ReadProgress): Promise<Uint8Array> {
  const { source, header, stride } = pcd;
  const cursor = new ByteCursor(source.stream(), progress);
  try {
    if (!(await cursor.skip(header.bodyBegin)) || !(await cursor.fill(SIZES_BYTES)))
      throw cutOff(pcd, cursor);
    const view = viewOf(cursor.bytes, cursor.position);
    const [packedBytes, bytes] = [view.getUint32(0, true), view.getUint32(4, true)];
    cursor.position += SIZES_BYTES;
    assertSizes(pcd, packedBytes, bytes);
    const body = allocate(source.name, bytes);
    const written = await inflateLzf(cursor, packedBytes, body, () => cutOff(pcd, cursor));
    if (written === bytes) return body;
    throw malformedBody(
      pcd,
      `LZF data of ${bytes} bytes (${countOf(header.points, 'point')} of ${stride})`,
      `${written} good bytes`,
    );
  } finally {
    await cursor.close();
  }
}

function assertSizes(pcd: Pcd, packedBytes: number, bytes: number): void {
  const { source, header, stride } = pcd;
  if (bytes !== header.points * stride) {
    const expected = `${header.points * stride} bytes in the compressed body, ${countOf(header.points, 'point')} of ${stride}`;
    throw malformedBody(pcd, expected, `${bytes}`);
  }
  if (bytes > mostInflated(packedBytes)) {
    throw malformedBody(
      pcd,
      `at most ${mostInflated(packedBytes)} bytes from ${packedBytes} compressed`,
      `${bytes}`,
    );
  }
  const needed = header.bodyBegin + SIZES_BYTES + packedBytes;
  if (source.size !== undefined && needed > source.size)
    throw tooFewBytes(source.name, { count: header.points, needed }, source.size);
}

function allocate(name: string, bytes: number): Uint8Array {
  try {
    return new Uint8Array(bytes);
  } catch (cause) {
    throw tooLarge(name, bytes, cause);
  }
}

function assertPoints(pcd: Pcd): void {
  const { source, header, columns, stride } = pcd;
  const { fields, points, encoding } = header;
  const isPlace = (column: number) => fields[column]?.type !== undefined && fields[column].count > 0;
  if (!columns.slice(0, Z + 1).every(isPlace)) {
    const found = fields.map(({ name }) => name).join(', ');
    throw new FloorPlanError(
      'input/malformed',
      `${source.name}: expected the fields x, y and z, found ${found.slice(0, 80)}`,
      { hint: 'Export the cloud with plain x, y and z coordinates.' },
    );
  }
  if (points === 0) {
    throw new FloorPlanError(
      'input/empty',
      `${source.name}: expected points, found a PCD header of 0 points`,
      {
        hint: 'Export the cloud again, with its points.',
      },
    );
  }
  // A text value takes a digit and a blank.
  const values = fields.reduce((sum, { count }) => sum + count, 0);
  const least = { ascii: 2 * values, binary: stride, binary_compressed: 0 }[encoding];
  const before = header.bodyBegin + (encoding === 'binary_compressed' ? SIZES_BYTES : 0);
  // A text may end without an end of line.
  const needed = before + least * points - (encoding === 'ascii' ? 1 : 0);
  const { size = Infinity } = source;
  const found = Math.floor((size - before) / least);
  if (needed > size && !isWorthReading({ found, announced: points }))
    throw tooFewBytes(source.name, { count: points, needed }, size);
  const inflated = stride * points;
  if (encoding === 'binary_compressed' && inflated > MOST_INFLATED_BYTES)
    throw tooLarge(source.name, inflated);
}

function tooLarge(name: string, bytes: number, cause?: unknown): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected a compressed cloud of up to ${MOST_INFLATED_BYTES} bytes, for it is unpacked as a whole; found ${bytes}`,
    { hint: 'Save it as plain binary PCD, which is read piece by piece.', detail: { bytes }, cause },
  );
}

function malformedBody({ source, header }: Pcd, expected: string, found: string): FloorPlanError {
  const offset = header.bodyBegin;
  return new FloorPlanError(
    'input/malformed',
    `${source.name}: expected ${expected} at byte ${offset}, found ${found}`,
    {
      hint: 'The file seems damaged; copy or export it again.',
      detail: { offset },
    },
  );
}

function cutOff({ source, header }: Pcd, cursor: ByteCursor): FloorPlanError {
  return tooFewBytes(source.name, { count: header.points }, cursor.offset + cursor.available);
}
