import { countOf } from '../../core/count-words.ts';
import type { Warning } from '../../core/types.ts';
import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, PointChunk, ReadProgress } from '../cloud-reader.ts';
import { goOnWith, isWorthReading, tooFewBytes } from '../cut-off.ts';
import { bufferFor } from '../point-buffer.ts';
import { type RecordLayout, readRecords } from '../records.ts';
import { type LasHeader, readLasHeader } from './las-header.ts';
import { type Place, placeOf } from './place.ts';
import { recordLayout } from './point-formats.ts';
import { readVariableRecords, type VariableRecord } from './variable-records.ts';

/** A LAS file, compressed or not, whose header and records are known. */
export interface LasFile {
  readonly source: ByteSource;
  readonly header: LasHeader;
  readonly records: readonly VariableRecord[];
  readonly place: Place;
  /** Of the records as they are decoded. */
  readonly layout: RecordLayout;
}

/** Reads what LAS, LAZ and COPC share. @throws input/… */
export async function readLasFile(source: ByteSource): Promise<LasFile> {
  const header = await readLasHeader(source);
  const records = await readVariableRecords(source, header);
  const place = placeOf(source.name, header, records);
  return { source, header, records, place, layout: recordLayout(header, place.heightRatio) };
}

/** Reads the header of an uncompressed LAS file [ASPRS19]; points are streamed. @throws input/… */
export async function openLas(source: ByteSource): Promise<OpenCloud> {
  const file = await readLasFile(source);
  const { count, pointsBegin, recordBytes } = file.header;
  const needed = pointsBegin + count * recordBytes;
  const { size = Infinity } = source;
  const found = Math.floor((size - pointsBegin) / recordBytes);
  if (found < count && !isWorthReading({ found, announced: count }))
    throw tooFewBytes(source.name, { count, needed }, size);
  return lasCloud(file, (progress, _, warnings) => readPoints(file, progress, warnings));
}

/** A cloud that reads as `chunks` does; withheld points are counted and told when all has been read. */
export function lasCloud(
  { header, place }: LasFile,
  chunks: (
    progress: ReadProgress,
    spacing: number,
    warnings: Warning[],
  ) => AsyncGenerator<PointChunk, ReadCount>,
): OpenCloud {
  const warnings: Warning[] = [...place.warnings];
  return {
    isSlice: false,
    pointsAnnounced: header.count,
    ...(place.unit && { unit: place.unit }),
    ...(place.crs && { crs: place.crs }),
    async *chunks(progress, spacing) {
      const { decoded, kept } = yield* chunks(progress, spacing, warnings);
      const isTold = warnings.some(({ code }) => code === WITHHELD);
      if (decoded > kept && !isTold) warnings.push(withheld(decoded - kept, decoded));
    },
    warnings,
  };
}

/** Points decoded, and those of them handed on. */
export interface ReadCount {
  readonly decoded: number;
  readonly kept: number;
}

const WITHHELD = 'read/withheld-points';

async function* readPoints(
  { source, header, layout }: LasFile,
  progress: ReadProgress,
  warnings: Warning[],
): AsyncGenerator<PointChunk, ReadCount> {
  const { count, pointsBegin, recordBytes } = header;
  const cursor = new ByteCursor(source.stream(), progress);
  const buffer = bufferFor(layout.fields);
  let decoded = count;
  const endEarly = (found: number) => {
    const needed = pointsBegin + count * recordBytes;
    const error = tooFewBytes(source.name, { count, needed }, cursor.offset + cursor.available);
    goOnWith({ found, announced: count }, error, warnings);
    decoded = found;
  };
  let kept = 0;
  try {
    if (!(await cursor.skip(pointsBegin))) endEarly(0);
    for await (const chunk of readRecords({ cursor, layout, count, buffer, endEarly })) {
      kept += chunk.count;
      yield chunk;
    }
    return { decoded, kept };
  } finally {
    await cursor.close();
  }
}

function withheld(left: number, of: number): Warning {
  return {
    code: WITHHELD,
    message: `${left} of ${countOf(of, 'point')} ${left === 1 ? 'is' : 'are'} marked as withheld, that is deleted, and left out.`,
    hint: 'Take the mark off in the program that set it, if they belong to the building.',
  };
}
