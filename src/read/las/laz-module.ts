import { compileInlined, growMemory } from '../wasm.ts';

/** What a chunk decoder of laz-perf offers; pointers are bytes into `heap()`. */
export interface LazModule {
  /** The module's memory as it is now: a view from before a call may be detached by it. */
  heap(): Uint8Array;
  allocate(bytes: number): number;
  free(pointer: number): void;
  /** Starts to decode a chunk that lies in the heap. */
  openChunk(format: number, recordBytes: number, chunk: number): ChunkDecoder;
}

export interface ChunkDecoder {
  /** Decodes the next point into a record at `to`. */
  next(to: number): void;
  close(): void;
}

/** A function of the module, called through its table. */
type Callable = (...args: number[]) => number;

interface ModuleExports {
  readonly memory: WebAssembly.Memory;
  readonly __indirect_function_table: WebAssembly.Table;
  __wasm_call_ctors(): void;
  _embind_initialize_bindings(): void;
  malloc(bytes: number): number;
  free(pointer: number): void;
}

/** A member function as the module announces it: `invoke(target, this, …arguments)`. */
interface Bound {
  readonly invoke: number;
  readonly target: number;
}

let compiling: Promise<WebAssembly.Module> | null = null;

/**
 * A fresh instance of laz-perf 0.0.7, for one reading: after a fault an instance is of no more use.
 *
 * The package's own loader is left aside: it asks where it runs, fetches by itself and, under Node, turns every
 * unhandled rejection of the process into a crash. What is needed of it is little: the module announces its classes by
 * the imports `_embind_register_…`, and their functions are called through its table.
 *
 * @throws what the environment throws where WebAssembly is not allowed
 */
export async function createLazModule(): Promise<LazModule> {
  compiling ??= compile();
  const functions = new Map<string, Bound>();
  const { exports } = await WebAssembly.instantiate(
    await compiling,
    importsOf(functions, () => module),
  );
  const module = exports as unknown as ModuleExports;
  module.__wasm_call_ctors();
  module._embind_initialize_bindings();
  return bindModule(module, functions);
}

async function compile(): Promise<WebAssembly.Module> {
  const { default: uri } = await import('laz-perf/lib/laz-perf.wasm?url&inline');
  return compileInlined(uri);
}

function bindModule(module: ModuleExports, functions: ReadonlyMap<string, Bound>): LazModule {
  const callable = (index: number) => module.__indirect_function_table.get(index) as Callable;
  const bound = (name: string) => {
    const { invoke, target } = functions.get(name)!;
    return { call: callable(invoke), target };
  };
  const make = bound('ChunkDecoder.new');
  const open = bound('ChunkDecoder.open');
  const getPoint = bound('ChunkDecoder.getPoint');
  const destroy = bound('ChunkDecoder.delete');
  return {
    heap: () => new Uint8Array(module.memory.buffer),
    allocate: (bytes) => module.malloc(bytes) || fault('out of memory'),
    free: (pointer) => module.free(pointer),
    openChunk(format, recordBytes, chunk) {
      const decoder = make.call(make.target);
      open.call(open.target, decoder, format, recordBytes, chunk);
      return {
        next: (to) => void getPoint.call(getPoint.target, decoder, to),
        close: () => void destroy.call(decoder),
      };
    },
  };
}

/** What the module asks for. Its C++ exceptions end here: it was built without a way to catch them. */
function importsOf(functions: Map<string, Bound>, exports: () => ModuleExports): WebAssembly.Imports {
  const heap = () => new Uint8Array(exports().memory.buffer);
  const text = (pointer: number) => {
    const bytes = heap();
    return String.fromCharCode(...bytes.subarray(pointer, bytes.indexOf(0, pointer)));
  };
  const classes = new Map<number, string>();
  const nothing = () => 0;
  const ignored = ['void', 'bool', 'integer', 'float', 'std_string', 'std_wstring', 'emval', 'memory_view'];
  return {
    env: {
      ...Object.fromEntries([...ignored, 'bigint'].map((kind) => [`_embind_register_${kind}`, nothing])),
      _embind_register_class: (...args: number[]) => {
        const [type] = args;
        const [name, , destructor] = args.slice(-3);
        classes.set(type, text(name));
        functions.set(`${text(name)}.delete`, { invoke: destructor, target: 0 });
      },
      _embind_register_class_constructor: (...[type, , , , invoke, target]: number[]) => {
        functions.set(`${classes.get(type)}.new`, { invoke, target });
      },
      _embind_register_class_function: (...[type, name, , , , invoke, target]: number[]) => {
        functions.set(`${classes.get(type)}.${text(name)}`, { invoke, target });
      },
      __cxa_allocate_exception: () => fault('the decoder found an error'),
      __cxa_throw: () => fault('the decoder found an error'),
      abort: () => fault('the decoder gave up'),
      emscripten_memcpy_big: (to: number, from: number, bytes: number) =>
        void heap().copyWithin(to, from, from + bytes),
      emscripten_resize_heap: (bytes: number) => Number(growMemory(exports().memory, bytes >>> 0)),
      strftime_l: nothing,
    },
    wasi_snapshot_preview1: {
      fd_write: nothing,
      fd_close: nothing,
      fd_seek: nothing,
      environ_get: nothing,
      environ_sizes_get: (count: number, bytes: number) => {
        const view = new DataView(exports().memory.buffer);
        view.setUint32(count, 0, true);
        view.setUint32(bytes, 0, true);
        return 0;
      },
    },
  };
}

function fault(reason: string): never {
  throw new Error(reason);
}
