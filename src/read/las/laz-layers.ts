import { countOf } from '../../core/count-words.ts';
import { viewOf } from '../bytes/view-of.ts';
import { malformed } from './las-header.ts';
import type { LaszipRecord } from './laszip-record.ts';
import { POINT_FORMATS } from './point-formats.ts';

/** Layers of the point itself: x and y, z, class, flags, intensity; then scan angle, user data, source, time. */
const POINT_LAYERS = 9;
const USED_POINT_LAYERS = 5;

/** A chunk on its way through the decoder. */
export interface LazChunk {
  readonly bytes: Uint8Array;
  readonly points: number;
  /** Byte offset in the file, for messages. */
  readonly offset: number;
}

/** Which layers of a chunk are handed to the decoder. */
export interface WantedLayers {
  /** Layers there are. */
  readonly layers: number;
  /** Layers the decoder expects; of these only the used ones keep their bytes. */
  readonly expected: number;
  /** Bytes of the first point, which stands as it is. */
  readonly firstBytes: number;
}

/** @param format 6, or 7 with colour: what the chunk becomes */
export function wantedLayers({ layers }: LaszipRecord, format: number): WantedLayers {
  return {
    layers: layers.reduce((sum, count) => sum + count, 0),
    expected: format === 7 ? POINT_LAYERS + 1 : POINT_LAYERS,
    firstBytes: POINT_FORMATS[format].bytes,
  };
}

/**
 * Writes a chunk of point format 6 to 10 as one of format 6 or 7, without the layers no plan needs: a layer of no bytes
 * keeps its first value, by LASzip's own rule. Saves half the time, and opens formats the decoder does not know.
 *
 * A chunk is: first point, number of points, bytes of each layer, the layers.
 *
 * @throws input/malformed where layers are larger than the chunk
 */
export function writeWantedLayers(
  { bytes, points, offset }: LazChunk,
  { name, recordBytes, layers, expected, firstBytes }: WantedLayers & { name: string; recordBytes: number },
  to: Uint8Array,
): void {
  const from = viewOf(bytes);
  const into = viewOf(to);
  const sizesAt = recordBytes + 4;
  let source = sizesAt + 4 * layers;
  if (source > bytes.length)
    throw malformed(name, offset, `a chunk of ${source} bytes or more`, bytes.length);
  const counted = from.getUint32(recordBytes, true);
  if (counted !== points)
    throw malformed(name, offset + recordBytes, `${countOf(points, 'point')} in a chunk`, counted);
  to.fill(0);
  to.set(bytes.subarray(0, firstBytes));
  into.setUint32(firstBytes, points, true);
  let target = firstBytes + 4 + 4 * expected;
  for (let layer = 0; layer < layers; layer++) {
    const size = from.getUint32(sizesAt + 4 * layer, true);
    if (source + size > bytes.length)
      throw malformed(
        name,
        offset + sizesAt + 4 * layer,
        `a layer of at most ${bytes.length - source} bytes`,
        size,
      );
    if (layer < USED_POINT_LAYERS || (layer >= POINT_LAYERS && layer < expected)) {
      into.setUint32(firstBytes + 4 + 4 * layer, size, true);
      to.set(bytes.subarray(source, source + size), target);
      target += size;
    }
    source += size;
  }
}
