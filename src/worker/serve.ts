import { FloorPlanError, toPlainError } from '../core/errors.ts';
import { resolveOptions } from '../core/options.ts';
import type { Options } from '../core/params.ts';
import type { StageResults } from '../core/stage-results.ts';
import { STAGE_NAMES, type StageName } from '../core/stages.ts';
import { blobSource } from '../read/bytes/blob-source.ts';
import { urlSource } from '../read/bytes/url-source.ts';
import { Session, type SessionControl } from '../session/session.ts';
import { compareRuns } from './compare-runs.ts';
import { listPictures, PictureDesk } from './picture-desk.ts';
import type { PictureOf, Request, Response } from './protocol.ts';
import { makeView } from './view.ts';

type Post = (response: Response, transfer?: Transferable[]) => void;
type Run = Extract<Request, { kind: 'load' | 'update' }>;
type Compare = Extract<Request, { kind: 'compare' }>;

/** Least time between two progress messages of one request, ms: 30 a second read as motion. */
const PROGRESS_INTERVAL = 33;

/**
 * Answers requests with one {@link Session}; in a worker or, where none can be had, on the page's own thread.
 * A newer load or update overtakes the running one and any comparison, a newer comparison the one before; what is
 * overtaken answers `cancelled`.
 *
 * @param ended ends what is under way, on a thread that nobody can end
 * @returns the receiver of requests
 */
export function serve(post: Post, ended?: AbortSignal): (request: Request) => void {
  const desk = new Desk(post);
  let running = new AbortController();
  let comparing = { id: 0, controller: new AbortController() };
  let last: Promise<void> = Promise.resolve();
  ended?.addEventListener('abort', () => {
    running.abort();
    comparing.controller.abort();
  });
  return (request) => {
    if (request.kind === 'stop') {
      if (request.id === comparing.id) comparing.controller.abort();
      return;
    }
    const isRun = request.kind === 'load' || request.kind === 'update';
    if (isRun || request.kind === 'compare') comparing.controller.abort();
    if (isRun) {
      running.abort();
      running = new AbortController();
    }
    if (request.kind === 'compare') comparing = { id: request.id, controller: new AbortController() };
    const { signal } = request.kind === 'compare' ? comparing.controller : running;
    last = last
      .then(() => desk.answer(request, signal))
      .catch((error: unknown) => post({ kind: 'error', id: request.id, error: toPlainError(error) }));
  };
}

/** A run whose pictures can be asked for. */
interface ShownRun {
  readonly results: Partial<StageResults>;
  readonly options?: Options | undefined;
  /** What each stage took when it last ran on its scan, ms. */
  readonly times: ReadonlyMap<StageName, number>;
}

const NO_RUN: ShownRun = { results: {}, times: new Map() };

/** The session with what the page asks of it beside runs. */
class Desk {
  readonly #post: Post;
  readonly #session = new Session();
  readonly #pictures = new PictureDesk();
  readonly #runs: Record<PictureOf, ShownRun> = { plan: NO_RUN, failed: NO_RUN };

  constructor(post: Post) {
    this.#post = post;
  }

  async answer(request: Exclude<Request, { kind: 'stop' }>, signal: AbortSignal): Promise<void> {
    const { id } = request;
    switch (request.kind) {
      case 'load':
      case 'update':
        return this.#run(request, signal);
      case 'compare':
        return this.#compare(request, signal);
      case 'picture': {
        const { name, of, round } = request;
        const { results, options } = this.#runs[of];
        const facts = { ...(options && { options }), ...(round && { round }) };
        const svg = this.#pictures.draw(name, results, facts);
        return this.#post({ kind: 'picture', id, svg });
      }
      case 'export': {
        const written = await this.#session.write(request.format);
        const files = written.map(({ name, mime, content }) => ({
          name,
          blob: new Blob([content], { type: mime }),
        }));
        return this.#post({ kind: 'files', id, files });
      }
    }
  }

  /** A run that fails tells with its error what its stages made; one that was stopped tells nothing. */
  async #run(request: Run, signal: AbortSignal): Promise<void> {
    const start = performance.now();
    try {
      await this.#make(request, controlOf(request.id, signal, this.#post));
      throwIfAborted(signal);
    } catch (error) {
      if (error instanceof FloorPlanError && error.code === 'cancelled') throw error;
      const { evidence: results, reports, times } = this.#session;
      const options = results.read && resolveOptions(request.options, results.read);
      this.#runs.failed = { results, options, times };
      const evidence = { stage: stageAfter(reports.at(-1)?.name), pictures: listPictures(this.#session) };
      return this.#post({ kind: 'error', id: request.id, error: toPlainError(error), evidence });
    }
    const totalMs = performance.now() - start;
    const { evidence: results, result, times } = this.#session;
    this.#runs.plan = { results, options: result?.options, times };
    this.#runs.failed = NO_RUN;
    const { view, transfer } = makeView(this.#session, listPictures(this.#session), totalMs);
    this.#post({ kind: 'view', id: request.id, view }, transfer);
  }

  async #make(request: Run, control: SessionControl): Promise<void> {
    if (request.kind === 'update') {
      await this.#session.update(request.options, control);
      return;
    }
    const sources = request.files.map(({ data, name }) =>
      typeof data === 'string' ? urlSource(data) : blobSource(data, name),
    );
    await this.#session.load(sources, request.options, control);
  }

  async #compare({ id, options, labels }: Compare, signal: AbortSignal): Promise<void> {
    // Asked for before it was stopped, begun after.
    throwIfAborted(signal);
    const there = await this.#session.compare(options, controlOf(id, signal, this.#post));
    throwIfAborted(signal);
    // The session compares only where there is a plan, so every stage has its result.
    const { results, times } = this.#runs.plan;
    const comparison = compareRuns({ labels, here: results as StageResults, there, times });
    this.#post({ kind: 'comparison', id, comparison });
  }
}

/** The one that was under way when those before it had run; a plan without its scan begins late. */
function stageAfter(last: StageName | undefined): StageName {
  return STAGE_NAMES[last === undefined ? 0 : STAGE_NAMES.indexOf(last) + 1];
}

function throwIfAborted({ aborted }: AbortSignal): void {
  if (aborted) throw new FloorPlanError('cancelled', 'A newer request overtook this one.');
}

function controlOf(id: number, signal: AbortSignal, post: Post): SessionControl {
  let due = 0;
  return {
    signal,
    onProgress(progress) {
      const now = performance.now();
      if (now < due) return;
      due = now + PROGRESS_INTERVAL;
      post({ kind: 'progress', id, progress });
    },
    onPreview: (positions) => post({ kind: 'preview', id, positions }),
  };
}
