import type { ByteCursor } from '../bytes/byte-cursor.ts';

/** A literal run: 1 byte and up to 32 of text. A reference into what was written: 2 or 3 bytes for up to 264. */
const LONGEST_TOKEN = 33;
const LONGEST_RUN = 264;
const SHORTEST_LONG_TOKEN = 3;

/** No LZF text of so many bytes can grow to more than this. */
export function mostInflated(bytes: number): number {
  return Math.ceil(bytes / SHORTEST_LONG_TOKEN) * LONGEST_RUN;
}

/**
 * Decodes `length` bytes of LZF, the format of Marc Lehmann's liblzf, as they come; nothing but the result is held.
 *
 * @param into exactly as long as the decoded text
 * @returns bytes written before the text was wrong or over: those of `into` where all is well
 * @throws what `truncated` makes, where the stream ends too soon
 */
export async function inflateLzf(
  cursor: ByteCursor,
  length: number,
  into: Uint8Array,
  truncated: () => Error,
): Promise<number> {
  let left = length;
  let written = 0;
  while (left > 0) {
    if (!(await cursor.fill(Math.min(left, LONGEST_TOKEN)))) throw truncated();
    const begin = cursor.position;
    const end = begin + Math.min(left, cursor.available);
    // The last token of a window may be cut; at the end of the text none may be.
    const lastStart = end - begin === left ? end - 1 : end - LONGEST_TOKEN;
    const step = inflateTokens({ bytes: cursor.bytes, begin, end, lastStart }, into, written);
    cursor.position = step.position;
    left -= step.position - begin;
    written = step.written;
    if (step.isWrong) return written;
  }
  return written;
}

interface LzfWindow {
  readonly bytes: Uint8Array;
  readonly begin: number;
  readonly end: number;
  /** Tokens that begin after this wait. */
  readonly lastStart: number;
}

function inflateTokens({ bytes, begin, end, lastStart }: LzfWindow, into: Uint8Array, from: number) {
  let at = begin;
  let to = from;
  while (at <= lastStart) {
    const control = bytes[at++];
    if (control < 32) {
      const run = control + 1;
      if (at + run > end || to + run > into.length) return { position: at, written: to, isWrong: true };
      for (let i = 0; i < run; i++) into[to++] = bytes[at++];
      continue;
    }
    let run = (control >> 5) + 2;
    if (run === 9) run += bytes[at++];
    let back = to - ((control & 31) << 8) - bytes[at++] - 1;
    if (at > end || back < 0 || to + run > into.length) return { position: at, written: to, isWrong: true };
    // Byte by byte: a run may reach into itself.
    for (let i = 0; i < run; i++) into[to++] = into[back++];
  }
  return { position: at, written: to, isWrong: false };
}
