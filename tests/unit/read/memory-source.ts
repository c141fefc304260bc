import type { ByteSource } from '../../../src/read/bytes/source.ts';
import type { OpenCloud, PointChunk } from '../../../src/read/cloud-reader.ts';
import { openScan } from '../../../src/read/open-scan.ts';

export const bytesOf = (text: string) => new TextEncoder().encode(text);

/** Bytes in memory, handed out in pieces of the sizes given in turn. */
export function memorySource(
  content: string | Uint8Array,
  name: string,
  pieces: readonly number[] = [1 << 20],
): ByteSource {
  const bytes = typeof content === 'string' ? bytesOf(content) : content;
  return {
    name,
    size: bytes.length,
    slice: async (begin, end) => bytes.slice(begin, end),
    async *stream() {
      let turn = 0;
      for (let begin = 0; begin < bytes.length; turn++) {
        const end = begin + pieces[turn % pieces.length];
        yield bytes.slice(begin, end);
        begin = end;
      }
    },
  };
}

export interface AllPoints {
  readonly isSlice: boolean;
  readonly xyz: number[][];
  readonly colour: number[][] | undefined;
  readonly intensity: number[] | undefined;
  readonly classification: number[] | undefined;
  readonly station: number[] | undefined;
}

/** Everything a reader finds, as plain arrays. */
export async function readAll(source: ByteSource): Promise<AllPoints> {
  const { cloud } = await openScan([source]);
  return readPoints(cloud);
}

/** The points with the cloud they come from. */
export async function readWhole(source: ByteSource): Promise<AllPoints & { readonly cloud: OpenCloud }> {
  const { cloud } = await openScan([source]);
  return { ...(await readPoints(cloud)), cloud };
}

async function readPoints(cloud: OpenCloud): Promise<AllPoints> {
  const xyz: number[][] = [];
  const colour: number[][] = [];
  const intensity: number[] = [];
  const classification: number[] = [];
  const station: number[] = [];
  let last: PointChunk | undefined;
  for await (const chunk of cloud.chunks(() => {}, 0)) {
    last = chunk;
    for (let i = 0; i < chunk.count; i++) {
      xyz.push([...chunk.xyz.subarray(3 * i, 3 * i + 3)]);
      if (chunk.colour) colour.push([...chunk.colour.subarray(3 * i, 3 * i + 3)]);
      if (chunk.intensity) intensity.push(chunk.intensity[i]);
      if (chunk.classification) classification.push(chunk.classification[i]);
      if (chunk.station) station.push(chunk.station[i]);
    }
  }
  return {
    isSlice: cloud.isSlice,
    xyz,
    colour: last?.colour && colour,
    intensity: last?.intensity && intensity,
    classification: last?.classification && classification,
    station: last?.station && station,
  };
}
