/**
 * `METHOD FILE LENGTH`: one way to an outline on raw float32 points, timed apart from all others; prints a {@link HullRun}
 * as one JSON line. Peers get their points in the form they take, made before the clock starts.
 */
import { createRequire } from 'node:module';
import concaveman from 'concaveman';
import { findBoundary } from '../../src/core/boundary.ts';
import { resolveOptions } from '../../src/core/options.ts';
import { regulariseBoundary } from '../../src/core/regularise.ts';
import { makeSlice } from '../../src/core/slice.ts';
import type { PointCloud } from '../../src/core/types.ts';
import type { HullRun } from './hull-methods.ts';
import { readWallSlice } from './wall-slice.ts';

/** A method is run so often, or until this much time has gone. */
const RUNS = 15;
const ENOUGH_MS = 3_000;
/** Cell of the thinning before concaveman, m. */
const THINNING = 0.02;

type Pair = [x: number, y: number];
type Made = { readonly ring: ArrayLike<number>; readonly openingLength?: number };

const context = {
  warn: () => {},
  progress: () => {},
  strokeTest: () => {
    throw new Error('The primary boundary needs no canvas.');
  },
};

/** Each takes the points as they are read and returns the work to be timed. */
const methods: Record<string, (xy: Float32Array, length: number) => () => Made> = {
  ours: (xy) => chain(xy, 'hull'),
  'ours-noise-off': (xy) => chain(xy, 'noise'),
  'ours-straightened': (xy) => chain(xy, 'all'),
  concaveman(xy) {
    const pairs = toPairs(xy);
    return () => ({ ring: concaveman(pairs, 2).flat() });
  },
  'concaveman-thinned': (xy) => () => ({ ring: concaveman(toPairs(thinned(xy)), 2).flat() }),
  'hull.js'(xy, length) {
    const hull = createRequire(import.meta.url)('hull.js') as (points: Pair[], concavity: number) => Pair[];
    const pairs = toPairs(xy);
    return () => ({ ring: hull(pairs, length).flat() });
  },
};

const [name, path, length] = process.argv.slice(2);
const run = methods[name](await readWallSlice(path), Number(length));
const times: number[] = [];
let cpuMs = Number.POSITIVE_INFINITY;
let made: Made;
do {
  const used = process.cpuUsage();
  const start = performance.now();
  made = run();
  times.push(performance.now() - start);
  const { user, system } = process.cpuUsage(used);
  cpuMs = Math.min(cpuMs, (user + system) / 1000);
} while (times.length < RUNS && times.reduce((sum, ms) => sum + ms, 0) < ENOUGH_MS);
const result: HullRun = {
  firstMs: times[0],
  ms: Math.min(...times),
  cpuMs,
  peakMB: process.resourceUsage().maxRSS / 1024,
  ring: Array.from(made.ring),
  openingLength: made.openingLength ?? 0,
};
console.log(JSON.stringify(result));

/** The chain's part from the points of a level to the outline: up to the hull, to the hull without noise, or to the end. */
function chain(xy: Float32Array, upTo: 'hull' | 'noise' | 'all'): () => Made {
  const positions = new Float32Array((xy.length / 2) * 3);
  for (let i = 0; i < xy.length / 2; i++) positions.set(xy.subarray(2 * i, 2 * i + 2), 3 * i);
  // A flat cloud, as a ready slice becomes: only these two are looked at.
  const cloud = { positions, isFlat: true } as PointCloud;
  const indices = Uint32Array.from({ length: xy.length / 2 }, (_, i) => i);
  const others = { radialPass: false, douglasPeuckerPass: false, visvalingamPass: false, cornerPass: false };
  const options = resolveOptions({ preset: 'building', ...(upTo === 'noise' ? others : {}) });
  return () => {
    const slice = makeSlice(cloud, indices, [0, 0], options);
    const boundary = findBoundary(slice, options, context);
    const { polygons } = upTo === 'hull' ? boundary : regulariseBoundary(boundary, slice, options, context);
    return { ring: polygons[0].outer, openingLength: boundary.openingLength };
  };
}

function toPairs(xy: Float32Array): Pair[] {
  return Array.from({ length: xy.length / 2 }, (_, i): Pair => [xy[2 * i], xy[2 * i + 1]]);
}

/** The first point of each cell of a plain lattice. */
function thinned(xy: Float32Array): Float32Array {
  let [minX, minY, maxX, maxY] = [Infinity, Infinity, -Infinity, -Infinity];
  for (let i = 0; i < xy.length; i += 2) {
    if (xy[i] < minX) minX = xy[i];
    if (xy[i] > maxX) maxX = xy[i];
    if (xy[i + 1] < minY) minY = xy[i + 1];
    if (xy[i + 1] > maxY) maxY = xy[i + 1];
  }
  const columns = Math.floor((maxX - minX) / THINNING) + 1;
  const isTaken = new Uint8Array(columns * (Math.floor((maxY - minY) / THINNING) + 1));
  const kept: number[] = [];
  for (let i = 0; i < xy.length; i += 2) {
    const cell = Math.floor((xy[i + 1] - minY) / THINNING) * columns + Math.floor((xy[i] - minX) / THINNING);
    if (isTaken[cell] === 1) continue;
    isTaken[cell] = 1;
    kept.push(xy[i], xy[i + 1]);
  }
  return Float32Array.from(kept);
}
