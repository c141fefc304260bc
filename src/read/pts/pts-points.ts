import { countOf } from '../../core/count-words.ts';
import type { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { goOnWith, tooFewRows } from '../cut-off.ts';
import { PointBuffer } from '../point-buffer.ts';
import { latin1 } from '../signatures.ts';
import { lineEnd } from '../text/characters.ts';
import { LastRow } from '../text/last-row.ts';
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
  const scan: ScanRows = { announced: 0, left: 0, before: 0 };
  const last = new LastRow();
  let found = 0;
  warnings.length = 0;
  for await (const block of lineBlocks(source, 0, progress)) {
    const { bytes } = block;
    let at = parser.seek(bytes, 0);
    while (at < bytes.length) {
      if (scan.left === 0) {
        at = beginScan(scan, bytes, at, parser);
        if (scan.left === Infinity) warnings.push(moreThanAnnounced(scan, parser));
      } else {
        if (last.isCut(block, at, scan.left, parser)) break;
        at = parser.read(bytes, at, false);
        buffer.push(parser.values);
        found++;
        scan.left--;
        if (buffer.free === 0) yield scale.apply(buffer.take());
      }
      at = parser.seek(bytes, at);
    }
  }
  if (buffer.count > 0) yield scale.apply(buffer.take());
  const error = last.fault ?? faultOf(source.name, scan);
  const announced = scan.left < Infinity ? scan.before + scan.announced : undefined;
  if (error) goOnWith({ found, announced }, error, warnings);
}

/** Rows of the present scan: announced, and still to come. */
interface ScanRows {
  announced: number;
  left: number;
  /** Announced of the scans before. */
  before: number;
}

/** Reads a line with the next scan's number of points; where there is a row instead, all that follow are points. */
function beginScan(scan: ScanRows, bytes: Uint8Array, begin: number, parser: RowParser): number {
  const text = latin1(bytes.subarray(begin, lineEnd(bytes, begin))).trim();
  if (!/^\d+$/.test(text)) {
    scan.left = Infinity;
    return begin;
  }
  scan.before += scan.announced;
  scan.announced = Number(text);
  scan.left = scan.announced;
  return parser.skipLine(bytes, begin);
}

function faultOf(name: string, { announced, left }: ScanRows): FloorPlanError | null {
  return left > 0 && left < Infinity ? tooFewRows(name, announced, announced - left) : null;
}

function moreThanAnnounced({ announced }: ScanRows, { line }: RowParser): Warning {
  return {
    code: 'read/more-than-announced',
    message: `The file announces ${countOf(announced, 'point')} in a scan but has more, from line ${line} on; all were read.`,
    hint: 'If the plan looks wrong, export the cloud again.',
  };
}
