import { FloorPlanError } from '../../core/errors.ts';
import { type ByteSource, inPieces } from './source.ts';

/** Reads a Blob or a File. @throws input/unreadable, when the file has changed or gone since it was picked */
export function blobSource(blob: Blob, name = nameOf(blob)): ByteSource {
  const slice = async (begin: number, end: number): Promise<Uint8Array> => {
    try {
      return new Uint8Array(await blob.slice(begin, end).arrayBuffer());
    } catch (cause) {
      throw new FloorPlanError('input/unreadable', `${name}: could not be read from byte ${begin} on`, {
        hint: 'Pick the file again; it may have changed or moved.',
        detail: { offset: begin },
        cause,
      });
    }
  };
  return {
    name,
    size: blob.size,
    slice,
    stream: () => inPieces(slice, blob.size),
  };
}

function nameOf(blob: Blob): string {
  return 'name' in blob && typeof blob.name === 'string' ? blob.name : 'blob';
}
