import { type DracoPart, unpackDraco } from './draco.ts';
import type { GltfBytes } from './gltf-bytes.ts';
import type { GltfJson } from './gltf-json.ts';
import type { PlainShape, Primitive } from './gltf-primitives.ts';
import { valuesOf } from './gltf-values.ts';

type Values = Float64Array | Float32Array;

/** Vertices and triangles of a primitive. */
export interface Shape {
  readonly count: number;
  /** x, y, z a vertex, the primitive's own coordinates. */
  readonly xyz: Values;
  readonly paint: Paint | undefined;
  /** Three vertices there are a triangle, or as the primitive's mode says; null: all in order. */
  readonly corners: Float64Array | Uint32Array | null;
}

/** Colours: `width` values a vertex, of which times `scale` are 0 to 255. */
interface Paint {
  readonly values: Values;
  readonly width: number;
  readonly scale: number;
}

/** @throws input/malformed, environment/wasm */
export async function readShape(gltf: GltfJson, { shape }: Primitive, bytes: GltfBytes): Promise<Shape> {
  return 'range' in shape ? packedShape(gltf, shape, bytes) : plainShape(gltf, shape, bytes);
}

async function packedShape(gltf: GltfJson, part: DracoPart, bytes: GltfBytes): Promise<Shape> {
  const packed = bytes.of(part.range);
  const mesh = await unpackDraco(packed, part);
  if (!mesh) {
    const found = `${packed.length} other bytes at ${part.range.begin} of their buffer`;
    throw gltf.malformed('a mesh packed by Draco, with positions', found);
  }
  const { colours, width } = mesh;
  return { ...mesh, paint: colours && { values: colours, width, scale: scaleOf(colours) } };
}

/** Integers that were not marked as normalised come as 0 to 255. */
function scaleOf(colours: Float32Array): number {
  return colours.some((value) => value > 1) ? 1 : 255;
}

function plainShape(gltf: GltfJson, shape: PlainShape, bytes: GltfBytes): Shape {
  const { positions, colours } = shape;
  return {
    count: positions.count,
    xyz: valuesOf(positions, bytes),
    paint: colours && {
      values: valuesOf(colours, bytes),
      width: colours.components,
      // Floats are 0 to 1, and so are integers once normalised; those that should have been are 0 to 255.
      scale: colours.values?.type === 'uint8' && !colours.isNormalised ? 1 : 255,
    },
    corners: cornersOf(gltf, shape, bytes),
  };
}

function cornersOf(
  gltf: GltfJson,
  { indices, positions }: PlainShape,
  bytes: GltfBytes,
): Float64Array | null {
  if (!indices) return null;
  const corners = valuesOf({ ...indices, isNormalised: false }, bytes);
  const wrong = corners.findIndex((corner) => corner < 0 || corner >= positions.count || corner % 1 !== 0);
  if (wrong < 0) return corners;
  throw gltf.malformed(`indices below ${positions.count}, the vertices there are`, `${corners[wrong]}`);
}
