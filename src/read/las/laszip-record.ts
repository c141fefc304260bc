import { FloorPlanError } from '../../core/errors.ts';
import { viewOf } from '../bytes/view-of.ts';
import { type LasHeader, malformed } from './las-header.ts';
import { FIRST_EXTENDED } from './point-formats.ts';
import type { VariableRecord } from './variable-records.ts';

/** How LASzip has compressed the points: its record in the file. */
export interface LaszipRecord {
  /** Layers of each item after the first point of a chunk; empty where points are compressed one after another. */
  readonly layers: readonly number[];
  /** Points a chunk; null where chunks differ and the table tells. */
  readonly chunkPoints: number | null;
}

const LASZIP_ID = 22_204;
/** Where the header tells the length of a record. */
const RECORD_BYTES_AT = 105;
const FIXED_BYTES = 34;
const VARIABLE_CHUNKS = 0xffff_ffff;
/** Compressors with a chunk table: point after point, and in layers. */
const CHUNKED = 2;
const LAYERED = 3;
/** Items by type: what each format is made of, and how many layers each makes. */
const [POINT, TIME, COLOUR] = [6, 7, 8];
const [POINT14, COLOUR14, COLOUR_NIR14, WAVES14, BYTES14] = [10, 11, 12, 13, 14];
const BYTES = 0;
const FORMAT_ITEMS: Readonly<Record<number, readonly number[]>> = {
  0: [POINT],
  1: [POINT, TIME],
  2: [POINT, COLOUR],
  3: [POINT, TIME, COLOUR],
  6: [POINT14],
  7: [POINT14, COLOUR14],
  8: [POINT14, COLOUR_NIR14],
  9: [POINT14, WAVES14],
  10: [POINT14, COLOUR_NIR14, WAVES14],
};
const ITEM_LAYERS: Readonly<Record<number, number>> = {
  [POINT14]: 9,
  [COLOUR14]: 1,
  [COLOUR_NIR14]: 2,
  [WAVES14]: 1,
};

interface Item {
  readonly type: number;
  readonly bytes: number;
  readonly version: number;
}

/** Reads the record and checks that these points can be decompressed. @throws input/malformed, input/unknown-format */
export function readLaszipRecord(
  name: string,
  { format, recordBytes }: LasHeader,
  records: readonly VariableRecord[],
): LaszipRecord {
  const record = records.find(({ user, id }) => user === 'laszip encoded' && id === LASZIP_ID);
  if (!record || record.bytes.length < FIXED_BYTES) {
    throw new FloorPlanError(
      'input/malformed',
      `${name}: expected the record "laszip encoded" before the compressed points, found ${record ? 'a part of it' : 'none'}`,
      { hint: 'The file seems damaged; copy or export it again.' },
    );
  }
  const view = viewOf(record.bytes);
  const compressor = view.getUint16(0, true);
  const items = itemsOf(view);
  const expected = FORMAT_ITEMS[format];
  const isLayered = format >= FIRST_EXTENDED;
  const isExpected = expected?.every((type, i) => items[i]?.type === type);
  const rest = items.slice(expected?.length);
  const areKnown = rest.every(({ type }) => type === (isLayered ? BYTES14 : BYTES));
  const versions = isLayered ? [3, 4] : [2];
  const areCurrent = items.every(({ version }) => versions.includes(version));
  if (compressor !== (isLayered ? LAYERED : CHUNKED) || !isExpected || !areKnown || !areCurrent) {
    const found = items.map(({ type, version }) => `${type} v${version}`).join(', ');
    throw new FloorPlanError(
      'input/unknown-format',
      `${name}: expected points of format 0 to 3 or 6 to 10, compressed in chunks; found format ${format}, compressor ${compressor}, items ${found || 'none'}`,
      {
        hint: expected
          ? 'Save the cloud as LAS, or as LAZ with a current LASzip.'
          : 'Save the cloud as LAS, or as LAZ without its wave packets: in point format 1 or 3.',
      },
    );
  }
  const itemBytes = items.reduce((sum, { bytes }) => sum + bytes, 0);
  if (itemBytes !== recordBytes)
    throw malformed(
      name,
      RECORD_BYTES_AT,
      `records of the ${itemBytes} bytes that are compressed`,
      recordBytes,
    );
  const chunkPoints = view.getUint32(12, true);
  return {
    layers: isLayered ? items.map(({ type, bytes }) => ITEM_LAYERS[type] ?? bytes) : [],
    chunkPoints: chunkPoints === VARIABLE_CHUNKS ? null : chunkPoints,
  };
}

function itemsOf(view: DataView): Item[] {
  const count = Math.min(view.getUint16(32, true), Math.floor((view.byteLength - FIXED_BYTES) / 6));
  return Array.from({ length: count }, (_, i) => {
    const at = FIXED_BYTES + 6 * i;
    return {
      type: view.getUint16(at, true),
      bytes: view.getUint16(at + 2, true),
      version: view.getUint16(at + 4, true),
    };
  });
}
