import {
  type PlyHeader,
  type PlyProperty,
  type PlyType,
  valueBytes,
} from '../../../src/read/ply/ply-header.ts';
import { bytesOf } from './memory-source.ts';

export interface PlyContent {
  readonly name: string;
  readonly properties: readonly PlyProperty[];
  /** One array a record; a list property is an array itself. */
  readonly records: readonly (readonly (number | readonly number[])[])[];
}

export interface PlyStyle {
  readonly format: PlyHeader['format'];
  readonly lineEnd?: string;
  readonly comments?: readonly string[];
}

/** A PLY file built byte by byte. */
export function plyBytes(elements: readonly PlyContent[], style: PlyStyle): Uint8Array<ArrayBuffer> {
  const { format, lineEnd = '\n', comments = [] } = style;
  const lines = ['ply', `format ${format} 1.0`, ...comments];
  for (const { name, properties, records } of elements) {
    lines.push(`element ${name} ${records.length}`);
    for (const { name: property, type, countType } of properties) {
      lines.push(
        countType ? `property list ${countType} ${type} ${property}` : `property ${type} ${property}`,
      );
    }
  }
  const header = bytesOf([...lines, 'end_header', ''].join(lineEnd));
  const body = format === 'ascii' ? textBody(elements, lineEnd) : binaryBody(elements, style);
  const bytes = new Uint8Array(header.length + body.length);
  bytes.set(header);
  bytes.set(body, header.length);
  return bytes;
}

function textBody(elements: readonly PlyContent[], lineEnd: string): Uint8Array {
  const rows = elements.flatMap(({ records }) =>
    records.map((record) =>
      record
        .map((value) => (typeof value === 'number' ? value : [value.length, ...value].join(' ')))
        .join(' '),
    ),
  );
  return bytesOf(rows.map((row) => row + lineEnd).join(''));
}

function binaryBody(elements: readonly PlyContent[], { format }: PlyStyle): Uint8Array {
  const isLittle = format === 'binary_little_endian';
  const bytes: number[] = [];
  const put = (type: PlyType, value: number) => {
    const view = new DataView(new ArrayBuffer(8));
    const setters: Record<PlyType, () => void> = {
      char: () => view.setInt8(0, value),
      uchar: () => view.setUint8(0, value),
      short: () => view.setInt16(0, value, isLittle),
      ushort: () => view.setUint16(0, value, isLittle),
      int: () => view.setInt32(0, value, isLittle),
      uint: () => view.setUint32(0, value, isLittle),
      float: () => view.setFloat32(0, value, isLittle),
      double: () => view.setFloat64(0, value, isLittle),
    };
    setters[type]();
    for (let i = 0; i < valueBytes(type); i++) bytes.push(view.getUint8(i));
  };
  for (const { properties, records } of elements) {
    for (const record of records) {
      record.forEach((value, index) => {
        const { type, countType } = properties[index];
        if (countType) put(countType, (value as readonly number[]).length);
        for (const item of typeof value === 'number' ? [value] : value) put(type, item);
      });
    }
  }
  return Uint8Array.from(bytes);
}
