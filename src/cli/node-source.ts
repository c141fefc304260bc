import { open, stat } from 'node:fs/promises';
import { basename } from 'node:path';
import { FloorPlanError } from '../core/errors.ts';
import { blobSource } from '../read/bytes/blob-source.ts';
import { type ByteSource, PIECE_BYTES } from '../read/bytes/source.ts';

/** Of a pipe, which is kept whole in memory. */
const MAX_PIPE_BYTES = 2 ** 31;

/**
 * Reads a file under Node; a handle is open only while bytes are read. A pipe gives its bytes once, so they are kept.
 *
 * @param signal ends the reading of a pipe
 * @throws input/unreadable; for a pipe input/too-large, cancelled
 */
export async function nodeSource(path: string, signal?: AbortSignal): Promise<ByteSource> {
  const facts = await stat(path).catch((cause) => {
    throw unreadable(path, cause);
  });
  if (facts.isDirectory()) throw unreadable(path, new Error('it is a folder'));
  if (facts.isFIFO()) return blobSource(await readPipe(path, signal), basename(path));
  return {
    name: basename(path),
    // Devices tell no size.
    size: facts.isFile() ? facts.size : undefined,
    stream: () => readAll(path),
    slice: (begin, end) => readRange(path, begin, end),
  };
}

async function readPipe(path: string, signal?: AbortSignal): Promise<Blob> {
  const pieces: Uint8Array<ArrayBuffer>[] = [];
  let bytes = 0;
  for await (const piece of readAll(path)) {
    if (signal?.aborted) throw new FloorPlanError('cancelled', 'Reading was cancelled.');
    bytes += piece.length;
    if (bytes > MAX_PIPE_BYTES) throw pipeTooLong(path);
    pieces.push(piece.slice());
  }
  return new Blob(pieces);
}

async function* readAll(path: string): AsyncGenerator<Uint8Array<ArrayBuffer>> {
  const handle = await openHandle(path);
  try {
    while (true) {
      // Not wiped: what is not read is cut off.
      const piece = new Uint8Array(Buffer.allocUnsafeSlow(PIECE_BYTES).buffer);
      const { bytesRead } = await handle.read(piece, 0, PIECE_BYTES, null).catch((cause) => {
        throw unreadable(path, cause);
      });
      if (bytesRead === 0) return;
      yield piece.subarray(0, bytesRead);
    }
  } finally {
    await handle.close();
  }
}

async function readRange(path: string, begin: number, end: number): Promise<Uint8Array> {
  const handle = await openHandle(path);
  try {
    const bytes = new Uint8Array(Math.max(0, end - begin));
    let filled = 0;
    while (filled < bytes.length) {
      const { bytesRead } = await handle.read(bytes, filled, bytes.length - filled, begin + filled);
      if (bytesRead === 0) break;
      filled += bytesRead;
    }
    return bytes.subarray(0, filled);
  } catch (cause) {
    throw unreadable(path, cause);
  } finally {
    await handle.close();
  }
}

function openHandle(path: string) {
  return open(path, 'r').catch((cause) => {
    throw unreadable(path, cause);
  });
}

function unreadable(path: string, cause: unknown): FloorPlanError {
  const reason = cause instanceof Error ? cause.message : String(cause);
  return new FloorPlanError('input/unreadable', `expected a readable file at ${path}, found: ${reason}`, {
    hint: 'Check the path and your permission to read it.',
    detail: { path },
    cause,
  });
}

function pipeTooLong(path: string): FloorPlanError {
  return new FloorPlanError(
    'input/too-large',
    `${path}: expected at most ${MAX_PIPE_BYTES} bytes from a pipe, found more`,
    { hint: 'Save them to a file and name that.', detail: { path } },
  );
}
