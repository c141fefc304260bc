import { FloorPlanError } from '../../core/errors.ts';
import type { ByteSource } from './source.ts';

/** Reads a Blob or a File. @throws input/unreadable, when the file has changed or gone since it was picked */
export function blobSource(blob: Blob, name = nameOf(blob)): ByteSource {
  return {
    name,
    size: blob.size,
    slice: async (begin, end) => {
      try {
        return new Uint8Array(await blob.slice(begin, end).arrayBuffer());
      } catch (cause) {
        throw unreadable(name, begin, cause);
      }
    },
    stream: () => streamOf(blob, name),
  };
}

/** A third of the time that slices of a megabyte take in Chromium: the next piece is fetched while nobody asks for it. */
async function* streamOf(blob: Blob, name: string): AsyncGenerator<Uint8Array> {
  // Not every browser iterates over a stream.
  const reader = blob.stream().getReader();
  let received = 0;
  const next = () =>
    reader.read().catch((cause) => {
      throw unreadable(name, received, cause);
    });
  try {
    for (let piece = await next(); !piece.done; piece = await next()) {
      received += piece.value.length;
      yield piece.value;
    }
  } finally {
    // Lets go of the file where reading ends early; one that has failed has done so.
    await reader.cancel().catch(() => {});
  }
}

function unreadable(name: string, offset: number, cause: unknown): FloorPlanError {
  return new FloorPlanError('input/unreadable', `${name}: could not be read from byte ${offset} on`, {
    hint: 'Pick the file again; it may have changed or moved.',
    detail: { offset },
    cause,
  });
}

function nameOf(blob: Blob): string {
  return 'name' in blob && typeof blob.name === 'string' ? blob.name : 'blob';
}
