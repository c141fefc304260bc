import { open, stat } from 'node:fs/promises';
import { basename } from 'node:path';
import { FloorPlanError } from '../core/errors.ts';
import { PIECE_BYTES } from '../read/blob-source.ts';
import type { ByteSource } from '../read/source.ts';

/** Reads a file under Node; a handle is open only while bytes are read. @throws input/unreadable */
export async function nodeSource(path: string): Promise<ByteSource> {
  const facts = await stat(path).catch((cause) => {
    throw unreadable(path, cause);
  });
  if (facts.isDirectory()) throw unreadable(path, new Error('it is a folder'));
  return {
    name: basename(path),
    // Pipes and devices tell no size.
    size: facts.isFile() ? facts.size : undefined,
    stream: () => readAll(path),
    slice: (begin, end) => readRange(path, begin, end),
  };
}

async function* readAll(path: string): AsyncGenerator<Uint8Array> {
  const handle = await openHandle(path);
  try {
    while (true) {
      const piece = new Uint8Array(PIECE_BYTES);
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
