import { FloorPlanError, toPlainError } from '../core/errors.ts';
import { blobSource } from '../read/blob-source.ts';
import { urlSource } from '../read/url-source.ts';
import { Session, type SessionControl } from '../session/session.ts';
import type { Request, Response } from './protocol.ts';
import { makeView } from './view.ts';

type Post = (response: Response, transfer?: Transferable[]) => void;

/** Least time between two progress messages of one request, ms: 30 a second read as motion. */
const PROGRESS_INTERVAL = 33;

/**
 * Answers requests with one {@link Session}; in a worker or, where none can be had, on the page's own thread.
 * A newer load or update overtakes the running one, which then answers `cancelled`.
 *
 * @param ended ends the running request, on a thread that nobody can end
 * @returns the receiver of requests
 */
export function serve(post: Post, ended?: AbortSignal): (request: Request) => void {
  const session = new Session({ breathe });
  let running = new AbortController();
  let last: Promise<void> = Promise.resolve();
  ended?.addEventListener('abort', () => running.abort());

  async function run(request: Exclude<Request, { kind: 'export' }>, signal: AbortSignal): Promise<void> {
    const control = controlOf(request.id, signal, post);
    const start = performance.now();
    if (request.kind === 'load') {
      const { source, name } = request;
      await session.load(
        typeof source === 'string' ? urlSource(source) : blobSource(source, name),
        request.options,
        control,
      );
    } else {
      await session.update(request.options, control);
    }
    if (signal.aborted) throw new FloorPlanError('cancelled', 'A newer request overtook this one.');
    const { view, transfer } = makeView(session, performance.now() - start);
    post({ kind: 'view', id: request.id, view }, transfer);
  }

  function write(id: number, format: string): void {
    const files = session
      .write(format)
      .map(({ name, mime, content }) => ({ name, blob: new Blob([content], { type: mime }) }));
    post({ kind: 'files', id, files });
  }

  return (request) => {
    if (request.kind !== 'export') {
      running.abort();
      running = new AbortController();
    }
    const { signal } = running;
    last = last
      .then(() => (request.kind === 'export' ? write(request.id, request.format) : run(request, signal)))
      .catch((error: unknown) => post({ kind: 'error', id: request.id, error: toPlainError(error) }));
  };
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

/** Lets the messages that wait be seen. */
function breathe(): Promise<void> {
  return new Promise((resolve) => {
    const { port1, port2 } = new MessageChannel();
    port1.onmessage = () => {
      port1.close();
      resolve();
    };
    port2.postMessage(null);
  });
}
