import type { Random } from '../../fixtures/simulator/random.ts';
import { FloorPlanError } from '../../src/core/errors.ts';
import { resolveOptions } from '../../src/core/options.ts';
import type { Scan } from '../../src/core/types.ts';
import { blobSource } from '../../src/read/bytes/blob-source.ts';
import type { ByteSource } from '../../src/read/bytes/source.ts';
import { urlSource } from '../../src/read/bytes/url-source.ts';
import { openScan } from '../../src/read/open-scan.ts';
import { type ReadControl, readScan } from '../../src/read/read-scan.ts';
import { memorySource } from '../unit/read/memory-source.ts';
import { mutate } from './mutate.ts';
import type { Bytes, Seed } from './seed.ts';

/** Small, so that a case is quick: cells of 12.5 cm, and budgets that are passed. */
const OPTIONS = resolveOptions({ resolution: 0.2, pointBudget: 1_000, unit: 'm' });
const LARGE = resolveOptions({ resolution: 0.1, pointBudget: 3_000 });
const CLASSES = resolveOptions({ resolution: 0.2, pointBudget: 1_000, classes: '2,6' });

/** How a case ended. */
export interface CaseResult {
  /** Whether the header was taken for good. */
  readonly isPastHeader: boolean;
  /** `scan`, or the error's code. */
  readonly outcome: string;
  readonly ms: number;
  /** Growth of what typed arrays hold, at its highest seen. */
  readonly peakBytes: number;
}

export interface FuzzCase {
  readonly bytes: Bytes;
  readonly name: string;
  /** Draws how the file is read. */
  readonly random: Random;
}

/** A mutant of one of the seeds; equal randomness, equal case. */
export function makeCase(seeds: readonly Seed[], random: Random): FuzzCase {
  const seed = random.pick(seeds);
  return { bytes: mutate(seed, random.fork('bytes')), name: seed.name, random: random.fork('reading') };
}

/** Reads a file in one of the ways files are read. @throws what no reader may throw, or an answer that makes no sense */
export async function runCase({ bytes, name, random }: FuzzCase): Promise<CaseResult> {
  const began = performance.now();
  const meter = new Meter();
  const { source, release } = sourceOf({ bytes, name, random });
  const watched = meter.watch(source);
  const sources = random.chance(0.03) ? [watched, meter.watch(memorySource(bytes, name))] : watched;
  let isPastHeader = false;
  let outcome: string;
  try {
    await openScan([watched]);
    isPastHeader = true;
    outcome = checkScan(
      await readScan(
        sources,
        random.pick([OPTIONS, OPTIONS, OPTIONS, OPTIONS, LARGE, CLASSES]),
        controlOf(random),
      ),
    );
  } catch (error) {
    outcome = checkError(error);
  } finally {
    release();
  }
  meter.sample();
  return { isPastHeader, outcome, ms: performance.now() - began, peakBytes: meter.peak };
}

/** Pieces of all sizes; a file, a URL, a server that tells no size. */
function sourceOf({ bytes, name, random }: FuzzCase): { source: ByteSource; release(): void } {
  const nothing = () => undefined;
  const die = random.next();
  if (die < 0.1) return { source: blobSource(new File([bytes], name)), release: nothing };
  if (die < 0.15) {
    const url = URL.createObjectURL(new Blob([bytes]));
    return { source: urlSource(url), release: () => URL.revokeObjectURL(url) };
  }
  const least = bytes.length / 50;
  const pieces = Array.from({ length: 3 }, () => Math.ceil(least + random.next() ** 3 * 4096));
  const memory = memorySource(bytes, name, random.chance(0.5) ? [1 << 20] : pieces);
  return { source: die < 0.22 ? { ...memory, size: undefined } : memory, release: nothing };
}

function controlOf(random: Random): ReadControl {
  const abort = new AbortController();
  const reportsLeft = random.chance(0.03) ? random.integer(0, 3) : Infinity;
  let reports = 0;
  return {
    signal: abort.signal,
    onProgress: () => {
      if (++reports > reportsLeft) abort.abort();
    },
    ...(random.chance(0.2) && { onPreview: () => undefined }),
  };
}

function checkScan({ positions, warnings }: Scan): string {
  if (positions.length < 9 || positions.length % 3 !== 0)
    throw new Error(`a scan of ${positions.length} numbers`);
  if (!positions.every(Number.isFinite)) throw new Error('a scan with a coordinate that is not finite');
  for (const { code, message } of warnings) if (!code || !message) throw new Error('a warning without words');
  return 'scan';
}

function checkError(error: unknown): string {
  if (!(error instanceof FloorPlanError)) throw error;
  const { code, message, hint } = error;
  const isOurs = code.startsWith('input/') || code === 'cancelled';
  if (!isOurs) throw new Error(`the code ${code}: ${message}`, { cause: error });
  if (message === '' || (hint === '' && code !== 'cancelled'))
    throw new Error(`${code} without words: ${message}`);
  return code;
}

/** Watches memory wherever a reader waits for bytes. */
class Meter {
  peak = 0;
  readonly #before = process.memoryUsage().arrayBuffers;

  sample(): void {
    this.peak = Math.max(this.peak, process.memoryUsage().arrayBuffers - this.#before);
  }

  watch(source: ByteSource): ByteSource {
    const meter = this;
    return {
      name: source.name,
      get size() {
        return source.size;
      },
      get isSequential() {
        return source.isSequential ?? false;
      },
      slice(begin, end) {
        meter.sample();
        return source.slice(begin, end);
      },
      async *stream() {
        for await (const piece of source.stream()) {
          meter.sample();
          yield piece;
        }
        meter.sample();
      },
    };
  }
}
