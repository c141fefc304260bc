import type { StageContext, StrokeTest } from './context.ts';
import { FloorPlanError } from './errors.ts';
import { type Options, PARAM_NAMES, PARAMS } from './params.ts';
import type { StageResults } from './stage-results.ts';
import { STAGE_NAMES, STAGES, type StageName } from './stages.ts';
import type { Warning } from './types.ts';

/** Where a run stands. */
export interface Progress {
  readonly stage: StageName;
  /** Share of the whole run, 0 to 1, never falling. */
  readonly share: number;
}

/** One stage of a run, for the app's rail and the report. */
export interface StageReport {
  readonly name: StageName;
  readonly ms: number;
  /** Whether the result came from the cache. */
  readonly isCached: boolean;
  /** What came out, in words: "380,344 points", "24 vertices". */
  readonly outcome: string;
}

/** What an environment alone can do, for a whole run. */
export interface PipelineHooks {
  /** Milliseconds from any start. */
  now(): number;
  readonly strokeTest: StrokeTest;
  /** Called between stages: lets an environment see messages. */
  breathe?(): Promise<void>;
}

export interface RunControl {
  onProgress?(progress: Progress): void;
  readonly signal?: AbortSignalLike;
}

/** The part of an AbortSignal that core needs; core knows no DOM. */
export interface AbortSignalLike {
  readonly aborted: boolean;
}

interface CachedStage {
  readonly key: string;
  readonly output: unknown;
  readonly warnings: readonly Warning[];
  readonly outcome: string;
}

/** The last result of every stage, so that a changed parameter runs again from its stage only. */
export class StageCache {
  readonly #stages = new Map<StageName, CachedStage>();

  get(name: StageName, key: string): CachedStage | undefined {
    const cached = this.#stages.get(name);
    return cached?.key === key ? cached : undefined;
  }

  set(name: StageName, cached: CachedStage): void {
    this.#stages.set(name, cached);
  }

  /** A cache that starts with all that this one holds; what it takes up later stays its own. */
  fork(): StageCache {
    const fork = new StageCache();
    for (const [name, cached] of this.#stages) fork.set(name, cached);
    return fork;
  }
}

/** One pass through {@link STAGES} with one set of options. */
export class PipelineRun {
  readonly stages: StageReport[] = [];
  /** Of all stages done so far. */
  readonly results: { -readonly [S in StageName]?: StageResults[S] } = {};
  readonly #warned = new Map<StageName, readonly Warning[]>();
  readonly #cache: StageCache;
  readonly #hooks: PipelineHooks;
  readonly #control: RunControl;
  #key = '';

  constructor(cache: StageCache, hooks: PipelineHooks, control: RunControl) {
    this.#cache = cache;
    this.#hooks = hooks;
    this.#control = control;
  }

  /** Of all stages so far, the one under way included, but for those whose warnings were dropped. */
  get warnings(): Warning[] {
    return [...this.#warned.values()].flat();
  }

  /** Forgets what stages warned of in this run: nothing of what they made is in its plan. */
  dropWarnings(stages: readonly StageName[]): void {
    for (const stage of stages) this.#warned.delete(stage);
  }

  /**
   * Runs a stage, or takes its result from the cache when neither its parameters nor any stage before it changed.
   *
   * @param outcome what came out, in words, for the rail
   * @throws cancelled, and whatever `work` throws
   */
  async stage<S extends StageName>(
    name: S,
    options: Options,
    work: (context: StageContext) => StageResults[S] | Promise<StageResults[S]>,
    outcome: (output: StageResults[S]) => string,
  ): Promise<StageResults[S]> {
    this.#key = `${this.#key}\n${stageKey(name, options)}`;
    const cached = this.#cache.get(name, this.#key);
    if (cached) {
      this.#warned.set(name, cached.warnings);
      this.stages.push({ name, ms: 0, isCached: true, outcome: cached.outcome });
      this.results[name] = cached.output as StageResults[S];
      return cached.output as StageResults[S];
    }
    await this.#hooks.breathe?.();
    this.#throwIfCancelled();
    this.#progress(name, 0);
    const warnings: Warning[] = [];
    this.#warned.set(name, warnings);
    const start = this.#hooks.now();
    const output = await work({
      warn: (warning) => {
        warnings.push(warning);
      },
      progress: (share) => this.#progress(name, share),
      strokeTest: this.#hooks.strokeTest,
    });
    this.#throwIfCancelled();
    const ms = this.#hooks.now() - start;
    const words = outcome(output);
    this.#cache.set(name, { key: this.#key, output, warnings, outcome: words });
    this.stages.push({ name, ms, isCached: false, outcome: words });
    this.results[name] = output;
    this.#progress(name, 1);
    return output;
  }

  #throwIfCancelled(): void {
    if (this.#control.signal?.aborted) throw new FloorPlanError('cancelled', 'The run was cancelled.');
  }

  #progress(name: StageName, share: number): void {
    let before = 0;
    for (const stage of STAGE_NAMES) {
      if (stage === name) break;
      before += STAGES[stage].share;
    }
    // The shares of all stages add up to 1 but for rounding.
    const sum = Math.min(1, before + STAGES[name].share * Math.min(1, share));
    this.#control.onProgress?.({ stage: name, share: sum });
  }
}

function stageKey(name: StageName, options: Options): string {
  const values = PARAM_NAMES.filter((param) => PARAMS[param].stage === name && param !== 'preset');
  return `${name} ${JSON.stringify(values.map((param) => options[param]))}`;
}
