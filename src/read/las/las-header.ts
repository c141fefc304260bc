import { FloorPlanError } from '../../core/errors.ts';
import type { Vec3 } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import { cutOffAt, tooFewBytes } from '../cut-off.ts';
import { POINT_FORMATS } from './point-formats.ts';

/** What the header block of a LAS file says [ASPRS19] §2.4. */
export interface LasHeader {
  readonly minor: number;
  /** Whether the CRS is told in WKT; in GeoTIFF keys otherwise. */
  readonly hasWkt: boolean;
  /** Number of the point format, 0 to 10. */
  readonly format: number;
  readonly recordBytes: number;
  readonly headerBytes: number;
  readonly pointsBegin: number;
  readonly count: number;
  readonly scale: Vec3;
  readonly offset: Vec3;
  readonly bounds: { readonly min: Vec3; readonly max: Vec3 };
  readonly records: number;
  /** Records behind the points; LAS 1.4. */
  readonly extended: { readonly begin: number; readonly count: number };
}

const LARGEST_HEADER = 375;
const LEAST_HEADER = [227, 227, 227, 227, LARGEST_HEADER];
const WKT_BIT = 0x10;
/** The bits above mark compressed points. */
const FORMAT_BITS = 0x3f;

/** @throws input/malformed, input/truncated, input/empty, input/unknown-format */
export async function readLasHeader(source: ByteSource): Promise<LasHeader> {
  const head = await source.slice(0, LARGEST_HEADER);
  if (head.length < LEAST_HEADER[0]) throw headerCut(source.name, head.length);
  const view = viewOf(head);
  const minor = versionOf(source.name, view);
  const least = LEAST_HEADER[minor];
  if (head.length < least) throw headerCut(source.name, head.length);
  const header: LasHeader = {
    minor,
    hasWkt: (view.getUint16(6, true) & WKT_BIT) !== 0,
    format: view.getUint8(104) & FORMAT_BITS,
    recordBytes: view.getUint16(105, true),
    headerBytes: view.getUint16(94, true),
    pointsBegin: view.getUint32(96, true),
    count: countOf(view, minor),
    scale: vectorAt(view, 131),
    offset: vectorAt(view, 155),
    bounds: {
      min: [view.getFloat64(187, true), view.getFloat64(203, true), view.getFloat64(219, true)],
      max: [view.getFloat64(179, true), view.getFloat64(195, true), view.getFloat64(211, true)],
    },
    records: view.getUint32(100, true),
    extended:
      minor < 4
        ? { begin: 0, count: 0 }
        : { begin: Number(view.getBigUint64(235, true)), count: view.getUint32(243, true) },
  };
  checkHeader(source, header, least);
  return header;
}

function versionOf(name: string, view: DataView): number {
  const [major, minor] = [view.getUint8(24), view.getUint8(25)];
  if (major === 1 && minor < LEAST_HEADER.length) return minor;
  throw new FloorPlanError(
    'input/unknown-format',
    `${name}: expected LAS 1.0 to 1.4, found version ${major}.${minor} at byte 24`,
    { hint: 'Save the cloud as LAS 1.4.', detail: { offset: 24 } },
  );
}

/** From 1.4 on in 64 bits; some writers fill in the older field alone. */
function countOf(view: DataView, minor: number): number {
  const legacy = view.getUint32(107, true);
  return minor < 4 ? legacy : Number(view.getBigUint64(247, true)) || legacy;
}

function vectorAt(view: DataView, at: number): Vec3 {
  return [view.getFloat64(at, true), view.getFloat64(at + 8, true), view.getFloat64(at + 16, true)];
}

function checkHeader(
  { name, size = Number.POSITIVE_INFINITY }: ByteSource,
  header: LasHeader,
  least: number,
) {
  const { format, recordBytes, headerBytes, pointsBegin, count, scale, offset } = header;
  if (headerBytes < least) throw malformed(name, 94, `a header of at least ${least} bytes`, headerBytes);
  const facts = POINT_FORMATS[format];
  if (!facts) throw malformed(name, 104, 'a point format from 0 to 10', format);
  if (recordBytes < facts.bytes)
    throw malformed(name, 105, `records of at least ${facts.bytes} bytes`, recordBytes);
  if (pointsBegin < headerBytes) throw malformed(name, 96, 'points behind the header', pointsBegin);
  if (!scale.every((factor) => Number.isFinite(factor) && factor !== 0))
    throw malformed(name, 131, 'finite scales other than 0', scale.join(', '));
  if (!offset.every(Number.isFinite)) throw malformed(name, 155, 'finite offsets', offset.join(', '));
  if (!Number.isSafeInteger(count * recordBytes)) throw malformed(name, 247, 'a number of points', count);
  if (count === 0) {
    throw new FloorPlanError('input/empty', `${name}: expected points, found a LAS header that counts none`, {
      hint: 'Export the cloud again, with its points.',
    });
  }
  if (pointsBegin >= size) throw tooFewBytes(name, { count, needed: pointsBegin + 1 }, size);
}

export function malformed(
  name: string,
  offset: number,
  expected: string,
  found: string | number,
): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected ${expected} at byte ${offset}, found ${found}`,
    { hint: 'The file seems damaged; copy or export it again.', detail: { offset } },
  );
}

function headerCut(name: string, size: number): FloorPlanError {
  return cutOffAt(name, 'a LAS header', size);
}
