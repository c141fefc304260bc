import type { ByteCursor } from './bytes/byte-cursor.ts';
import { viewOf } from './bytes/view-of.ts';
import type { PointChunk } from './cloud-reader.ts';
import type { FieldColumn, PointBuffer } from './point-buffer.ts';

/** Bytes of a value. */
export const NUMBER_BYTES = {
  int8: 1,
  uint8: 1,
  int16: 2,
  uint16: 2,
  int32: 4,
  uint32: 4,
  float32: 4,
  float64: 8,
} as const;
export type NumberType = keyof typeof NUMBER_BYTES;

/** Where a field's value lies in a record, and what it means: scale · value + shift. */
export interface RecordField {
  /** Number in {@link FIELDS}. */
  readonly field: number;
  readonly type: NumberType;
  /** Bytes from the record's begin. */
  readonly offset: number;
  readonly scale?: number;
  readonly shift?: number;
  /** Bits of a whole number that are the value. */
  readonly mask?: number;
  /** Bytes from a value to the next, where the field's values lie in a column of their own. */
  readonly stride?: number;
}

/** Binary records of one length. */
export interface RecordLayout {
  readonly fields: readonly RecordField[];
  /** Bytes of a record. */
  readonly stride: number;
  readonly isLittleEndian: boolean;
  /** Records with any of these bits set in their byte at `offset` are left out. */
  readonly leftOut?: { readonly offset: number; readonly mask: number };
}

export interface RecordStream {
  readonly cursor: ByteCursor;
  readonly layout: RecordLayout;
  readonly count: number;
  readonly buffer: PointBuffer;
  /** Called where the stream ends too soon, after `found` records; throws where they are of no use. */
  endEarly(found: number): void;
}

/**
 * Points of binary records, decoded column by column over a cache-sized run: the type is looked at once a column, not
 * once a value. @throws what `endEarly` throws
 */
export async function* readRecords(stream: RecordStream): AsyncGenerator<PointChunk> {
  const { cursor, layout, buffer } = stream;
  const { stride } = layout;
  let left = stream.count;
  while (left > 0) {
    if (cursor.available < stride && !(await cursor.fillNarrowly(stride))) {
      stream.endEarly(stream.count - left);
      if (buffer.count > 0) yield buffer.take();
      return;
    }
    const count = Math.min(left, buffer.free, Math.floor(cursor.available / stride));
    decodeRecords(cursor.bytes, cursor.position, count, layout, buffer);
    cursor.position += count * stride;
    left -= count;
    if (buffer.free === 0 || (left === 0 && buffer.count > 0)) yield buffer.take();
  }
}

/** Appends `count` records, the first at byte `begin`, to a buffer with room for them: run by run of those kept. */
export function decodeRecords(
  bytes: Uint8Array,
  begin: number,
  count: number,
  layout: RecordLayout,
  buffer: PointBuffer,
): void {
  const { leftOut, stride } = layout;
  const { offset, mask } = leftOut ?? { offset: 0, mask: 0 };
  let first = 0;
  for (let i = 0; leftOut && i < count; i++) {
    if ((bytes[begin + i * stride + offset] & mask) === 0) continue;
    if (i > first) decodeRun(bytes, begin + first * stride, i - first, layout, buffer);
    first = i + 1;
  }
  if (count > first) decodeRun(bytes, begin + first * stride, count - first, layout, buffer);
}

function decodeRun(
  bytes: Uint8Array,
  begin: number,
  count: number,
  { fields, stride, isLittleEndian }: RecordLayout,
  buffer: PointBuffer,
): void {
  const view = viewOf(bytes);
  for (const { field, type, offset, scale = 1, shift = 0, mask, stride: own = stride } of fields) {
    const column = buffer.column(field);
    if (!column) continue;
    const raw = { view, type, offset: begin + offset, stride: own, isLittleEndian };
    if (type === 'int32' && mask === undefined) {
      decodeScaled(raw, column, count, scale, shift);
      continue;
    }
    decodeColumn(raw, column, count);
    if (mask !== undefined) maskColumn(column, count, mask);
    if (scale !== 1 || shift !== 0) scaleColumn(column, count, scale, shift);
  }
  buffer.count += count;
}

interface RawColumn {
  readonly view: DataView;
  readonly type: NumberType;
  readonly offset: number;
  readonly stride: number;
  readonly isLittleEndian: boolean;
}

function decodeColumn(from: RawColumn, { into, first, step }: FieldColumn, count: number): void {
  const { view, type, stride, isLittleEndian } = from;
  let at = from.offset;
  const end = first + step * count;
  if (type === 'float32') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getFloat32(at, isLittleEndian);
  } else if (type === 'float64') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getFloat64(at, isLittleEndian);
  } else if (type === 'uint16') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getUint16(at, isLittleEndian);
  } else if (type === 'uint8') {
    for (let to = first; to < end; to += step, at += stride) into[to] = view.getUint8(at);
  } else {
    const read = NUMBER_READERS[type];
    for (let to = first; to < end; to += step, at += stride) into[to] = read(view, at, isLittleEndian);
  }
}

/** The coordinates of LAS, in one go. */
function decodeScaled(
  { view, stride, isLittleEndian, offset }: RawColumn,
  { into, first, step }: FieldColumn,
  count: number,
  scale: number,
  shift: number,
): void {
  const end = first + step * count;
  for (let to = first, at = offset; to < end; to += step, at += stride)
    into[to] = view.getInt32(at, isLittleEndian) * scale + shift;
}

function scaleColumn({ into, first, step }: FieldColumn, count: number, scale: number, shift: number): void {
  const end = first + step * count;
  for (let at = first; at < end; at += step) into[at] = into[at] * scale + shift;
}

function maskColumn({ into, first, step }: FieldColumn, count: number, mask: number): void {
  const end = first + step * count;
  for (let at = first; at < end; at += step) into[at] &= mask;
}

export type NumberReader = (view: DataView, offset: number, isLittleEndian: boolean) => number;

export const NUMBER_READERS: Readonly<Record<NumberType, NumberReader>> = {
  int8: (view, offset) => view.getInt8(offset),
  uint8: (view, offset) => view.getUint8(offset),
  int16: (view, offset, isLittle) => view.getInt16(offset, isLittle),
  uint16: (view, offset, isLittle) => view.getUint16(offset, isLittle),
  int32: (view, offset, isLittle) => view.getInt32(offset, isLittle),
  uint32: (view, offset, isLittle) => view.getUint32(offset, isLittle),
  float32: (view, offset, isLittle) => view.getFloat32(offset, isLittle),
  float64: (view, offset, isLittle) => view.getFloat64(offset, isLittle),
};
