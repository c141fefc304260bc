import { countOf } from '../core/count-words.ts';
import { FloorPlanError } from '../core/errors.ts';
import { ByteCursor } from './byte-cursor.ts';
import type { PointChunk, ReadProgress } from './cloud-reader.ts';
import { PLY_SIZES, type PlyElement, type PlyProperty, type PlyType } from './ply-header.ts';
import { type ColourRange, type FieldColumn, PointBuffer } from './point-buffer.ts';
import type { ByteSource } from './source.ts';

/** The binary body of a PLY file, ready to be read. */
export interface PlyBody {
  /** Elements up to and with the vertices. */
  readonly elements: readonly PlyElement[];
  /** Property of the vertices for each field, by field number; −1 where there is none. */
  readonly columns: readonly number[];
  readonly begin: number;
  readonly isLittleEndian: boolean;
  readonly colourRange: ColourRange;
}

interface Decoder {
  readonly cursor: ByteCursor;
  readonly buffer: PointBuffer;
  readonly vertex: PlyElement;
  readonly body: PlyBody;
  readonly name: string;
}

/** Bytes of one record, or null where it has lists and records differ. */
export function recordBytes({ properties }: PlyElement): number | null {
  let bytes = 0;
  for (const { type, countType } of properties) {
    if (countType) return null;
    bytes += PLY_SIZES[type];
  }
  return bytes;
}

/** Points of a binary PLY. @throws input/truncated, with the byte offset */
export async function* readBinaryPly(
  source: ByteSource,
  body: PlyBody,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const cursor = new ByteCursor(source.stream(), progress);
  const vertex = body.elements[body.elements.length - 1];
  const buffer = new PointBuffer((field) => body.columns[field] >= 0, body.colourRange);
  const decoder = { cursor, buffer, vertex, body, name: source.name };
  try {
    await skipBytes(decoder, body.begin);
    for (const element of body.elements.slice(0, -1)) await skipElement(decoder, element);
    const stride = recordBytes(vertex);
    if (stride === null) yield* readListRecords(decoder);
    else yield* readFixedRecords(decoder, stride);
  } finally {
    await cursor.close();
  }
}

/** Column by column over a cache-sized run of records: the type is looked at once a column, not once a value. */
async function* readFixedRecords(decoder: Decoder, stride: number): AsyncGenerator<PointChunk> {
  const { cursor, buffer, vertex } = decoder;
  let left = vertex.count;
  while (left > 0) {
    if (cursor.available < stride) await needBytes(decoder, stride);
    const count = Math.min(left, buffer.free, Math.floor(cursor.available / stride));
    decodeRecords(decoder, stride, count);
    cursor.position += count * stride;
    buffer.count += count;
    left -= count;
    if (buffer.free === 0 || left === 0) yield buffer.take();
  }
}

function decodeRecords({ cursor, buffer, vertex, body }: Decoder, stride: number, count: number): void {
  const { bytes, position } = cursor;
  let offset = position;
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  vertex.properties.forEach(({ type }, index) => {
    const field = body.columns.indexOf(index);
    const column = field < 0 ? undefined : buffer.column(field);
    const from = { view, type, offset, stride, isLittleEndian: body.isLittleEndian };
    if (column) decodeColumn(from, column, count);
    offset += PLY_SIZES[type];
  });
}

interface RawColumn {
  readonly view: DataView;
  readonly type: PlyType;
  readonly offset: number;
  readonly stride: number;
  readonly isLittleEndian: boolean;
}

function decodeColumn(from: RawColumn, { into, first, step }: FieldColumn, count: number): void {
  const { view, type, stride, isLittleEndian } = from;
  let at = from.offset;
  const end = first + step * count;
  if (type === 'float') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getFloat32(at, isLittleEndian);
  } else if (type === 'double') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getFloat64(at, isLittleEndian);
  } else if (type === 'uchar') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getUint8(at);
  } else {
    const read = VALUE_READERS[type];
    for (let to = first; to < end; to += step, at += stride) into[to] = read(view, at, isLittleEndian);
  }
}

type ValueReader = (view: DataView, offset: number, isLittleEndian: boolean) => number;

const VALUE_READERS: Readonly<Record<PlyType, ValueReader>> = {
  char: (view, offset) => view.getInt8(offset),
  uchar: (view, offset) => view.getUint8(offset),
  short: (view, offset, isLittle) => view.getInt16(offset, isLittle),
  ushort: (view, offset, isLittle) => view.getUint16(offset, isLittle),
  int: (view, offset, isLittle) => view.getInt32(offset, isLittle),
  uint: (view, offset, isLittle) => view.getUint32(offset, isLittle),
  float: (view, offset, isLittle) => view.getFloat32(offset, isLittle),
  double: (view, offset, isLittle) => view.getFloat64(offset, isLittle),
};

/** Vertices with lists among their properties: value by value, the lists passed over. */
async function* readListRecords(decoder: Decoder): AsyncGenerator<PointChunk> {
  const { buffer, vertex, body } = decoder;
  const values = new Float64Array(body.columns.length);
  const targets = vertex.properties.map((_, index) => body.columns.indexOf(index));
  for (let record = 0; record < vertex.count; record++) {
    for (let index = 0; index < targets.length; index++) {
      const property = vertex.properties[index];
      if (property.countType) {
        await skipList(decoder, property, property.countType);
        continue;
      }
      if (decoder.cursor.available < PLY_SIZES[property.type])
        await needBytes(decoder, PLY_SIZES[property.type]);
      const value = takeValue(decoder, property.type);
      if (targets[index] >= 0) values[targets[index]] = value;
    }
    buffer.push(values);
    if (buffer.free === 0) yield buffer.take();
  }
  if (buffer.count > 0) yield buffer.take();
}

async function skipElement(decoder: Decoder, element: PlyElement): Promise<void> {
  const stride = recordBytes(element);
  if (stride !== null) return skipBytes(decoder, element.count * stride);
  for (let record = 0; record < element.count; record++) {
    for (const property of element.properties) {
      if (property.countType) await skipList(decoder, property, property.countType);
      else await skipBytes(decoder, PLY_SIZES[property.type]);
    }
  }
}

async function skipList(decoder: Decoder, { type }: PlyProperty, countType: PlyType): Promise<void> {
  if (decoder.cursor.available < PLY_SIZES[countType]) await needBytes(decoder, PLY_SIZES[countType]);
  const bytes = Math.max(0, takeValue(decoder, countType)) * PLY_SIZES[type];
  if (decoder.cursor.available >= bytes) decoder.cursor.position += bytes;
  else await skipBytes(decoder, bytes);
}

/** The cursor holds the value. */
function takeValue({ cursor, body }: Decoder, type: PlyType): number {
  const { bytes, position } = cursor;
  const view = new DataView(bytes.buffer, bytes.byteOffset + position);
  cursor.position += PLY_SIZES[type];
  return VALUE_READERS[type](view, 0, body.isLittleEndian);
}

async function needBytes(decoder: Decoder, length: number): Promise<void> {
  if (!(await decoder.cursor.fill(length))) throw truncated(decoder);
}

async function skipBytes(decoder: Decoder, length: number): Promise<void> {
  if (!(await decoder.cursor.skip(length))) throw truncated(decoder);
}

function truncated({ cursor, vertex, name }: Decoder): FloorPlanError {
  const offset = cursor.offset + cursor.available;
  return new FloorPlanError(
    'input/truncated',
    `${name}: expected ${countOf(vertex.count, 'point')} as the header says, found the end of the file at byte ${offset}`,
    { hint: 'The file seems cut off; copy or export it again.', detail: { offset, announced: vertex.count } },
  );
}
