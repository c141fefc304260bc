import type { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { goOnWith, tellOfMore, tooFewBytes } from '../cut-off.ts';
import { BLUE, type ColourRange, PointBuffer, RED } from '../point-buffer.ts';
import { NUMBER_READERS, type RecordField, type RecordStream, readRecords } from '../records.ts';
import { NUMBER_TYPE_OF, type PlyElement, type PlyProperty, type PlyType, valueBytes } from './ply-header.ts';

/** The binary body of a PLY file, ready to be read. */
export interface PlyBody {
  /** Elements up to and with the vertices. */
  readonly elements: readonly PlyElement[];
  /** Property of the vertices for each field, by field number; −1 where there is none. */
  readonly columns: readonly number[];
  readonly begin: number;
  readonly isLittleEndian: boolean;
  readonly colourRange: ColourRange;
  /** No element comes after the vertices. */
  readonly endsWithVertices: boolean;
}

/** A body on its way through a cursor. */
export interface PlyDecoder {
  readonly cursor: ByteCursor;
  readonly buffer: PointBuffer;
  readonly vertex: PlyElement;
  readonly body: PlyBody;
  readonly name: string;
  /** Where to say that only what is whole was read; without them nothing but the whole will do. */
  readonly warnings?: Warning[];
}

/** Bytes of one record, or null where it has lists and records differ. */
export function recordBytes({ properties }: PlyElement): number | null {
  let bytes = 0;
  for (const { type, countType } of properties) {
    if (countType) return null;
    bytes += valueBytes(type);
  }
  return bytes;
}

export function vertexBuffer({ elements, columns, colourRange }: PlyBody): PointBuffer {
  const { properties } = elements[elements.length - 1];
  const isByte = (field: number) =>
    properties[columns[field]] && NUMBER_TYPE_OF[properties[columns[field]].type] === 'uint8';
  const areBytes = isByte(RED) && isByte(RED + 1) && isByte(BLUE);
  return new PointBuffer((field) => columns[field] >= 0, areBytes ? 'uint8' : colourRange);
}

/** Points of a binary PLY. @throws input/truncated, with the byte offset */
export async function* readBinaryPly(
  source: ByteSource,
  body: PlyBody,
  warnings: Warning[],
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const cursor = new ByteCursor(source.stream(), progress);
  const vertex = body.elements[body.elements.length - 1];
  const buffer = vertexBuffer(body);
  try {
    yield* readBinaryVertices({ cursor, buffer, vertex, body, name: source.name, warnings });
    // Less than a whole point is padding.
    const stride = recordBytes(vertex);
    if (body.endsWithVertices && stride !== null && (await cursor.fillNarrowly(stride)))
      tellOfMore(vertex.count, warnings);
  } finally {
    await cursor.close();
  }
}

/** The vertices; the cursor, which stood at the begin of the file, is left behind them. */
export async function* readBinaryVertices(decoder: PlyDecoder): AsyncGenerator<PointChunk> {
  const { body, vertex } = decoder;
  await skipBytes(decoder, body.begin);
  for (const element of body.elements.slice(0, -1)) await skipElement(decoder, element);
  const stride = recordBytes(vertex);
  if (stride === null) yield* readListRecords(decoder);
  else yield* readRecords(fixedRecords(decoder, stride));
}

function fixedRecords(decoder: PlyDecoder, stride: number): RecordStream {
  const { cursor, buffer, vertex, body } = decoder;
  const fields: RecordField[] = [];
  let offset = 0;
  vertex.properties.forEach(({ type }, index) => {
    const field = body.columns.indexOf(index);
    if (field >= 0) fields.push({ field, type: NUMBER_TYPE_OF[type], offset });
    offset += valueBytes(type);
  });
  const layout = { fields, stride, isLittleEndian: body.isLittleEndian };
  return { cursor, layout, count: vertex.count, buffer, endEarly: (found) => endEarly(decoder, found) };
}

/** Vertices with lists among their properties: value by value, the lists passed over. */
async function* readListRecords(decoder: PlyDecoder): AsyncGenerator<PointChunk> {
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
      if (decoder.cursor.available < valueBytes(property.type))
        await needBytes(decoder, valueBytes(property.type));
      const value = takeValue(decoder, property.type);
      if (targets[index] >= 0) values[targets[index]] = value;
    }
    buffer.push(values);
    if (buffer.free === 0) yield buffer.take();
  }
  if (buffer.count > 0) yield buffer.take();
}

/** Moves past all records of an element. */
export async function skipElement(decoder: PlyDecoder, element: PlyElement): Promise<void> {
  const stride = recordBytes(element);
  if (stride !== null) return skipBytes(decoder, element.count * stride);
  for (let record = 0; record < element.count; record++) {
    for (const property of element.properties) {
      if (property.countType) await skipList(decoder, property, property.countType);
      else await skipBytes(decoder, valueBytes(property.type));
    }
  }
}

async function skipList(decoder: PlyDecoder, { type }: PlyProperty, countType: PlyType): Promise<void> {
  if (decoder.cursor.available < valueBytes(countType)) await needBytes(decoder, valueBytes(countType));
  const bytes = Math.max(0, takeValue(decoder, countType)) * valueBytes(type);
  if (decoder.cursor.available >= bytes) decoder.cursor.position += bytes;
  else await skipBytes(decoder, bytes);
}

/** The cursor holds the value. */
function takeValue({ cursor, body }: PlyDecoder, type: PlyType): number {
  const view = viewOf(cursor.bytes, cursor.position);
  cursor.position += valueBytes(type);
  return NUMBER_READERS[NUMBER_TYPE_OF[type]](view, 0, body.isLittleEndian);
}

async function needBytes(decoder: PlyDecoder, length: number): Promise<void> {
  if (!(await decoder.cursor.fill(length))) throw truncated(decoder);
}

async function skipBytes(decoder: PlyDecoder, length: number): Promise<void> {
  if (!(await decoder.cursor.skip(length))) throw truncated(decoder);
}

function endEarly(decoder: PlyDecoder, found: number): void {
  const error = truncated(decoder);
  if (!decoder.warnings) throw error;
  goOnWith({ found, announced: decoder.vertex.count }, error, decoder.warnings);
}

function truncated({ cursor, vertex, name }: PlyDecoder): FloorPlanError {
  return tooFewBytes(name, { count: vertex.count }, cursor.offset + cursor.available);
}
