/** The worker itself: hands messages to {@link serve}. */
import type { Request, Response } from './protocol.ts';
import { serve } from './serve.ts';

const scope = globalThis as unknown as {
  onmessage: ((event: MessageEvent<Request>) => void) | null;
  postMessage(message: Response, transfer?: Transferable[]): void;
};

const receive = serve((response, transfer) => scope.postMessage(response, transfer ?? []));
scope.onmessage = ({ data }) => receive(data);
scope.postMessage({ kind: 'ready' });
