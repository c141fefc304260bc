/** Large enough that the wait for a piece does not show, small enough that memory does not notice. */
export const PIECE_BYTES = 1 << 20;

/** A getter of bytes: a file dropped in a page, a URL, a file under Node. Offsets and sizes in bytes. */
export interface ByteSource {
  /** File name without folders; hints at the format when the content does not tell. */
  readonly name: string;
  /** Undefined where a server does not say. */
  readonly size: number | undefined;
  /** Whether a slice costs all bytes before it, as with a server without ranges: better read once, in order. */
  readonly isSequential?: boolean;
  /** All bytes in order, in chunks of bounded size; may be called again to read once more. */
  stream(): AsyncIterable<Uint8Array>;
  /** Bytes from `begin` up to but without `end`; fewer at the end of the source. */
  slice(begin: number, end: number): Promise<Uint8Array>;
}

/** The first `size` bytes of what can be read in any order, in pieces. */
export async function* inPieces(slice: ByteSource['slice'], size: number): AsyncGenerator<Uint8Array> {
  for (let begin = 0; begin < size; begin += PIECE_BYTES)
    yield await slice(begin, Math.min(size, begin + PIECE_BYTES));
}
