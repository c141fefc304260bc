import { FloorPlanError } from '../core/errors.ts';
import { resolveOptions } from '../core/options.ts';
import type { GivenValues } from '../core/params.ts';
import { planScan } from '../core/pipeline.ts';
import { type PipelineHooks, PipelineRun, type RunControl, StageCache } from '../core/pipeline-run.ts';
import type { StageResults } from '../core/stage-results.ts';
import { readScan } from '../read/read-scan.ts';
import type { ByteSource } from '../read/source.ts';
import { makeSolid } from '../solid/make-solid.ts';
import { writeFiles } from '../write/formats.ts';
import type { Product, WrittenFile } from '../write/plan-writer.ts';
import { DEFAULT_HOOKS } from './default-hooks.ts';
import type { RunResult } from './result.ts';

export interface SessionControl extends RunControl {
  /** A sample of the points read so far: source units, relative to the first point. */
  onPreview?(positions: Float32Array): void;
  readonly signal?: AbortSignal;
}

interface OpenSource {
  readonly source: ByteSource;
  readonly cache: StageCache;
}

/**
 * One person's work on one scan: reads it, makes its plan, makes it again when a parameter changes, writes files.
 * The same in worker, command and library. A source that fails leaves the one before it open. One run at a time:
 * await, or cancel and await, the last before the next.
 */
export class Session {
  readonly #hooks: PipelineHooks;
  #open: OpenSource | null = null;
  #result: RunResult | null = null;
  #evidence: Partial<StageResults> = {};

  /** @param hooks what the environment does better than its defaults: a clock, a canvas, a pause between stages */
  constructor(hooks: Partial<PipelineHooks> = {}) {
    this.#hooks = { ...DEFAULT_HOOKS, ...hooks };
  }

  /** The last good run. */
  get result(): RunResult | null {
    return this.#result;
  }

  /** What the stages of the last run made, as far as it got: a run that failed has those before the failing stage. */
  get evidence(): Partial<StageResults> {
    return this.#evidence;
  }

  /** Reads a scan and makes its plan. @throws FloorPlanError */
  async load(source: ByteSource, given: GivenValues = {}, control: SessionControl = {}): Promise<RunResult> {
    const opened = { source, cache: new StageCache() };
    const result = await this.#run(opened, given, control);
    this.#open = opened;
    this.#result = result;
    return result;
  }

  /** Makes the plan again, from the first stage whose parameters changed. @throws FloorPlanError */
  async update(given: GivenValues, control: SessionControl = {}): Promise<RunResult> {
    if (!this.#open) throw noScan();
    this.#result = await this.#run(this.#open, given, control);
    return this.#result;
  }

  /** The files of one write format. @throws option/invalid for an unknown format */
  write(format: string): readonly WrittenFile[] {
    if (!this.#result) throw noScan();
    return writeFiles(productOf(this.#result), format);
  }

  async #run({ source, cache }: OpenSource, given: GivenValues, control: SessionControl): Promise<RunResult> {
    const run = new PipelineRun(cache, this.#hooks, control);
    this.#evidence = run.results;
    const readOptions = resolveOptions(given);
    const scan = await run.stage(
      'read',
      readOptions,
      async (context) => {
        const read = await readScan(source, readOptions, {
          signal: control.signal,
          onPreview: control.onPreview,
          onProgress: ({ bytesRead, totalBytes }) =>
            context.progress(totalBytes ? bytesRead / totalBytes : 0),
        });
        for (const warning of read.warnings) context.warn(warning);
        return read;
      },
      ({ facts }) =>
        `${facts.pointsKept.toLocaleString('en-GB')} of ${facts.pointsRead.toLocaleString('en-GB')} points`,
    );
    const options = resolveOptions(given, scan);
    const planned = await planScan(scan, options, run);
    const solid = await run.stage(
      'solid',
      options,
      ({ warn }) => makeSolid(planned.plan, options, warn),
      ({ indices }) => `${(indices.length / 3).toLocaleString('en-GB')} triangles`,
    );
    return { ...planned, options, scan, solid, stages: run.stages, warnings: run.warnings };
  }
}

/** What the writers draw on. */
export function productOf({ scan, plan, slice, solid }: RunResult): Product {
  return { name: baseName(scan.facts.name), plan, slice, solid };
}

/** `scan.ply.gz` → `scan`; a name that is all extension stays. */
export function baseName(fileName: string): string {
  return fileName.replace(/(?<=.)\.[^.]{1,5}(\.(gz|zip))?$/i, '');
}

function noScan(): FloorPlanError {
  return new FloorPlanError('input/empty', 'There is no scan yet.', { hint: 'Load a scan first.' });
}
