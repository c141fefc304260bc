import { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import { viewOf } from '../bytes/view-of.ts';
import type { OpenCloud, ReadProgress } from '../cloud-reader.ts';
import { NUMBER_BYTES, NUMBER_READERS, type NumberType } from '../records.ts';
import { GltfBytes, type GltfFile, readGltfText } from './gltf-bytes.ts';
import { type Accessor, type ByteRange, GltfJson, type JsonObject, type ValueBlock } from './gltf-json.ts';
import { instancesOf, type Matrix } from './gltf-scene.ts';
import { type Mesh, MeshBuilder } from './mesh.ts';
import { meshCloud } from './mesh-cloud.ts';

/** Extensions that keep the shape where we do not look, and how to save the model without. */
const UNREADABLE: Readonly<Record<string, string>> = {
  KHR_draco_mesh_compression: 'Save the model without Draco compression.',
  EXT_meshopt_compression: 'Save the model without meshopt compression.',
  KHR_meshopt_compression: 'Save the model without meshopt compression.',
  EXT_mesh_gpu_instancing: 'Save the model without GPU instancing.',
};
/** Extensions that do not change the shape, or not in a way that matters here. */
const HARMLESS =
  /^(KHR_(materials|texture|lights|mesh_quantization|animation|xmp)|EXT_(texture|lights)|MSFT_texture)/;

/** Ways to draw of glTF 2.0 §5.24.4. */
const POINTS = 0;
const TRIANGLES = 4;
const STRIP = 5;
const FAN = 6;

/** A glTF 2.0 model, text or GLB; its unit is the metre and y is up, by the standard. @throws input/… */
export async function openGltf(source: ByteSource): Promise<OpenCloud> {
  const file = await readGltfText(source);
  const gltf = new GltfJson(source.name, file.text);
  const warnings: Warning[] = [];
  for (const name of gltf.list('extensionsRequired').map(String)) {
    if (UNREADABLE[name]) throw unreadable(source.name, name);
    if (HARMLESS.test(name)) continue;
    warnings.push({
      code: 'read/extension-unknown',
      message: `The model needs the extension ${name.slice(0, 40)}, which is not known here: parts of it may be missing.`,
      hint: 'Export the model as plain GLB, without extensions.',
    });
  }
  const model = { gltf, file: { ...file, text: '' }, primitives: primitivesOf(gltf) };
  return meshCloud({
    source,
    unit: 'm',
    up: 'y',
    warnings,
    load: (progress) => readModel(source, model, progress),
  });
}

/** A part of a mesh, with everywhere it stands. */
interface Primitive {
  readonly mesh: number;
  readonly mode: number;
  readonly positions: Accessor;
  readonly colours: Accessor | undefined;
  readonly indices: Accessor | undefined;
  /** Equal for parts that share their vertices. */
  readonly vertices: string;
  readonly places: readonly Matrix[];
}

interface Model {
  readonly gltf: GltfJson;
  readonly file: GltfFile;
  readonly primitives: readonly Primitive[];
}

function primitivesOf(gltf: GltfJson): Primitive[] {
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
  const positions = gltf.accessor(attributes.POSITION, `${where}.attributes.POSITION`);
  const colour = attributes.COLOR_0;
  const colours = colour === undefined ? undefined : gltf.accessor(colour, `${where}.attributes.COLOR_0`);
  if (positions.components !== 3)
    throw gltf.malformed(`VEC3 positions at ${where}`, `${positions.components} values`);
  if (colours && (colours.components < 3 || colours.count < positions.count)) {
    throw gltf.malformed(
      `${positions.count} colours of 3 or 4 values at ${where}`,
      `${colours.count} of ${colours.components}`,
    );
  }
  const indices = json.indices === undefined ? undefined : gltf.accessor(json.indices, `${where}.indices`);
  return { mode, positions, colours, indices, vertices: `${attributes.POSITION}/${colour}` };
}

async function readModel(source: ByteSource, model: Model, progress: ReadProgress): Promise<Mesh> {
  const { gltf, file, primitives } = model;
  const accessors = primitives.flatMap(({ positions, colours, indices }) => [positions, colours, indices]);
  const bytes = await GltfBytes.read(source, { file, gltf }, accessors.flatMap(rangesOf), progress);
  const builder = new MeshBuilder(source.name);
  const standing = new Map<string, readonly number[]>();
  for (const primitive of primitives) {
    const key = `${primitive.mesh}/${primitive.vertices}`;
    const bases = standing.get(key) ?? placeVertices(builder, primitive, bytes);
    standing.set(key, bases);
    const { count } = primitive.positions;
    if (primitive.mode === POINTS) for (const base of bases) builder.addPoints(base, base + count);
    else addTriangles(builder, primitive, cornersOf(gltf, primitive, bytes), bases);
  }
  return builder.build();
}

function rangesOf(accessor: Accessor | undefined): ByteRange[] {
  const blocks = [accessor?.values, accessor?.sparse?.indices, accessor?.sparse?.values];
  return blocks.flatMap((block) => (block ? [block.range] : []));
}

/** Adds the vertices everywhere they stand; returns the first vertex of each place. */
function placeVertices(
  builder: MeshBuilder,
  { positions, colours, places }: Primitive,
  bytes: GltfBytes,
): number[] {
  const local = valuesOf(positions, bytes);
  const paint = colours && valuesOf(colours, bytes);
  const width = colours?.components ?? 0;
  // Floats are 0 to 1, and so are integers once normalised; those that should have been are 0 to 255.
  const scale = colours?.values?.type === 'uint8' && !colours.isNormalised ? 1 : 255;
  return places.map((m) => {
    const base = builder.vertices;
    for (let i = 0; i < positions.count; i++) {
      const x = local[3 * i];
      const y = local[3 * i + 1];
      const z = local[3 * i + 2];
      builder.addVertex(
        m[0] * x + m[4] * y + m[8] * z + m[12],
        m[1] * x + m[5] * y + m[9] * z + m[13],
        m[2] * x + m[6] * y + m[10] * z + m[14],
      );
      if (paint) {
        const at = width * i;
        builder.paintVertex(scale * paint[at], scale * paint[at + 1], scale * paint[at + 2]);
      }
    }
    return base;
  });
}

function cornersOf(gltf: GltfJson, { indices, positions }: Primitive, bytes: GltfBytes): Float64Array | null {
  if (!indices) return null;
  const corners = valuesOf({ ...indices, isNormalised: false }, bytes);
  const wrong = corners.findIndex((corner) => corner < 0 || corner >= positions.count || corner % 1 !== 0);
  if (wrong < 0) return corners;
  throw gltf.malformed(`indices below ${positions.count}, the vertices there are`, `${corners[wrong]}`);
}

function addTriangles(
  builder: MeshBuilder,
  { mode, positions }: Primitive,
  corners: Float64Array | null,
  bases: readonly number[],
): void {
  const count = corners?.length ?? positions.count;
  const step = mode === TRIANGLES ? 3 : 1;
  for (const base of bases) {
    for (let i = 0; i + 2 < count; i += step) {
      const first = mode === FAN ? 0 : i;
      const [a, b, c] = corners ? [corners[first], corners[i + 1], corners[i + 2]] : [first, i + 1, i + 2];
      builder.addTriangle(base + a, base + b, base + c);
    }
  }
}

/** Every value of an accessor, sparse ones in place, normalised where it says so. */
function valuesOf(accessor: Accessor, bytes: GltfBytes): Float64Array {
  const { count, components, values, sparse, isNormalised } = accessor;
  const result = new Float64Array(count * components);
  if (values) readBlock(values, bytes, { count, components }, result);
  if (sparse) {
    const places = new Float64Array(sparse.count);
    const replaced = new Float64Array(sparse.count * components);
    readBlock(sparse.indices, bytes, { count: sparse.count, components: 1 }, places);
    readBlock(sparse.values, bytes, { count: sparse.count, components }, replaced);
    for (let i = 0; i < sparse.count; i++) {
      if (places[i] < count)
        result.set(replaced.subarray(components * i, components * (i + 1)), components * places[i]);
    }
  }
  const type = values?.type ?? sparse?.values.type;
  if (isNormalised && type) normalise(result, type);
  return result;
}

function readBlock(
  { range, type, offset, stride }: ValueBlock,
  bytes: GltfBytes,
  { count, components }: { readonly count: number; readonly components: number },
  into: Float64Array,
): void {
  const block = bytes.of(range);
  const view = viewOf(block);
  const size = NUMBER_BYTES[type];
  const read = NUMBER_READERS[type];
  for (let i = 0; i < count; i++) {
    const at = offset + i * stride;
    for (let part = 0; part < components; part++)
      into[i * components + part] = read(view, at + part * size, true);
  }
}

/** Integers to 0 … 1, or −1 … 1, glTF 2.0 §3.11. */
function normalise(values: Float64Array, type: NumberType): void {
  if (type === 'float32') return;
  const bits = 8 * NUMBER_BYTES[type] - (type.startsWith('u') ? 0 : 1);
  const most = 2 ** bits - 1;
  for (let i = 0; i < values.length; i++) values[i] = Math.max(-1, values[i] / most);
}

function unreadable(name: string, extension: string): FloorPlanError {
  return new FloorPlanError(
    'input/unreadable',
    `${name}: expected an uncompressed model, found one that needs the extension ${extension}`,
    { hint: UNREADABLE[extension], detail: { extension } },
  );
}
