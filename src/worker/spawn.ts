/**
 * The only file that knows the bundler: the worker's code travels inline, so a consumer's build cannot lose it, in a
 * chunk of its own, so the page stands before it has come.
 */
import type { Request, Response } from './protocol.ts';

/** Two ends of one line: a worker, or the page's own thread. A closed line says nothing more. */
export interface Line {
  send(request: Request): void;
  close(): void;
}

export interface LineEvents {
  onResponse(response: Response): void;
  /** The line broke: the worker or its code could not start, or it died. */
  onBroken(): void;
}

export type Spawn = () => Worker;
/** As a {@link Spawn}, or with code that has to be fetched first. */
export type Start = () => Worker | Promise<Worker>;

/** Ways to a worker, in order: the given function, then the inline one. The page's own thread comes last. */
export function spawnOrder(given?: Spawn | null): Start[] {
  const inline: Start = async () => {
    const { default: InlineWorker } = await import('./entry.ts?worker&inline');
    return new InlineWorker();
  };
  return given ? [given, inline] : [inline];
}

/** Nothing may be sent before the worker has said that it is ready. */
export function openWorker(start: Start, { onResponse, onBroken }: LineEvents): Line {
  let worker: Worker | null = null;
  let isClosed = false;
  const attach = (started: Worker) => {
    if (isClosed) return started.terminate();
    worker = started;
    worker.onmessage = ({ data }: MessageEvent<Response>) => onResponse(data);
    // A blob worker under a strict CSP throws nothing: it fires an error event without a message.
    worker.onerror = (event) => {
      event.preventDefault();
      onBroken();
    };
  };
  // Where no worker may be made, or its code does not come.
  const refused = () => isClosed || onBroken();
  new Promise<Worker>((resolve) => resolve(start())).then(attach, refused);
  return {
    send: (request) => worker?.postMessage(request),
    close: () => {
      isClosed = true;
      if (!worker) return;
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
    },
  };
}

/** The pipeline on the page's own thread: slow pages beat no plan. */
export function openMainThread({ onResponse, onBroken }: LineEvents): Line {
  const closed = new AbortController();
  const post = (response: Response) => {
    if (!closed.signal.aborted) onResponse(structuredClone(response));
  };
  const ready = import('./serve.ts').then(({ serve }) => {
    const receive = serve(post, closed.signal);
    post({ kind: 'ready' });
    return receive;
  });
  ready.catch(() => closed.signal.aborted || onBroken());
  return {
    // Nothing is sent before it is ready, so it has not failed.
    send: (request) => void ready.then((receive) => receive(request)),
    close: () => closed.abort(),
  };
}
