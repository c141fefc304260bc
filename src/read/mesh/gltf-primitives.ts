import type { DracoPart } from './draco.ts';
import type { Accessor, ByteRange, GltfJson, JsonObject } from './gltf-json.ts';
import { instancesOf, type Matrix } from './gltf-scene.ts';

/** Ways to draw of glTF 2.0 §5.24.4. */
export const POINTS = 0;
export const TRIANGLES = 4;
const STRIP = 5;
export const FAN = 6;
const DRACO = 'KHR_draco_mesh_compression';

/** A part of a mesh, with everywhere it stands. */
export interface Primitive {
  readonly mesh: number;
  readonly mode: number;
  readonly shape: PlainShape | DracoPart;
  /** Equal for parts that share their vertices. */
  readonly vertices: string;
  readonly places: readonly Matrix[];
}

/** Vertices and triangles in accessors. */
export interface PlainShape {
  readonly positions: Accessor;
  readonly colours: Accessor | undefined;
  readonly indices: Accessor | undefined;
}

/** Where a shape's bytes lie. */
export function rangesOf(shape: PlainShape | DracoPart): readonly ByteRange[] {
  if ('range' in shape) return [shape.range];
  const { positions, colours, indices } = shape;
  const blocks = [positions, colours, indices].flatMap((accessor) => [
    accessor?.values,
    accessor?.sparse?.indices,
    accessor?.sparse?.values,
  ]);
  return blocks.flatMap((block) => (block ? [block.range] : []));
}

/** The parts of all meshes that stand somewhere. @throws input/malformed */
export function primitivesOf(gltf: GltfJson): Primitive[] {
  return [...instancesOf(gltf)].flatMap(([mesh, places]) => {
    const where = `meshes[${mesh}].primitives`;
    const list = gltf.array(gltf.item('meshes', mesh, 'a node').primitives, where);
    return list.flatMap((json, i) => {
      const read = primitiveOf(gltf, gltf.object(json, `${where}[${i}]`), `${where}[${i}]`);
      return read ? [{ ...read, mesh, places }] : [];
    });
  });
}

/** Null for lines, and for what has no place. */
function primitiveOf(
  gltf: GltfJson,
  json: JsonObject,
  where: string,
): Omit<Primitive, 'mesh' | 'places'> | null {
  const mode = gltf.count(json.mode, `${where}.mode`, TRIANGLES);
  const attributes = gltf.object(json.attributes, `${where}.attributes`);
  if (![POINTS, TRIANGLES, STRIP, FAN].includes(mode) || attributes.POSITION === undefined) return null;
  const draco = gltf.object(json.extensions ?? {}, `${where}.extensions`)[DRACO];
  if (draco !== undefined) {
    const shape = dracoPart(gltf, gltf.object(draco, `${where}.${DRACO}`), `${where}.${DRACO}`);
    // Strips come out as triangles.
    return { mode: TRIANGLES, shape, vertices: JSON.stringify(shape) };
  }
  const shape = plainShape(gltf, { ...attributes, indices: json.indices }, where);
  return { mode, shape, vertices: `${attributes.POSITION}/${attributes.COLOR_0}` };
}

function dracoPart(gltf: GltfJson, json: JsonObject, where: string): DracoPart {
  const ids = gltf.object(json.attributes, `${where}.attributes`);
  const colour = ids.COLOR_0;
  return {
    range: gltf.range(json.bufferView, where),
    position: gltf.count(ids.POSITION, `${where}.attributes.POSITION`),
    colour: colour === undefined ? undefined : gltf.count(colour, `${where}.attributes.COLOR_0`),
  };
}

function plainShape(
  gltf: GltfJson,
  { POSITION, COLOR_0, indices: corners }: JsonObject,
  where: string,
): PlainShape {
  const positions = gltf.accessor(POSITION, `${where}.attributes.POSITION`);
  const colours = COLOR_0 === undefined ? undefined : gltf.accessor(COLOR_0, `${where}.attributes.COLOR_0`);
  if (positions.components !== 3)
    throw gltf.malformed(`VEC3 positions at ${where}`, `${positions.components} values`);
  if (colours && (colours.components < 3 || colours.count < positions.count)) {
    throw gltf.malformed(
      `${positions.count} colours of 3 or 4 values at ${where}`,
      `${colours.count} of ${colours.components}`,
    );
  }
  const indices = corners === undefined ? undefined : gltf.accessor(corners, `${where}.indices`);
  return { positions, colours, indices };
}
