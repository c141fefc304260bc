import { FloorPlanError } from '../core/errors.ts';

/** Most memory a module may take. */
const MOST_BYTES = 2 ** 30;
const PAGE_BYTES = 2 ** 16;

/** Compiles a module that the bundler has put into the script, as a data URI. */
export function compileInlined(uri: string): Promise<WebAssembly.Module> {
  const text = atob(uri.slice(uri.indexOf(',') + 1));
  return WebAssembly.compile(Uint8Array.from(text, (character) => character.charCodeAt(0)));
}

/** Half as much again as is asked for, so that memory is moved seldom; false where that is too much. */
export function growMemory(memory: WebAssembly.Memory, bytes: number): boolean {
  if (bytes > MOST_BYTES) return false;
  const wanted = Math.min(MOST_BYTES, Math.max(bytes, 1.5 * memory.buffer.byteLength));
  try {
    memory.grow(Math.ceil((wanted - memory.buffer.byteLength) / PAGE_BYTES));
    return true;
  } catch {
    return false;
  }
}

/** A page may forbid WebAssembly. @param packed what is unpacked with it @param instead what needs none */
export function wasmError(packed: string, instead: string, cause?: unknown): FloorPlanError {
  return new FloorPlanError(
    'environment/wasm',
    `${packed} is decompressed with WebAssembly, which may not be used here.`,
    {
      hint: `Allow 'wasm-unsafe-eval' in the page's content security policy, or save ${instead}.`,
      cause,
    },
  );
}
