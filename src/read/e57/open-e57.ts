import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud } from '../cloud-reader.ts';
import { readE57Root } from './e57-header.ts';
import { E57Node } from './e57-node.ts';
import { readE57Points } from './e57-points.ts';
import { readE57Scans } from './e57-scans.ts';

/**
 * Reads what an E57 file holds ([E2807], [Huber11]); bounds it states are not looked at, for many are wrong.
 *
 * The scanner of a scan stands in its pose's origin. A file without any pose, cartesian throughout, may be a cloud
 * merged from many scans: it has no stations.
 *
 * @throws input/malformed, input/truncated, input/empty, input/too-large
 */
export async function openE57(source: ByteSource): Promise<OpenCloud> {
  const root = new E57Node(await readE57Root(source), source.name);
  const scans = readE57Scans(root, source.name);
  const hasStations = scans.some(({ pose, prototype }) => pose !== null || prototype.isSpherical);
  const crs = root.child('coordinateMetadata')?.text;
  return {
    isSlice: false,
    unit: 'm',
    ...(crs && { crs }),
    pointsAnnounced: scans.reduce((sum, { count }) => sum + count, 0),
    ...(hasStations && { stations: scans.map(({ pose }) => pose?.translation ?? [0, 0, 0]) }),
    chunks: (progress) => readE57Points(source, { scans, hasStations }, progress),
    warnings: [],
  };
}
