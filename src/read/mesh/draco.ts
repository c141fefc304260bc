import { createDracoModule, type DracoModule } from './draco-module.ts';
import type { ByteRange } from './gltf-json.ts';

/** A primitive packed by Draco (KHR_draco_mesh_compression). */
export interface DracoPart {
  readonly range: ByteRange;
  /** Ids of its attributes. */
  readonly position: number;
  readonly colour: number | undefined;
}

/** A primitive's vertices and triangles. */
export interface DracoMesh {
  readonly count: number;
  /** x, y, z a vertex. */
  readonly xyz: Float32Array;
  /** `width` values a vertex. */
  readonly colours: Float32Array | undefined;
  readonly width: number;
  readonly corners: Uint32Array;
}

/** Bytes of a 32-bit number, and numbers of a place or face. */
const NUMBER = 4;
const TRIPLE = 3;

/** Unpacks a mesh; null where the bytes make no sense. @throws environment/wasm */
export async function unpackDraco(packed: Uint8Array, part: DracoPart): Promise<DracoMesh | null> {
  const draco = await createDracoModule();
  try {
    return readMesh(draco, packed, part);
  } catch {
    // What the module throws is no error of ours: a trap, or an exception without a name.
    return null;
  }
}

function readMesh(draco: DracoModule, packed: Uint8Array, { position, colour }: DracoPart): DracoMesh | null {
  const begin = draco.allocate(packed.length);
  new Uint8Array(draco.memory.buffer).set(packed, begin);
  const mesh = draco.decode(begin, packed.length);
  if (mesh === 0) return null;
  const places = draco.attribute(mesh, position);
  const paint = colour === undefined ? 0 : draco.attribute(mesh, colour);
  const width = paint === 0 ? 0 : draco.componentCount(paint);
  if (places === 0 || draco.componentCount(places) !== TRIPLE) return null;
  const count = draco.pointCount(mesh);
  const xyz = takeFloats(draco, mesh, places, TRIPLE * count);
  const colours = width < TRIPLE ? undefined : takeFloats(draco, mesh, paint, width * count);
  const bytes = NUMBER * TRIPLE * draco.faceCount(mesh);
  const at = draco.allocate(bytes);
  if (!xyz || !draco.writeFaces(mesh, at, bytes)) return null;
  const corners = new Uint32Array(draco.memory.buffer.slice(at, at + bytes));
  return corners.every((corner) => corner < count) ? { count, xyz, colours, width, corners } : null;
}

function takeFloats(
  draco: DracoModule,
  mesh: number,
  attribute: number,
  count: number,
): Float32Array | undefined {
  const bytes = NUMBER * count;
  const at = draco.allocate(bytes);
  if (!draco.writeFloats(mesh, attribute, at, bytes)) return undefined;
  return new Float32Array(draco.memory.buffer.slice(at, at + bytes));
}
