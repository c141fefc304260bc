import { mkdir, readFile, stat, writeFile } from 'node:fs/promises';
import { join } from 'node:path';
import { seededRandom } from '../../fixtures/simulator/random.ts';
import { direction, distance, perimeter, type Ring, type XY } from '../../fixtures/simulator/ring.ts';
import { cacheFolder } from './clouds.ts';

/** Standard deviation of a point in x and y, m. */
const NOISE = 0.01;
/** The building stands askew to every lattice. */
const HEADING = 0.35;

/** Inner faces of the outer walls of an L-shaped flat with a recess and a bay, m. */
const OUTLINE: Ring = [
  [0, 0],
  [7, 0],
  [7, -0.9],
  [9.5, -0.9],
  [9.5, 0],
  [18, 0],
  [18, 8],
  [11, 8],
  [11, 13],
  [6.5, 13],
  [6.5, 11.8],
  [4.2, 11.8],
  [4.2, 13],
  [0, 13],
];
/** Both faces of the walls between five rooms; passages are where none stands. */
const INNER: readonly Ring[] = [
  box(5, 0, 5.12, 4.1),
  box(5, 5, 5.12, 8),
  box(0, 8, 2.2, 8.12),
  box(3.1, 8, 9.6, 8.12),
  box(11, 0, 11.12, 6.3),
  box(11, 7.2, 11.12, 8),
];

/** The truth of {@link wallSlice}: the outline as it stands, m. */
export const wallOutline: Ring = OUTLINE.map(placed);

/**
 * A noisy wall slice of any number of points, x, y each, in no order: uniform along the faces of a flat's walls,
 * Gaussian across and along. As float32, which is what a cloud holds and every method is given.
 */
function wallSlice(points: number, seed = 1): Float32Array {
  const random = seededRandom(seed, 'wall-slice');
  const edges = [OUTLINE, ...INNER].flatMap((ring) =>
    ring.map((from, i) => ({ from: placed(from), to: placed(ring[(i + 1) % ring.length]) })),
  );
  const total = [OUTLINE, ...INNER].reduce((sum, ring) => sum + perimeter(ring), 0);
  const ends: number[] = [];
  for (const { from, to } of edges) ends.push((ends.at(-1) ?? 0) + distance(from, to));
  const units = edges.map(({ from, to }) => direction(from, to));
  const xy = new Float32Array(2 * points);
  for (let i = 0; i < points; i++) {
    const way = random.next() * total;
    let edge = 0;
    while (edge < edges.length - 1 && ends[edge] < way) edge++;
    const back = way - ends[edge];
    const { to } = edges[edge];
    // Both deviates of one Box-Muller pair.
    const radius = NOISE * Math.sqrt(-2 * Math.log(1 - random.next()));
    const angle = 2 * Math.PI * random.next();
    xy[2 * i] = to[0] + units[edge][0] * back + radius * Math.cos(angle);
    xy[2 * i + 1] = to[1] + units[edge][1] * back + radius * Math.sin(angle);
  }
  return xy;
}

/** The slice as raw float32 in the cache folder, made once, so that every method reads the same bytes. */
export async function wallSliceFile(points: number): Promise<string> {
  const path = join(cacheFolder, `walls-${points}.f32`);
  await mkdir(cacheFolder, { recursive: true });
  const known = await stat(path).catch(() => null);
  if (known === null) await writeFile(path, new Uint8Array(wallSlice(points).buffer));
  return path;
}

export async function readWallSlice(path: string): Promise<Float32Array> {
  const bytes = await readFile(path);
  return new Float32Array(bytes.buffer, bytes.byteOffset, bytes.byteLength / 4);
}

function box(x0: number, y0: number, x1: number, y1: number): Ring {
  return [
    [x0, y0],
    [x1, y0],
    [x1, y1],
    [x0, y1],
  ];
}

function placed([x, y]: XY): XY {
  const [cos, sin] = [Math.cos(HEADING), Math.sin(HEADING)];
  return [x * cos - y * sin, x * sin + y * cos];
}
