import { FloorPlanError } from '../../core/errors.ts';
import { blobSource } from '../bytes/blob-source.ts';
import { firstBytes } from '../bytes/byte-cursor.ts';
import type { ByteSource } from '../bytes/source.ts';
import { HEAD_BYTES } from '../signatures.ts';

/** Kept at hand: enough for any header, so that a format read in order is never unpacked twice. */
const KEPT_BYTES = 16 * HEAD_BYTES;
/** Of all files of an archive together, while each has what tells its format. */
const MOST_KEPT_BYTES = 1 << 26;
/** Of an archive whose format is read out of order, which is then kept whole. */
const MOST_BYTES = 2 ** 31;
/** A blob is made of pieces no smaller. */
const PART_BYTES = 1 << 23;

/** Unpacked bytes, and how far the packed ones have been read. */
export interface UnpackedSource extends ByteSource {
  /** Packed bytes taken by the stream begun last. */
  readonly packedBytesRead: number;
}

export interface Unpacking {
  readonly name: string;
  /** Bytes there will be, where the archive tells. */
  readonly size: number | undefined;
  /** Files in the archive: of many, less of each is kept at hand. */
  readonly files: number;
  /** All bytes in order; tells the packed bytes it takes. */
  unpack(onTaken: (bytes: number) => void): AsyncIterable<Uint8Array>;
}

/**
 * Bytes that come in order only. Their head is kept; whoever wants others out of order has the whole unpacked once,
 * into a Blob, which a browser may keep on disk.
 *
 * @throws input/too-large, from `slice`
 */
export function unpackedSource({ name, size, files, unpack }: Unpacking): UnpackedSource {
  const keptBytes = Math.min(KEPT_BYTES, Math.max(HEAD_BYTES, Math.floor(MOST_KEPT_BYTES / files)));
  let packedBytesRead = 0;
  const all = () =>
    unpack((bytes) => {
      packedBytesRead = bytes;
    });
  let head: Promise<Uint8Array> | null = null;
  let whole: Promise<ByteSource> | null = null;
  return {
    name,
    size,
    isSequential: true,
    get packedBytesRead() {
      return packedBytesRead;
    },
    async *stream() {
      yield* whole ? (await whole).stream() : all();
    },
    async slice(begin, end) {
      head ??= firstBytes(all(), keptBytes);
      const first = await head;
      if (end <= first.length || first.length < keptBytes) return first.slice(begin, end);
      whole ??= unpackWhole(name, all());
      return (await whole).slice(begin, end);
    },
  };
}

async function unpackWhole(name: string, stream: AsyncIterable<Uint8Array>): Promise<ByteSource> {
  const parts: Blob[] = [];
  let pieces: Uint8Array<ArrayBuffer>[] = [];
  let waiting = 0;
  let total = 0;
  for await (const piece of stream) {
    pieces.push(piece as Uint8Array<ArrayBuffer>);
    waiting += piece.length;
    total += piece.length;
    if (total > MOST_BYTES) throw tooLarge(name);
    if (waiting < PART_BYTES) continue;
    parts.push(new Blob(pieces));
    pieces = [];
    waiting = 0;
  }
  return blobSource(new Blob([...parts, ...pieces]), name);
}

function tooLarge(name: string): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected at most ${MOST_BYTES} unpacked bytes of a format that is read out of order, found more`,
    { hint: 'Unpack the archive and load the file itself.' },
  );
}
