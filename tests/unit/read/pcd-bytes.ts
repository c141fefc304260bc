import { bytesOf } from './memory-source.ts';

export interface PcdContent {
  /** Name, size, type and, if not 1, count of each field. */
  readonly fields: readonly (readonly [name: string, size: number, type: 'F' | 'I' | 'U', count?: number])[];
  /** Values of each point, those of a field with a count one after the other. */
  readonly points: readonly (readonly number[])[];
}

export interface PcdStyle {
  readonly data: 'ascii' | 'binary' | 'binary_compressed';
  /** Lines of the header that replace those of the same key; empty: left out. */
  readonly lines?: Readonly<Record<string, string>>;
  readonly lineEnd?: string;
}

/** A PCD file built byte by byte. */
export function pcdBytes(
  content: PcdContent,
  { data, lines = {}, lineEnd = '\n' }: PcdStyle,
): Uint8Array<ArrayBuffer> {
  const { fields, points } = content;
  const header = {
    '#': '# .PCD v.7 - Point Cloud Data file format',
    VERSION: 'VERSION .7',
    FIELDS: `FIELDS ${fields.map(([name]) => name).join(' ')}`,
    SIZE: `SIZE ${fields.map(([, size]) => size).join(' ')}`,
    TYPE: `TYPE ${fields.map(([, , type]) => type).join(' ')}`,
    COUNT: `COUNT ${fields.map(([, , , count = 1]) => count).join(' ')}`,
    WIDTH: `WIDTH ${points.length}`,
    HEIGHT: 'HEIGHT 1',
    VIEWPOINT: 'VIEWPOINT 0 0 0 1 0 0 0',
    POINTS: `POINTS ${points.length}`,
    ...lines,
    DATA: `DATA ${data}`,
  };
  const text = Object.values(header)
    .filter((line) => line !== '')
    .map((line) => line + lineEnd)
    .join('');
  const body = { ascii: textBody, binary: binaryBody, binary_compressed: compressedBody }[data](content);
  return Uint8Array.from([...bytesOf(text), ...body]);
}

function textBody({ points }: PcdContent): Uint8Array {
  return bytesOf(points.map((point) => `${point.join(' ')}\n`).join(''));
}

function binaryBody({ fields, points }: PcdContent): number[] {
  return points.flatMap((point) => {
    let at = 0;
    return fields.flatMap((field) =>
      Array.from({ length: field[3] ?? 1 }, () => valueBytes(field, point[at++])).flat(),
    );
  });
}

/** Field after field, as literal runs of LZF. */
function compressedBody({ fields, points }: PcdContent): number[] {
  let at = 0;
  const plain = fields.flatMap((field) => {
    const begin = at;
    at += field[3] ?? 1;
    return points.flatMap((point) => point.slice(begin, at).flatMap((value) => valueBytes(field, value)));
  });
  const packed = literalRuns(plain);
  return [...uint32(packed.length), ...uint32(plain.length), ...packed];
}

export function literalRuns(plain: readonly number[]): number[] {
  const packed: number[] = [];
  for (let i = 0; i < plain.length; i += 32) {
    const run = plain.slice(i, i + 32);
    packed.push(run.length - 1, ...run);
  }
  return packed;
}

export function uint32(value: number): number[] {
  return [...new Uint8Array(Uint32Array.of(value).buffer)];
}

function valueBytes([, size, type]: PcdContent['fields'][number], value: number): number[] {
  const view = new DataView(new ArrayBuffer(8));
  if (type === 'F' && size === 4) view.setFloat32(0, value, true);
  else if (type === 'F') view.setFloat64(0, value, true);
  else if (size === 1) view.setUint8(0, value);
  else if (size === 2) view.setUint16(0, value, true);
  else view.setUint32(0, value, true);
  return Array.from({ length: size }, (_, i) => view.getUint8(i));
}
