import { execFile } from 'node:child_process';
import { type FileHandle, mkdir, open, rename, rm, stat } from 'node:fs/promises';
import { join, resolve } from 'node:path';
import { promisify } from 'node:util';
import { simulate } from '../../fixtures/simulator/index.ts';
import { homeBuilding } from '../../fixtures/simulator/layouts.ts';
import { seededRandom } from '../../fixtures/simulator/random.ts';

export const cacheFolder = resolve(import.meta.dirname, '../../.cache/bench');

/** With numpy, laspy and pye57 for the formats that independent software writes. */
export const python = process.env.PYTHON ?? 'python3';
const run = promisify(execFile);

const FULL_PLY_BYTES = 31;
const LAS_HEADER_BYTES = 227;
const LAS_POINT_BYTES = 26;
/** m. */
const LAS_STEP = 0.0001;

/** Millimetre noise that sets repeated points of a large cloud apart. */
const JITTER = 0.004;

let home: Float64Array | null = null;

/**
 * A scan of a seeded home, x, y, z a point; a cloud larger than one simulation repeats it with jitter, as a slow
 * scanner repeats itself. Points come in scanning order.
 */
function* homeCloud(points: number, chunk = 100_000): Generator<Float64Array> {
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

/** How a cloud may lie in a file; `ply-full` as exporters write it: double x, y, z, uchar colours, float intensity. */
export type CloudFormat = keyof typeof WRITERS;

/** A cloud as a file in the cache folder, written once, in bounded memory. */
export async function cloudFile(points: number, format: CloudFormat): Promise<CloudFile> {
  const { write, suffix } = WRITERS[format];
  return cached(`home-${points}${suffix}`, async (path) => {
    const file = await open(path, 'w');
    try {
      await write(file, points);
    } finally {
      await file.close();
    }
  });
}

/** A cloud as LAZ or E57, by the Python that {@link python} is. @throws where laspy or pye57 is missing */
export async function foreignFile(points: number, format: 'laz' | 'e57'): Promise<CloudFile> {
  const { path: source } = await cloudFile(points, 'ply');
  return cached(`home-${points}.${format}`, async (path) => {
    await run(python, [resolve(import.meta.dirname, 'peers/convert.py'), source, path]);
  });
}

async function cached(name: string, write: (path: string) => Promise<void>): Promise<CloudFile> {
  const path = join(cacheFolder, name);
  await mkdir(cacheFolder, { recursive: true });
  const known = await stat(path).catch(() => null);
  if (known) return { path, bytes: known.size };
  // Under another name until it is whole.
  const part = join(cacheFolder, `part-${process.pid}-${name}`);
  try {
    await write(part);
    await rename(part, path);
  } finally {
    await rm(part, { force: true });
  }
  return { path, bytes: (await stat(path)).size };
}

const WRITERS = {
  ply: { write: writePly, suffix: '.ply' },
  'ply-shuffled': { write: writeShuffledPly, suffix: '-shuffled.ply' },
  'ply-full': { write: writeFullPly, suffix: '-full.ply' },
  csv: { write: writeCsv, suffix: '.csv' },
  las: { write: writeLas, suffix: '.las' },
} as const;

async function writePly(file: FileHandle, points: number): Promise<void> {
  await file.write(plyHeader(points, ['float x', 'float y', 'float z']));
  for (const part of homeCloud(points)) await file.write(new Uint8Array(new Float32Array(part).buffer));
}

/** Every point somewhere else than the one before, as no scanner writes it; held in memory whole. */
async function writeShuffledPly(file: FileHandle, points: number): Promise<void> {
  await file.write(plyHeader(points, ['float x', 'float y', 'float z']));
  const xyz = new Float32Array(3 * points);
  let at = 0;
  for (const part of homeCloud(points)) {
    xyz.set(part, at);
    at += part.length;
  }
  const random = seededRandom(8, 'shuffle');
  for (let i = points - 1; i > 0; i--) {
    const j = Math.floor(random.next() * (i + 1));
    const [own, other] = [xyz.slice(3 * i, 3 * i + 3), xyz.slice(3 * j, 3 * j + 3)];
    xyz.set(other, 3 * i);
    xyz.set(own, 3 * j);
  }
  await file.write(new Uint8Array(xyz.buffer));
}

async function writeFullPly(file: FileHandle, points: number): Promise<void> {
  const colours = ['red', 'green', 'blue'].map((name) => `uchar ${name}`);
  await file.write(plyHeader(points, ['double x', 'double y', 'double z', ...colours, 'float intensity']));
  for (const part of homeCloud(points)) {
    const view = new DataView(new ArrayBuffer((part.length / 3) * FULL_PLY_BYTES));
    for (let i = 0; i < part.length / 3; i++) {
      const at = i * FULL_PLY_BYTES;
      for (let axis = 0; axis < 3; axis++) {
        const value = part[3 * i + axis];
        view.setFloat64(at + 8 * axis, value, true);
        view.setUint8(at + 24 + axis, 128 + 60 * Math.sin(value));
      }
      view.setFloat32(at + 27, 0.5 + 0.2 * Math.sin(3 * part[3 * i]), true);
    }
    await file.write(new Uint8Array(view.buffer));
  }
}

function plyHeader(points: number, properties: readonly string[]): string {
  const lines = properties.map((property) => `property ${property}\n`).join('');
  return `ply\nformat binary_little_endian 1.0\nelement vertex ${points}\n${lines}end_header\n`;
}

/** LAS 1.2 of point format 2: x, y, z, intensity, returns and colours, 26 bytes a point. */
async function writeLas(file: FileHandle, points: number): Promise<void> {
  const header = new DataView(new ArrayBuffer(LAS_HEADER_BYTES));
  new TextEncoder().encodeInto('LASF', new Uint8Array(header.buffer));
  header.setUint8(24, 1);
  header.setUint8(25, 2);
  header.setUint16(94, LAS_HEADER_BYTES, true);
  header.setUint32(96, LAS_HEADER_BYTES, true);
  header.setUint8(104, 2);
  header.setUint16(105, LAS_POINT_BYTES, true);
  header.setUint32(107, points, true);
  for (let axis = 0; axis < 3; axis++) header.setFloat64(131 + 8 * axis, LAS_STEP, true);
  await file.write(new Uint8Array(header.buffer));
  for (const part of homeCloud(points)) {
    const view = new DataView(new ArrayBuffer((part.length / 3) * LAS_POINT_BYTES));
    for (let i = 0; i < part.length; i++) {
      const at = Math.floor(i / 3) * LAS_POINT_BYTES;
      view.setInt32(at + 4 * (i % 3), Math.round(part[i] / LAS_STEP), true);
      view.setUint16(at + 20 + 2 * (i % 3), 256 * Math.round(128 + 60 * Math.sin(part[i])), true);
    }
    await file.write(new Uint8Array(view.buffer));
  }
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
