/** The only file that knows the bundler: the worker's code travels inline, so a consumer's build cannot lose it. */
import InlineWorker from './entry.ts?worker&inline';
import type { Request, Response } from './protocol.ts';

/** Two ends of one line: a worker, or the page's own thread. A closed line says nothing more. */
export interface Line {
  send(request: Request): void;
  close(): void;
}

export interface LineEvents {
  onResponse(response: Response): void;
  /** The line broke: the worker could not start, or died. */
  onBroken(): void;
}

export type Spawn = () => Worker;

/** Ways to a worker, in order: the given function, then the inline one. The page's own thread comes last. */
export function spawnOrder(given?: Spawn | null): Spawn[] {
  const inline: Spawn = () => new InlineWorker();
  return given ? [given, inline] : [inline];
}

/** @throws whatever the environment throws where no worker may be made */
export function openWorker(spawn: Spawn, { onResponse, onBroken }: LineEvents): Line {
  const worker = spawn();
  worker.onmessage = ({ data }: MessageEvent<Response>) => onResponse(data);
  // A blob worker under a strict CSP throws nothing: it fires an error event without a message.
  worker.onerror = (event) => {
    event.preventDefault();
    onBroken();
  };
  return {
    send: (request) => worker.postMessage(request),
    close: () => {
      worker.onmessage = null;
      worker.onerror = null;
      worker.terminate();
    },
  };
}

/** The pipeline on the page's own thread: slow pages beat no plan. */
export function openMainThread({ onResponse }: LineEvents): Line {
  const closed = new AbortController();
  const post = (response: Response) => {
    if (!closed.signal.aborted) onResponse(structuredClone(response));
  };
  const ready = import('./serve.ts').then(({ serve }) => {
    const receive = serve(post, closed.signal);
    post({ kind: 'ready' });
    return receive;
  });
  return {
    send: (request) => void ready.then((receive) => receive(request)),
    close: () => closed.abort(),
  };
}
