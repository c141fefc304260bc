import { ByteCursor } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, PointChunk, ReadProgress } from '../cloud-reader.ts';
import { tooFewBytes } from '../cut-off.ts';
import { type ChunkTable, readChunkTable } from './chunk-table.ts';
import { type LaszipRecord, readLaszipRecord } from './laszip-record.ts';
import { LazDecoder } from './laz-decoder.ts';
import { type LasFile, lasCloud, type ReadCount, readLasFile } from './open-las.ts';

/**
 * Reads the header and the chunk table of a LAZ file; its points are decompressed chunk by chunk while streaming.
 *
 * @throws input/…
 */
export async function openLaz(source: ByteSource): Promise<OpenCloud> {
  return openLazFile(await readLasFile(source));
}

/** As {@link openLaz}, where header and records have been read. */
export async function openLazFile(file: LasFile): Promise<OpenCloud> {
  const { source, header, records } = file;
  const laszip = readLaszipRecord(source.name, header, records);
  const table = await readChunkTable(source, header, laszip);
  return lasCloud(file, (progress) => readChunks(file, laszip, table, progress));
}

async function* readChunks(
  file: LasFile,
  laszip: LaszipRecord,
  table: ChunkTable,
  progress: ReadProgress,
): AsyncGenerator<PointChunk, ReadCount> {
  const { source, header } = file;
  const decoder = await LazDecoder.create(file, laszip);
  const cursor = new ByteCursor(source.stream(), progress);
  const truncated = (needed: number) =>
    tooFewBytes(source.name, { count: header.count, needed }, cursor.offset + cursor.available);
  try {
    if (!(await cursor.skip(table.begin))) throw truncated(table.begin);
    for (let i = 0; i < table.bytes.length; i++) {
      const length = table.bytes[i];
      const offset = cursor.offset;
      if (!(await cursor.fill(length))) throw truncated(offset + length);
      const bytes = cursor.bytes.subarray(cursor.position, cursor.position + length);
      cursor.position += length;
      if (table.points[i] > 0) yield* decoder.decode({ bytes, points: table.points[i], offset });
    }
    yield* decoder.flush();
    return decoder.count;
  } finally {
    await cursor.close();
  }
}
