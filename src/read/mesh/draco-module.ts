import { compileInlined, growMemory, wasmError } from '../wasm.ts';

/** What is needed of Draco's decoder; addresses are bytes of `memory`, objects addresses. */
export interface DracoModule {
  readonly memory: WebAssembly.Memory;
  allocate(bytes: number): number;
  /** Decodes a mesh; 0 where the bytes make no sense. */
  decode(at: number, bytes: number): number;
  pointCount(mesh: number): number;
  faceCount(mesh: number): number;
  /** An attribute by the id that glTF gives; 0 where there is none. */
  attribute(mesh: number, id: number): number;
  componentCount(attribute: number): number;
  /** Writes the values of all points as 32-bit floats; false where they are not `bytes` long. */
  writeFloats(mesh: number, attribute: number, at: number, bytes: number): boolean;
  /** Writes three 32-bit points a face. */
  writeFaces(mesh: number, at: number, bytes: number): boolean;
}

/** By the names that the build of draco3dgltf 1.5.7 made up: its own loader tells which is which. */
interface Exports {
  readonly e: WebAssembly.Memory;
  /** Constructors, malloc. */
  f(): void;
  Qb(bytes: number): number;
  /** DecoderBuffer: new, Init; Decoder: new, DecodeBufferToMesh; Status.ok. */
  i(): number;
  j(buffer: number, at: number, bytes: number): void;
  Ja(): number;
  ib(decoder: number, buffer: number, mesh: number): number;
  X(status: number): number;
  /** Mesh: new, num_faces, num_points. */
  P(): number;
  Q(mesh: number): number;
  S(mesh: number): number;
  /** Decoder: GetAttributeByUniqueId; PointAttribute.num_components. */
  Qa(decoder: number, mesh: number, id: number): number;
  v(attribute: number): number;
  /** Decoder: GetAttributeDataArrayForAllPoints, GetTrianglesUInt32Array. */
  eb(decoder: number, mesh: number, attribute: number, type: number, bytes: number, at: number): number;
  Wa(decoder: number, mesh: number, bytes: number, at: number): number;
}

/** Draco's DT_FLOAT32. */
const FLOAT32 = 9;

let compiling: Promise<WebAssembly.Module> | null = null;

/**
 * A fresh instance of Draco's decoder, for one mesh: it need not give back what it took.
 *
 * The package's own loader is left aside: it asks where it runs, and under Node it loads files by itself and turns every
 * unhandled rejection of the process into a crash.
 *
 * @throws environment/wasm
 */
export async function createDracoModule(): Promise<DracoModule> {
  const { exports } = await instantiate(() => memory);
  const draco = exports as unknown as Exports;
  const memory = draco.e;
  draco.f();
  const decoder = draco.Ja();
  return {
    memory,
    allocate: (bytes) => draco.Qb(bytes) || fail('out of memory'),
    decode(at, bytes) {
      const buffer = draco.i();
      draco.j(buffer, at, bytes);
      const mesh = draco.P();
      return draco.X(draco.ib(decoder, buffer, mesh)) ? mesh : 0;
    },
    pointCount: (mesh) => draco.S(mesh) >>> 0,
    faceCount: (mesh) => draco.Q(mesh) >>> 0,
    attribute: (mesh, id) => draco.Qa(decoder, mesh, id),
    componentCount: (attribute) => draco.v(attribute),
    writeFloats: (mesh, attribute, at, bytes) => draco.eb(decoder, mesh, attribute, FLOAT32, bytes, at) !== 0,
    writeFaces: (mesh, at, bytes) => draco.Wa(decoder, mesh, bytes, at) !== 0,
  };
}

async function instantiate(memory: () => WebAssembly.Memory): Promise<WebAssembly.Instance> {
  const a = {
    a: () => fail('the decoder gave up'),
    b: () => fail('the decoder found an error'),
    c: (bytes: number) => Number(growMemory(memory(), bytes >>> 0)),
    d: (to: number, from: number, bytes: number) =>
      void new Uint8Array(memory().buffer).copyWithin(to, from, from + bytes),
  };
  try {
    compiling ??= compile();
    return await WebAssembly.instantiate(await compiling, { a });
  } catch (cause) {
    throw wasmError('A model packed by Draco', 'the model without Draco compression', cause);
  }
}

async function compile(): Promise<WebAssembly.Module> {
  const { default: uri } = await import('draco3dgltf/draco_decoder_gltf.wasm?url&inline');
  return compileInlined(uri);
}

function fail(reason: string): never {
  throw new Error(reason);
}
