import { type FileHandle, mkdir, open, stat } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { simulate } from '../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../fixtures/simulator/layouts.ts';
import { seededRandom } from '../../fixtures/simulator/random.ts';

export const cacheFolder = resolve(import.meta.dirname, '../../.cache/bench');

/** Millimetre noise that sets repeated points of a large cloud apart. */
const JITTER = 0.004;

let home: Float64Array | null = null;

/**
 * A scan of a seeded home, x, y, z a point; a cloud larger than one simulation repeats it with jitter, as a slow
 * scanner repeats itself. Points come in scanning order.
 */
export function* homeCloud(points: number, chunk = 100_000): Generator<Float64Array> {
  home ??= simulate({
    name: 'bench',
    building: homeBuilding(1),
    scan: { voxel: 0, stationsPerRoom: 2 },
  }).positions;
  const random = seededRandom(7, 'bench');
  for (let first = 0; first < points; first += chunk) {
    const size = Math.min(chunk, points - first);
    const part = new Float64Array(size * 3);
    for (let k = 0; k < part.length; k++) {
      const at = first * 3 + k;
      const jitter = at < home.length ? 0 : (random.next() - 0.5) * 2 * JITTER;
      part[k] = home[at % home.length] + jitter;
    }
    yield part;
  }
}

export interface CloudFile {
  readonly path: string;
  readonly bytes: number;
}

/** A cloud as a file in the cache folder, written once, in bounded memory. */
export async function cloudFile(points: number, format: 'ply' | 'csv'): Promise<CloudFile> {
  const path = join(cacheFolder, `home-${points}.${format}`);
  await mkdir(cacheFolder, { recursive: true });
  const known = await stat(path).catch(() => null);
  if (known) return { path, bytes: known.size };
  const file = await open(path, 'w');
  try {
    await (format === 'ply' ? writePly(file, points) : writeCsv(file, points));
  } finally {
    await file.close();
  }
  return { path, bytes: (await stat(path)).size };
}

async function writePly(file: FileHandle, points: number): Promise<void> {
  const properties = ['x', 'y', 'z'].map((axis) => `property float ${axis}\n`).join('');
  await file.write(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${points}\n${properties}end_header\n`,
  );
  for (const part of homeCloud(points)) await file.write(new Uint8Array(new Float32Array(part).buffer));
}

async function writeCsv(file: FileHandle, points: number): Promise<void> {
  await file.write('x,y,z\n');
  for (const part of homeCloud(points)) {
    let text = '';
    for (let i = 0; i < part.length; i += 3) {
      text += `${part[i].toFixed(4)},${part[i + 1].toFixed(4)},${part[i + 2].toFixed(4)}\n`;
    }
    await file.write(text);
  }
}
