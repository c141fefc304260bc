/**
 * A window that moves over a stream of bytes and never holds more than a piece of the stream and what was asked for.
 *
 * Reading is synchronous while the window holds enough; only {@link fill} and {@link skip} wait.
 */
export class ByteCursor {
  /** The window's bytes; those before `position` are spent. */
  bytes = new Uint8Array(0);
  position = 0;
  readonly #pieces: AsyncIterator<Uint8Array>;
  /** The piece after the last one: fetched while that is used. */
  #ahead: Promise<IteratorResult<Uint8Array>> | null = null;
  /** What {@link fillNarrowly} left over of a piece. */
  #rest: Uint8Array<ArrayBuffer> | null = null;
  readonly #onPiece: (bytesRead: number) => void;
  #received = 0;

  /** @param onPiece called with the number of bytes received so far after each piece */
  constructor(stream: AsyncIterable<Uint8Array>, onPiece: (bytesRead: number) => void) {
    this.#pieces = stream[Symbol.asyncIterator]();
    this.#onPiece = onPiece;
  }

  get available(): number {
    return this.bytes.length - this.position;
  }

  /** Byte offset of `position` in the stream. */
  get offset(): number {
    return this.#received - this.available - (this.#rest?.length ?? 0);
  }

  /** Makes at least `length` bytes available; false where the stream ends before. Complexity: linear in the bytes. */
  async fill(length: number): Promise<boolean> {
    if (this.available >= length) return true;
    const pieces = [this.bytes.subarray(this.position)];
    let total = this.available;
    let isEnd = false;
    while (total < length && !isEnd) {
      const piece = await this.#next();
      isEnd = piece === null;
      if (!piece) break;
      pieces.push(piece);
      total += piece.length;
    }
    this.bytes = total === 0 ? new Uint8Array(0) : joinBytes(pieces, total);
    this.position = 0;
    return !isEnd;
  }

  /** As {@link fill}, without copying whole pieces: what lies in two becomes a window of just `length` bytes. */
  async fillNarrowly(length: number): Promise<boolean> {
    const left = this.available;
    if (left >= length) return true;
    const piece = await this.#next();
    if (!piece) return false;
    const needed = left === 0 ? piece.length : Math.min(length - left, piece.length);
    this.bytes =
      left === 0
        ? piece
        : joinBytes([this.bytes.subarray(this.position), piece.subarray(0, needed)], left + needed);
    this.position = 0;
    if (needed < piece.length) this.#rest = piece.subarray(needed);
    return this.fill(length);
  }

  /** Moves on by `length` bytes; false where the stream ends before. */
  async skip(length: number): Promise<boolean> {
    let left = length - this.available;
    while (left > 0) {
      const piece = await this.#next();
      this.bytes = piece ?? new Uint8Array(0);
      this.position = 0;
      if (!piece) return false;
      if (piece.length >= left) {
        this.position = left;
        return true;
      }
      left -= piece.length;
    }
    this.position += length;
    return true;
  }

  /** Lets the source close what it opened. */
  async close(): Promise<void> {
    await this.#pieces.return?.();
  }

  async #next(): Promise<Uint8Array<ArrayBuffer> | null> {
    if (this.#rest) {
      const rest = this.#rest;
      this.#rest = null;
      return rest;
    }
    const { done, value } = await (this.#ahead ?? this.#pieces.next());
    this.#ahead = null;
    if (done) return null;
    this.#ahead = this.#pieces.next();
    // An error is heard when its turn comes; nobody may be left to hear it.
    this.#ahead.catch(() => {});
    this.#received += value.length;
    this.#onPiece(this.#received);
    return value as Uint8Array<ArrayBuffer>;
  }
}

/** The first `length` bytes of a stream, or all where it is shorter; the rest is not asked for. */
export async function firstBytes(stream: AsyncIterable<Uint8Array>, length: number): Promise<Uint8Array> {
  const pieces: Uint8Array[] = [];
  let total = 0;
  for await (const piece of stream) {
    pieces.push(piece);
    total += piece.length;
    if (total >= length) break;
  }
  return joinBytes(pieces, total).subarray(0, length);
}

/** Bytes of all pieces in one array. */
export function joinBytes(pieces: readonly Uint8Array[], total: number): Uint8Array<ArrayBuffer> {
  const bytes = new Uint8Array(total);
  let offset = 0;
  for (const piece of pieces) {
    bytes.set(piece, offset);
    offset += piece.length;
  }
  return bytes;
}
