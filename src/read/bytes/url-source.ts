import { FloorPlanError } from '../../core/errors.ts';
import { firstBytes } from './byte-cursor.ts';
import type { ByteSource } from './source.ts';

/** Asked for first: enough for any header, and it shows whether the server knows ranges. */
const PROBE_BYTES = 1 << 16;

/**
 * Reads a URL with `fetch`, in ranges where the server answers 206, else from the start each time.
 *
 * Nothing is fetched before the first bytes are asked for; the size is known after that, where the server tells it.
 *
 * @param signal ends every request of this source
 * @throws environment/network, with URL and status, from `slice` and `stream`
 */
export function urlSource(url: string, signal?: AbortSignal): ByteSource {
  const request = { url, signal };
  let probing: Promise<Probe> | null = null;
  let size: number | undefined;
  let isSequential = false;
  return {
    name: nameOf(url),
    get size() {
      return size;
    },
    get isSequential() {
      return isSequential;
    },
    stream: () => streamOf(request),
    async slice(begin, end) {
      probing ??= probe(request);
      const { head, hasRanges, size: told } = await probing;
      size = told;
      isSequential = !hasRanges && head.length === PROBE_BYTES;
      if (end <= head.length || head.length < PROBE_BYTES) return head.subarray(begin, end);
      if (hasRanges) return readRange(request, begin, end);
      return (await firstBytes(streamOf(request), end)).subarray(begin, end);
    },
  };
}

interface Probe {
  /** All bytes of a file that is shorter than the probe. */
  readonly head: Uint8Array;
  readonly hasRanges: boolean;
  readonly size: number | undefined;
}

async function probe(request: UrlRequest): Promise<Probe> {
  const response = await openProbe(request);
  const head = await firstBytes(bodyOf(request, response), PROBE_BYTES);
  return { head, hasRanges: response.status === 206, size: sizeOf(response) };
}

interface UrlRequest {
  readonly url: string;
  readonly signal: AbortSignal | undefined;
}

/** Where a server's CORS rules refuse the range header, a plain request may still pass. */
async function openProbe(request: UrlRequest): Promise<Response> {
  try {
    return await get(request, `bytes=0-${PROBE_BYTES - 1}`);
  } catch (error) {
    if (error instanceof FloorPlanError && error.code === 'environment/network') return get(request);
    throw error;
  }
}

async function get({ url, signal }: UrlRequest, range?: string): Promise<Response> {
  let response: Response;
  try {
    response = await fetch(url, {
      ...(signal && { signal }),
      // Kept out of the cache: Chromium completes a kept range with the rest of a compressed answer, undecoded.
      ...(range && { headers: { Range: range }, cache: 'no-store' }),
    });
  } catch (cause) {
    throw networkError({ url, signal }, 'no answer', cause);
  }
  if (response.ok) return response;
  // A range past the end of an empty file; the plain request answers 200 with no bytes.
  if (response.status === 416 && range) return get({ url, signal });
  await response.body?.cancel();
  throw networkError({ url, signal }, `HTTP ${response.status} ${response.statusText}`.trim(), undefined, {
    status: response.status,
  });
}

async function* streamOf(request: UrlRequest): AsyncGenerator<Uint8Array> {
  yield* bodyOf(request, await get(request));
}

async function* bodyOf(request: UrlRequest, response: Response): AsyncGenerator<Uint8Array> {
  if (!response.body) return;
  const reader = response.body.getReader();
  let received = 0;
  let isDone = false;
  try {
    while (true) {
      const { done, value } = await reader.read().catch((cause) => {
        throw brokenError(request, response, received, cause);
      });
      isDone = done;
      if (done) break;
      received += value.length;
      yield value;
    }
  } finally {
    if (!isDone) await reader.cancel().catch(() => undefined);
  }
  // Browsers see to this themselves, unless a service worker answers.
  if (received < (lengthOf(response) ?? 0)) throw brokenError(request, response, received);
}

async function readRange(request: UrlRequest, begin: number, end: number): Promise<Uint8Array> {
  const response = await get(request, `bytes=${begin}-${end - 1}`);
  if (response.status === 206) return firstBytes(bodyOf(request, response), end - begin);
  return (await firstBytes(bodyOf(request, response), end)).subarray(begin, end);
}

/** Of the whole file. */
function sizeOf(response: Response): number | undefined {
  if (response.headers.has('content-encoding')) return undefined;
  const range = /\/(\d+)$/.exec(response.headers.get('content-range') ?? '');
  if (range) return Number(range[1]);
  return response.status === 200 ? lengthOf(response) : undefined;
}

/** Of the body. Undefined unless it surely counts the decoded bytes: a wrong one would make a whole file look cut off. */
function lengthOf({ headers, type }: Response): number | undefined {
  const length = headers.get('content-length');
  // Across origins the encoding is hidden from us.
  const isSure = type !== 'cors' && !headers.has('content-encoding');
  return isSure && length !== null ? Number(length) : undefined;
}

/** The file's name in a URL, decoded. */
export function nameOf(url: string): string {
  const path = url.startsWith('data:') ? '' : url.replace(/[?#].*$/, '');
  const name = path.slice(path.lastIndexOf('/') + 1);
  try {
    return decodeURIComponent(name) || 'download';
  } catch {
    return name;
  }
}

function brokenError(
  { url, signal }: UrlRequest,
  response: Response,
  received: number,
  cause?: unknown,
): FloorPlanError {
  if (signal?.aborted) return cancelledError(cause);
  const length = lengthOf(response);
  const of = length === undefined ? '' : ` of ${length}`;
  return new FloorPlanError(
    'environment/network',
    `expected a file at ${url}, found: the connection broke after ${received}${of} bytes`,
    {
      hint: 'Load it once more, or download the file and open that.',
      detail: { url, offset: received },
      cause,
    },
  );
}

function cancelledError(cause: unknown): FloorPlanError {
  return new FloorPlanError('cancelled', 'The download was cancelled.', { cause });
}

function networkError(
  { url, signal }: UrlRequest,
  found: string,
  cause?: unknown,
  detail: Readonly<Record<string, string | number>> = {},
): FloorPlanError {
  if (signal?.aborted) return cancelledError(cause);
  return new FloorPlanError('environment/network', `expected a file at ${url}, found: ${found}`, {
    hint: 'Check the address, and that its server allows other sites to read it (CORS).',
    detail: { url, ...detail },
    cause,
  });
}
