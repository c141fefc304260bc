import { CLASSIFICATION, INTENSITY, RED } from '../point-buffer.ts';
import type { RecordField, RecordLayout } from '../records.ts';
import type { LasHeader } from './las-header.ts';

/** A point format [ASPRS19] §2.6, by its number. */
interface PointFormat {
  /** Bytes of a record without extra bytes. */
  readonly bytes: number;
  /** Where red, green and blue begin; absent where there are none. */
  readonly colour?: number;
}

export const POINT_FORMATS: readonly PointFormat[] = [
  { bytes: 20 },
  { bytes: 28 },
  { bytes: 26, colour: 20 },
  { bytes: 34, colour: 28 },
  { bytes: 57 },
  { bytes: 63, colour: 28 },
  { bytes: 30 },
  { bytes: 36, colour: 30 },
  { bytes: 38, colour: 30 },
  { bytes: 59 },
  { bytes: 67, colour: 30 },
];

/** Formats from here on have flags and class in bytes of their own, and are compressed in layers. */
export const FIRST_EXTENDED = 6;
const FULL_INTENSITY = 65_535;
const LEGACY_CLASS = 0b1_1111;

/**
 * Where the values of a point lie. Points marked as withheld are left out: by the standard they are deleted.
 *
 * @param heightRatio heights times this are in the unit of x and y
 */
export function recordLayout(
  { format, recordBytes, scale, offset }: LasHeader,
  heightRatio = 1,
): RecordLayout {
  const { colour } = POINT_FORMATS[format];
  const isExtended = format >= FIRST_EXTENDED;
  const fields: RecordField[] = [0, 1, 2].map((axis) => {
    const ratio = axis === 2 ? heightRatio : 1;
    const [factor, shift] = [scale[axis] * ratio, offset[axis] * ratio];
    return { field: axis, type: 'int32', offset: 4 * axis, scale: factor, shift };
  });
  fields.push({ field: INTENSITY, type: 'uint16', offset: 12, scale: 1 / FULL_INTENSITY });
  fields.push({
    field: CLASSIFICATION,
    type: 'uint8',
    offset: isExtended ? 16 : 15,
    ...(!isExtended && { mask: LEGACY_CLASS }),
  });
  if (colour !== undefined) {
    for (let channel = 0; channel < 3; channel++)
      fields.push({ field: RED + channel, type: 'uint16', offset: colour + 2 * channel });
  }
  const withheld = { offset: 15, mask: isExtended ? 0b100 : 0b1000_0000 };
  return { fields, stride: recordBytes, isLittleEndian: true, leftOut: withheld };
}
