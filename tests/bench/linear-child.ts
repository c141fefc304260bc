/**
 * `TILE COPIES`: the whole chain on a building of so many copies of a tile, apart from all others; prints a
 * {@link LinearRun} as one JSON line. Bundled before it runs, as the product is.
 */
import { readFile } from 'node:fs/promises';
import { basename } from 'node:path';
import { createStrokeTest } from '../../src/cli/canvas-stroke.ts';
import type { ByteSource } from '../../src/read/bytes/source.ts';
import { Session } from '../../src/session/session.ts';

/** What a size's own process says of itself. */
export interface LinearRun {
  /** The first run on one tile, with everything still to be compiled: the clock's time. */
  readonly firstMs: number;
  /** Then the run on all copies: the clock's time, and processor time. */
  readonly wallMs: number;
  readonly cpuMs: number;
  readonly kept: number;
  readonly stages: readonly StageRun[];
}

export interface StageRun {
  readonly name: string;
  /** Processor time: other work on the machine hardly lengthens it. */
  readonly cpuMs: number;
  /** The process's largest memory until the stage's end. */
  readonly peakMB: number;
  readonly outcome: string;
}

const POINT_BYTES = 12;
/** Of a piece of the file: whole points, about a megabyte. */
const PIECE_VALUES = 3 << 16;
/** What is kept of a tile must not depend on how many there are. */
const OPTIONS = { pointBudget: 50_000_000 };

const [path, copies, width, depth] = [process.argv[2], ...process.argv.slice(3).map(Number)];
const bytes = await readFile(path);
const tile = new Float32Array(bytes.buffer, bytes.byteOffset, bytes.length / 4);

/** Copies side by side in rows, about as many rows as columns, as a PLY that is made while it is read. */
function building(count: number): ByteSource {
  const columns = Math.ceil(Math.sqrt(count));
  const points = (count * tile.length) / 3;
  const properties = ['x', 'y', 'z'].map((name) => `property float ${name}\n`).join('');
  const header = new TextEncoder().encode(
    `ply\nformat binary_little_endian 1.0\nelement vertex ${points}\n${properties}end_header\n`,
  );
  async function* stream() {
    yield header;
    for (let copy = 0; copy < count; copy++) {
      const x = width * (copy % columns);
      const y = depth * Math.floor(copy / columns);
      for (let begin = 0; begin < tile.length; begin += PIECE_VALUES) {
        const own = tile.slice(begin, begin + PIECE_VALUES);
        for (let i = 0; i < own.length; i += 3) {
          own[i] += x;
          own[i + 1] += y;
        }
        yield new Uint8Array(own.buffer);
      }
    }
  }
  return {
    name: `${basename(path)}-${count}.ply`,
    size: header.length + points * POINT_BYTES,
    stream,
    slice: async (begin, end) => {
      if (begin === 0 && end >= header.length) return firstOf(stream(), end);
      throw new Error('Only the begin of this source can be had out of order.');
    },
  };
}

async function firstOf(pieces: AsyncIterable<Uint8Array>, length: number): Promise<Uint8Array> {
  const first = new Uint8Array(length);
  let filled = 0;
  for await (const piece of pieces) {
    const part = piece.subarray(0, length - filled);
    first.set(part, filled);
    filled += part.length;
    if (filled === length) break;
  }
  return first.subarray(0, filled);
}

function cpuNow(): number {
  const { user, system } = process.cpuUsage();
  return (user + system) / 1000;
}

async function runOn(count: number): Promise<Omit<LinearRun, 'firstMs'>> {
  const peaks = new Map<string, number>();
  const session = new Session({ strokeTest: createStrokeTest(), now: cpuNow });
  const start = performance.now();
  const begin = cpuNow();
  const result = await session.load(building(count), OPTIONS, {
    onProgress: ({ stage }) => peaks.set(stage, process.resourceUsage().maxRSS / 1024),
  });
  const peak = process.resourceUsage().maxRSS / 1024;
  return {
    wallMs: performance.now() - start,
    cpuMs: cpuNow() - begin,
    kept: session.evidence.read!.facts.pointsKept,
    stages: result.stages.map(({ name, ms, outcome }) => ({
      name,
      cpuMs: ms,
      peakMB: peaks.get(name) ?? peak,
      outcome,
    })),
  };
}

const { wallMs: firstMs } = await runOn(1);
const run: LinearRun = { firstMs, ...(await runOn(copies)) };
console.log(JSON.stringify(run));
