import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { goOnWith, tellOfMore, tooFewRows } from '../cut-off.ts';
import { BLUE, type ColourRange, PointBuffer, RED } from '../point-buffer.ts';
import { LastRow } from './last-row.ts';
import { lineBlocks } from './line-blocks.ts';
import { type RowLayout, RowParser } from './row-parser.ts';

/** How a whole colour, 0xAARRGGBB, is written: as an integer, or as the 32-bit float of the same bits. */
export type PackedColour = 'integer' | 'float-bits';

/** Rows of points somewhere in a text file. */
export interface TextPoints {
  readonly layout: RowLayout;
  /** Byte offset of the first line. */
  readonly begin: number;
  /** Number of the first line, counted from 1. */
  readonly line: number;
  /** Rows of other things before the points. */
  readonly rowsBefore?: number;
  /** Points announced; without it they go to the end of the file. */
  readonly rows?: number;
  /** Nothing should come after them. */
  readonly endsWithRows?: boolean;
  readonly colourRange?: ColourRange;
  /** The column of red holds the whole colour. */
  readonly packedColour?: PackedColour;
  /** Where to say that only what is whole was read. */
  readonly warnings: Warning[];
}

/** Points of a text file, one a line. @throws input/malformed, input/truncated */
export async function* readTextPoints(
  source: ByteSource,
  text: TextPoints,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const { layout, begin, line, rowsBefore = 0, rows = Infinity, packedColour, warnings } = text;
  const parser = new RowParser(layout, { name: source.name, line });
  const unpack = packedColour && colourUnpacker(packedColour);
  const columnOf = (field: number) => (unpack && field > RED && field <= BLUE ? RED : field);
  const buffer = new PointBuffer((field) => layout.targets.includes(columnOf(field)), text.colourRange);
  const last = new LastRow();
  let before = rowsBefore;
  let found = 0;
  for await (const block of lineBlocks(source, begin, progress)) {
    const { bytes } = block;
    let at = parser.seek(bytes, 0);
    while (at < bytes.length && found < rows) {
      if (before > 0) {
        at = parser.skipLine(bytes, at);
        before--;
      } else {
        if (last.isCut(block, at, rows - found, parser)) break;
        at = parser.read(bytes, at, false);
        unpack?.(parser.values);
        buffer.push(parser.values);
        found++;
        if (buffer.free === 0) yield buffer.take();
      }
      at = parser.seek(bytes, at);
    }
    if (found < rows) continue;
    if (!text.endsWithRows) break;
    if (at === bytes.length) continue;
    tellOfMore(rows, warnings);
    break;
  }
  if (buffer.count > 0) yield buffer.take();
  const announced = rows < Infinity ? rows : undefined;
  const isShort = announced !== undefined && found < announced;
  const error = last.fault ?? (isShort ? tooFewRows(source.name, announced, found) : null);
  if (error) goOnWith({ found, announced }, error, warnings);
}

/** Spreads the colour in the place of red over red, green and blue. */
function colourUnpacker(packed: PackedColour): (values: Float64Array) => void {
  const float = new Float32Array(1);
  const bits = new Uint32Array(float.buffer);
  return (values) => {
    if (packed === 'integer') bits[0] = values[RED];
    else float[0] = values[RED];
    values[RED] = (bits[0] >>> 16) & 255;
    values[RED + 1] = (bits[0] >>> 8) & 255;
    values[BLUE] = bits[0] & 255;
  };
}
