import { bytesOf } from '../memory-source.ts';

/** Bytes of a record without extra bytes, and where its colour begins, by point format. */
const FORMATS = [
  [20],
  [28],
  [26, 20],
  [34, 28],
  [57],
  [63, 28],
  [30],
  [36, 30],
  [38, 30],
  [59],
  [67, 30],
] as const;

export interface LasPoint {
  /** Whole numbers, as stored. */
  readonly at: readonly [x: number, y: number, z: number];
  readonly colour?: readonly number[];
  readonly intensity?: number;
  readonly class?: number;
  readonly isWithheld?: boolean;
}

export interface LasContent {
  readonly format: number;
  readonly minor: number;
  readonly points: readonly LasPoint[];
  readonly records?: readonly VariableContent[];
  readonly scale?: readonly number[];
  readonly offset?: readonly number[];
  readonly extraBytes?: number;
  readonly hasWkt?: boolean;
  readonly bounds?: readonly [min: readonly number[], max: readonly number[]];
  /** Records behind the points. */
  readonly extended?: readonly VariableContent[];
}

export interface VariableContent {
  readonly user: string;
  readonly id: number;
  readonly bytes: Uint8Array;
}

/** A LAS file built byte by byte. */
export function lasBytes(content: LasContent): Uint8Array<ArrayBuffer> {
  const { format, minor, points, records = [], extraBytes = 0, extended = [] } = content;
  const headerBytes = minor < 3 ? 227 : minor === 3 ? 235 : 375;
  const stride = FORMATS[format][0] + extraBytes;
  const pointsBegin = headerBytes + records.reduce((sum, { bytes }) => sum + 54 + bytes.length, 0);
  const extendedBegin = pointsBegin + points.length * stride;
  const size = extendedBegin + extended.reduce((sum, { bytes }) => sum + 60 + bytes.length, 0);
  const file = new Uint8Array(size);
  const view = new DataView(file.buffer);
  file.set(bytesOf('LASF'));
  view.setUint16(6, content.hasWkt ? 0x10 : 0, true);
  file.set([1, minor], 24);
  view.setUint16(94, headerBytes, true);
  view.setUint32(96, pointsBegin, true);
  view.setUint32(100, records.length, true);
  view.setUint8(104, format);
  view.setUint16(105, stride, true);
  view.setUint32(107, minor < 4 ? points.length : 0, true);
  const { scale = [0.01, 0.01, 0.01], offset = [0, 0, 0], bounds = [scale, offset] } = content;
  for (let axis = 0; axis < 3; axis++) {
    view.setFloat64(131 + 8 * axis, scale[axis], true);
    view.setFloat64(155 + 8 * axis, offset[axis], true);
    view.setFloat64(179 + 16 * axis, bounds[1][axis], true);
    view.setFloat64(187 + 16 * axis, bounds[0][axis], true);
  }
  if (minor === 4) {
    view.setBigUint64(235, BigInt(extended.length > 0 ? extendedBegin : 0), true);
    view.setUint32(243, extended.length, true);
    view.setBigUint64(247, BigInt(points.length), true);
  }
  putRecords(file, headerBytes, records, 54);
  points.forEach((point, i) => void putPoint(view, pointsBegin + i * stride, point, format));
  putRecords(file, extendedBegin, extended, 60);
  return file;
}

function putRecords(file: Uint8Array, begin: number, list: readonly VariableContent[], head: 54 | 60): void {
  const view = new DataView(file.buffer);
  let at = begin;
  for (const { user, id, bytes } of list) {
    file.set(bytesOf(user), at + 2);
    view.setUint16(at + 18, id, true);
    if (head === 54) view.setUint16(at + 20, bytes.length, true);
    else view.setBigUint64(at + 20, BigInt(bytes.length), true);
    file.set(bytes, at + head);
    at += head + bytes.length;
  }
}

function putPoint(view: DataView, at: number, point: LasPoint, format: number): void {
  point.at.forEach((value, axis) => void view.setInt32(at + 4 * axis, value, true));
  view.setUint16(at + 12, point.intensity ?? 0, true);
  // The bits around the class are set: synthetic and key point, or synthetic and overlap.
  if (format < 6) view.setUint8(at + 15, (point.class ?? 0) | 0x60 | (point.isWithheld ? 0x80 : 0));
  else {
    view.setUint8(at + 15, 0b1001 | (point.isWithheld ? 0b100 : 0));
    view.setUint8(at + 16, point.class ?? 0);
  }
  const colour = FORMATS[format][1];
  if (colour !== undefined)
    point.colour?.forEach((value, i) => void view.setUint16(at + colour + 2 * i, value, true));
}

/** A directory of GeoTIFF keys whose values stand in it. */
export function geoKeys(keys: Readonly<Record<number, number>>): VariableContent {
  const entries = Object.entries(keys).flatMap(([key, value]) => [Number(key), 0, 1, value]);
  const numbers = Uint16Array.from([1, 1, 0, entries.length / 4, ...entries]);
  return { user: 'LASF_Projection', id: 34_735, bytes: new Uint8Array(numbers.buffer) };
}

export function wktRecord(text: string): VariableContent {
  return { user: 'LASF_Projection', id: 2112, bytes: bytesOf(`${text}\0`) };
}

/** Corners of a box of 4 × 3 × 2.5 m, in centimetres. */
export const CORNERS: readonly LasPoint[] = [0, 1, 2, 3, 4, 5, 6, 7].map((i) => ({
  at: [i & 1 ? 400 : 0, i & 2 ? 300 : 0, i & 4 ? 250 : 0],
  colour: [8000 * i, 4000 * i, 2000 * i],
  intensity: 8191 * i,
  class: i,
}));
