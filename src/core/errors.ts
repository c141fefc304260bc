/** What went wrong, by family. A reader may throw nothing but a {@link FloorPlanError}. */
export type ErrorCode =
  | `input/${'unknown-format' | 'truncated' | 'empty' | 'malformed' | 'not-finite' | 'too-large' | 'too-few-points' | 'degenerate' | 'unreadable' | 'geographic-coordinates'}`
  | `option/${'unknown' | 'invalid'}`
  | `result/${'no-boundary' | 'cannot-write'}`
  | `environment/${'network' | 'worker' | 'webgl' | 'wasm' | 'canvas' | 'memory' | 'file-system'}`
  | 'cancelled';

export interface ErrorFacts {
  /** One thing to try. */
  hint?: string;
  /** Where: line, byte offset, name of the option … */
  detail?: Readonly<Record<string, string | number>>;
  cause?: unknown;
}

/** The only error users meet. `message` says what was expected, what was found and where; `hint` one thing to try. */
export class FloorPlanError extends Error {
  override readonly name = 'FloorPlanError';
  readonly code: ErrorCode;
  readonly hint: string;
  readonly detail: Readonly<Record<string, string | number>>;

  constructor(code: ErrorCode, message: string, { hint = '', detail = {}, cause }: ErrorFacts = {}) {
    super(message, cause === undefined ? undefined : { cause });
    this.code = code;
    this.hint = hint;
    this.detail = detail;
  }
}

/** A plain copy that survives structured clone and JSON; {@link fromPlainError} is its inverse. */
export interface PlainError {
  readonly code: ErrorCode | 'bug';
  readonly message: string;
  readonly hint: string;
  readonly detail: Readonly<Record<string, string | number>>;
}

/** Anything that is not a FloorPlanError is a bug and keeps its message under the code `bug`. */
export function toPlainError(error: unknown): PlainError {
  if (error instanceof FloorPlanError) {
    const { code, message, hint, detail } = error;
    return { code, message, hint, detail };
  }
  const message = error instanceof Error ? error.message : String(error);
  return { code: 'bug', message, hint: 'Please report this with the file, if you can share it.', detail: {} };
}

export function fromPlainError({ code, message, hint, detail }: PlainError): Error {
  return code === 'bug' ? new Error(message) : new FloorPlanError(code, message, { hint, detail });
}
