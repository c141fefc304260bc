import type { ByteSource } from '../bytes/source.ts';
import type { PointChunk, ReadProgress } from '../cloud-reader.ts';
import { tooFewRows } from '../cut-off.ts';
import { BLUE, type ColourRange, PointBuffer, RED } from '../point-buffer.ts';
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
  readonly colourRange?: ColourRange;
  /** The column of red holds the whole colour. */
  readonly packedColour?: PackedColour;
}

/** Points of a text file, one a line. @throws input/malformed, input/truncated */
export async function* readTextPoints(
  source: ByteSource,
  {
    layout,
    begin,
    line,
    rowsBefore = 0,
    rows = Number.POSITIVE_INFINITY,
    colourRange,
    packedColour,
  }: TextPoints,
  progress: ReadProgress,
): AsyncGenerator<PointChunk> {
  const parser = new RowParser(layout, { name: source.name, line });
  const unpack = packedColour && colourUnpacker(packedColour);
  const columnOf = (field: number) => (unpack && field > RED && field <= BLUE ? RED : field);
  const buffer = new PointBuffer((field) => layout.targets.includes(columnOf(field)), colourRange);
  let before = rowsBefore;
  let left = rows;
  for await (const { bytes, isCut } of lineBlocks(source, begin, progress)) {
    let at = parser.seek(bytes, 0);
    while (at < bytes.length && left > 0) {
      if (before > 0) {
        at = parser.skipLine(bytes, at);
        before--;
      } else {
        at = parser.read(bytes, at, isCut);
        unpack?.(parser.values);
        buffer.push(parser.values);
        left--;
        if (buffer.free === 0) yield buffer.take();
      }
      at = parser.seek(bytes, at);
    }
    if (left === 0) break;
  }
  if (buffer.count > 0) yield buffer.take();
  if (left > 0 && left < Number.POSITIVE_INFINITY) throw tooFewRows(source.name, rows, rows - left);
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
