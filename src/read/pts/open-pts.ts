import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud } from '../cloud-reader.ts';
import { HEAD_BYTES } from '../signatures.ts';
import { CSV_FORMAT } from '../text/csv.ts';
import { layOutPts } from './pts-layout.ts';
import { readPtsPoints } from './pts-points.ts';

/** A file without a number of points in its first line is a text table. @throws input/empty, input/malformed */
export async function openPts(source: ByteSource): Promise<OpenCloud> {
  const layout = layOutPts(await source.slice(0, HEAD_BYTES));
  if (!layout) return CSV_FORMAT.open(source);
  const warnings: Warning[] = [];
  return {
    isSlice: false,
    chunks: (progress) => readPtsPoints(source, { layout, warnings }, progress),
    warnings,
  };
}
