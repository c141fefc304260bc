import { joinBytes } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { ReadProgress } from '../cloud-reader.ts';
import { BLANK, lineEnd, nextLine } from '../text/characters.ts';
import { lineBlocks } from '../text/line-blocks.ts';

const BACKSLASH = 92;

/** A line without its end, those that go on after a backslash joined. */
export type ReadLine = (bytes: Uint8Array, begin: number, end: number, line: number) => void;

/** Hands on every line of a source. @param read given a line's bytes and number, from 1 @throws input/malformed */
export async function readLines(source: ByteSource, read: ReadLine, progress: ReadProgress): Promise<void> {
  let pending: Uint8Array | null = null;
  let line = 0;
  for await (const { bytes } of lineBlocks(source, 0, progress)) {
    let begin = 0;
    while (begin < bytes.length) {
      const end = lineEnd(bytes, begin);
      line++;
      if (bytes[end - 1] === BACKSLASH && end > begin) {
        pending = join(pending, bytes.subarray(begin, end));
        pending[pending.length - 1] = BLANK;
      } else if (pending) {
        const whole = join(pending, bytes.subarray(begin, end));
        pending = null;
        read(whole, 0, whole.length, line);
      } else {
        read(bytes, begin, end, line);
      }
      begin = nextLine(bytes, end);
    }
  }
  if (pending) read(pending, 0, pending.length, line);
}

function join(before: Uint8Array | null, bytes: Uint8Array): Uint8Array {
  const pieces = before ? [before, bytes] : [bytes];
  return joinBytes(pieces, (before?.length ?? 0) + bytes.length);
}
