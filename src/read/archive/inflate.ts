import { FloorPlanError } from '../../core/errors.ts';

/** Packed scans grow 2 to 20 times; what grows more than this once {@link TRIED_BYTES} are out fills disks on purpose. */
const MOST_GROWTH = 200;
const TRIED_BYTES = 1 << 26;

export interface PackedBytes {
  /** For messages. */
  readonly name: string;
  /** Bytes that come out, where the archive tells. */
  readonly unpackedSize?: number;
  /** The packed bytes in order, in chunks of bounded size. */
  stream(): AsyncIterable<Uint8Array>;
  readonly method: 'gzip' | 'deflate-raw';
  /** Packed bytes taken so far, of the stream begun last. */
  onTaken(bytes: number): void;
}

/**
 * Unpacks a stream with the platform's own DecompressionStream; memory is bounded by its queues.
 *
 * @throws input/malformed, input/too-large; what the source throws
 */
export async function* inflate(packed: PackedBytes): AsyncGenerator<Uint8Array> {
  const unpacking = new DecompressionStream(packed.method);
  const feeder = feed(packed.stream(), unpacking.writable.getWriter(), packed.onTaken);
  const reader = unpacking.readable.getReader();
  let unpacked = 0;
  let isDone = false;
  try {
    while (true) {
      const { done, value } = await reader.read().catch((cause) => {
        throw feeder.failure ?? cannotUnpack(packed, feeder.taken, cause);
      });
      if (done) break;
      unpacked += value.length;
      if (unpacked > TRIED_BYTES && unpacked > MOST_GROWTH * feeder.taken) throw tooMuch(packed, unpacked);
      yield value;
    }
    isDone = true;
    if (packed.unpackedSize !== undefined && unpacked !== packed.unpackedSize)
      throw wrongSize(packed, unpacked);
  } finally {
    if (!isDone) await reader.cancel().catch(() => undefined);
    await feeder.ended;
  }
}

interface Feeder {
  /** Bytes handed to the unpacking. */
  taken: number;
  /** What the packed stream itself threw. */
  failure: unknown;
  /** Settles when the packed stream is let go of; never rejects. */
  ended: Promise<void>;
}

function feed(
  pieces: AsyncIterable<Uint8Array>,
  writer: WritableStreamDefaultWriter<BufferSource>,
  onTaken: (bytes: number) => void,
): Feeder {
  const feeder: Feeder = { taken: 0, failure: null, ended: Promise.resolve() };
  const pump = async () => {
    for await (const piece of pieces) {
      feeder.taken += piece.length;
      onTaken(feeder.taken);
      // Rejects where the bytes make no sense, and where the reader has gone: the reader knows.
      await writer.ready;
      await writer.write(piece as Uint8Array<ArrayBuffer>);
    }
    await writer.close();
  };
  feeder.ended = pump().catch(async (cause) => {
    if (cause instanceof FloorPlanError) feeder.failure = cause;
    await writer.abort(cause).catch(() => undefined);
  });
  writer.closed.catch(() => undefined);
  return feeder;
}

function cannotUnpack({ name }: PackedBytes, taken: number, cause: unknown): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected packed bytes that make sense, found none by byte ${taken}`,
    {
      hint: 'The archive seems damaged or cut off; copy it or pack it again.',
      detail: { offset: taken },
      cause,
    },
  );
}

function wrongSize({ name, unpackedSize }: PackedBytes, unpacked: number): FloorPlanError {
  return new FloorPlanError(
    'input/malformed',
    `${name}: expected ${unpackedSize} unpacked bytes as the archive says, found ${unpacked}`,
    { hint: 'The archive seems damaged; copy it or pack it again.', detail: { unpacked } },
  );
}

function tooMuch({ name }: PackedBytes, unpacked: number): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${name}: expected an archive that grows at most ${MOST_GROWTH} times, found more after ${unpacked} bytes`,
    { hint: 'No scan packs so small; unpack it yourself if you trust it.', detail: { unpacked } },
  );
}
