import { countOf } from '../../core/count-words.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { tooFewRows } from '../cut-off.ts';
import { PointBuffer } from '../point-buffer.ts';
import { latin1 } from '../signatures.ts';
import { lineEnd } from '../text/characters.ts';
import { lineBlocks } from '../text/line-blocks.ts';
import { type RowLayout, RowParser } from '../text/row-parser.ts';
import { IntensityScale } from './intensity-scale.ts';

export interface PtsPoints {
  readonly layout: RowLayout;
  /** Emptied, then filled. */
  readonly warnings: Warning[];
}

/** Points of all scans of a PTS file, a number of points before each. @throws input/malformed, input/truncated */
export async function* readPtsPoints(
  source: ByteSource,
  { layout, warnings }: PtsPoints,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const parser = new RowParser(layout, { name: source.name, line: 1 });
  const buffer = new PointBuffer((field) => layout.targets.includes(field));
  const scale = new IntensityScale();
  const scan = { announced: 0, left: 0 };
  warnings.length = 0;
  for await (const { bytes, isCut } of lineBlocks(source, 0, progress)) {
    let at = parser.seek(bytes, 0);
    while (at < bytes.length) {
      if (scan.left === 0) {
        at = beginScan(scan, bytes, at, parser);
        if (scan.left === Number.POSITIVE_INFINITY) warnings.push(moreThanAnnounced(scan, parser));
      } else {
        at = parser.read(bytes, at, isCut);
        buffer.push(parser.values);
        scan.left--;
        if (buffer.free === 0) yield scale.apply(buffer.take());
      }
      at = parser.seek(bytes, at);
    }
  }
  if (buffer.count > 0) yield scale.apply(buffer.take());
  const { announced, left } = scan;
  if (left > 0 && left < Number.POSITIVE_INFINITY) throw tooFewRows(source.name, announced, announced - left);
}

/** Rows of the present scan: announced, and still to come. */
interface ScanRows {
  announced: number;
  left: number;
}

/** Reads a line with the next scan's number of points; where there is a row instead, all that follow are points. */
function beginScan(scan: ScanRows, bytes: Uint8Array, begin: number, parser: RowParser): number {
  const text = latin1(bytes.subarray(begin, lineEnd(bytes, begin))).trim();
  if (!/^\d+$/.test(text)) {
    scan.left = Number.POSITIVE_INFINITY;
    return begin;
  }
  scan.announced = Number(text);
  scan.left = scan.announced;
  return parser.skipLine(bytes, begin);
}

function moreThanAnnounced({ announced }: ScanRows, { line }: RowParser): Warning {
  return {
    code: 'read/more-than-announced',
    message: `The file announces ${countOf(announced, 'point')} in a scan but has more, from line ${line} on; all were read.`,
    hint: 'If the plan looks wrong, export the cloud again.',
  };
}
