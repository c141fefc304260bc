import { FloorPlanError } from '../../core/errors.ts';
import { ByteCursor, joinBytes } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import { HEAD_BYTES } from '../signatures.ts';
import { CARRIAGE_RETURN, isLineEnd, LINE_FEED, lineEnd, nextLine } from './characters.ts';

/** No table of points has longer lines; a file of other bytes would be read to its end for one. */
const MAX_LINE_BYTES = 1 << 20;

/** Whole lines, each ended by LF, CRLF or CR. */
export interface LineBlock {
  readonly bytes: Uint8Array;
  /** The file ended without an end of line; one was added. */
  readonly isCut: boolean;
}

/**
 * The lines of a source from a byte offset on, in blocks of about the source's pieces.
 *
 * @throws input/malformed, where a line is longer than 1 MiB
 */
export async function* lineBlocks(
  source: ByteSource,
  begin: number,
  onPiece: (bytesRead: number) => void,
): AsyncGenerator<LineBlock> {
  const cursor = new ByteCursor(source.stream(), onPiece);
  try {
    if (!(await cursor.skip(begin))) return;
    while (await cursor.fill(cursor.available + 1)) {
      const window = cursor.bytes.subarray(cursor.position);
      const length = endOfLines(window);
      if (window.length - length > MAX_LINE_BYTES) throw lineTooLong(source.name, cursor.offset + length);
      if (length > 0) yield { bytes: window.subarray(0, length), isCut: false };
      cursor.position += length;
    }
    const rest = cursor.bytes.subarray(cursor.position);
    if (rest.length > 0) yield lastLines(rest);
  } finally {
    await cursor.close();
  }
}

/** Up to and with the last end of line; a CR at the very end waits, for its LF may follow. */
function endOfLines(bytes: Uint8Array): number {
  const feed = bytes.lastIndexOf(LINE_FEED);
  if (feed >= 0) return feed + 1;
  return bytes.subarray(0, -1).lastIndexOf(CARRIAGE_RETURN) + 1;
}

function lastLines(rest: Uint8Array): LineBlock {
  if (isLineEnd(rest[rest.length - 1])) return { bytes: rest, isCut: false };
  return { bytes: joinBytes([rest, Uint8Array.of(LINE_FEED)], rest.length + 1), isCut: true };
}

function lineTooLong(name: string, offset: number): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected lines of numbers, found a line of more than ${MAX_LINE_BYTES} bytes at byte ${offset}`,
    { hint: 'Check that the file is plain text with one point a line.', detail: { offset } },
  );
}

/** Begin and end of each line of a short text, without its end of line. */
export function* splitLines(bytes: Uint8Array): Generator<readonly [begin: number, end: number]> {
  let begin = 0;
  while (begin < bytes.length) {
    const end = lineEnd(bytes, begin);
    yield [begin, end];
    begin = nextLine(bytes, end);
  }
}

/** The first bytes of a file without a last line that their end cuts through. */
export function wholeLines(head: Uint8Array, limit = HEAD_BYTES): Uint8Array {
  if (head.length < limit) return head;
  const end = Math.max(head.lastIndexOf(LINE_FEED), head.lastIndexOf(CARRIAGE_RETURN));
  return end < 0 ? head : head.subarray(0, end + 1);
}
