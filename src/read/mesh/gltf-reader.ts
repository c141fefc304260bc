import { FloorPlanError } from '../../core/errors.ts';
import type { Warning } from '../../core/types.ts';
import type { ByteSource } from '../bytes/source.ts';
import type { OpenCloud, ReadProgress } from '../cloud-reader.ts';
import { GltfBytes, type GltfFile, readGltfText } from './gltf-bytes.ts';
import { GltfJson } from './gltf-json.ts';
import { FAN, POINTS, type Primitive, primitivesOf, rangesOf, TRIANGLES } from './gltf-primitives.ts';
import type { Matrix } from './gltf-scene.ts';
import { readShape, type Shape } from './gltf-shape.ts';
import { type Mesh, MeshBuilder } from './mesh.ts';
import { meshCloud } from './mesh-cloud.ts';

/** Keeps places where we do not look. */
const INSTANCING = 'EXT_mesh_gpu_instancing';
/** Extensions that do not change the shape, or not in a way that matters here. */
const HARMLESS =
  /^(KHR_(materials|texture|lights|mesh_quantization|draco_mesh_compression|meshopt_compression|animation|xmp)|EXT_(meshopt_compression|texture|lights)|MSFT_texture)/;

/** A glTF 2.0 model, text or GLB; its unit is the metre and y is up, by the standard. @throws input/… */
export async function openGltf(source: ByteSource): Promise<OpenCloud> {
  const file = await readGltfText(source);
  const gltf = new GltfJson(source.name, file.text);
  const warnings: Warning[] = [];
  for (const name of gltf.list('extensionsRequired').map(String)) {
    if (name === INSTANCING) throw unreadable(source.name);
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

interface Model {
  readonly gltf: GltfJson;
  readonly file: GltfFile;
  readonly primitives: readonly Primitive[];
}

async function readModel(source: ByteSource, model: Model, progress: ReadProgress): Promise<Mesh> {
  const { gltf, file, primitives } = model;
  const ranges = primitives.flatMap(({ shape }) => rangesOf(shape));
  const bytes = await GltfBytes.read(source, { file, gltf }, ranges, progress);
  const builder = new MeshBuilder(source.name);
  const standing = new Map<string, readonly number[]>();
  for (const primitive of primitives) {
    const { mesh, vertices, places, mode } = primitive;
    const shape = await readShape(gltf, primitive, bytes);
    const key = `${mesh}/${vertices}`;
    const bases = standing.get(key) ?? placeVertices(builder, shape, places);
    standing.set(key, bases);
    if (mode === POINTS) for (const base of bases) builder.addPoints(base, base + shape.count);
    else addTriangles(builder, mode, shape, bases);
  }
  return builder.build();
}

/** Adds the vertices everywhere they stand; returns the first vertex of each place. */
function placeVertices(
  builder: MeshBuilder,
  { count, xyz, paint }: Shape,
  places: readonly Matrix[],
): number[] {
  return places.map((m) => {
    const base = builder.vertices;
    for (let i = 0; i < count; i++) {
      const x = xyz[3 * i];
      const y = xyz[3 * i + 1];
      const z = xyz[3 * i + 2];
      builder.addVertex(
        m[0] * x + m[4] * y + m[8] * z + m[12],
        m[1] * x + m[5] * y + m[9] * z + m[13],
        m[2] * x + m[6] * y + m[10] * z + m[14],
      );
      if (paint) {
        const { values, width, scale } = paint;
        const at = width * i;
        builder.paintVertex(scale * values[at], scale * values[at + 1], scale * values[at + 2]);
      }
    }
    return base;
  });
}

function addTriangles(
  builder: MeshBuilder,
  mode: number,
  { count: vertices, corners }: Shape,
  bases: readonly number[],
): void {
  const count = corners?.length ?? vertices;
  const step = mode === TRIANGLES ? 3 : 1;
  for (const base of bases) {
    for (let i = 0; i + 2 < count; i += step) {
      const first = mode === FAN ? 0 : i;
      const [a, b, c] = corners ? [corners[first], corners[i + 1], corners[i + 2]] : [first, i + 1, i + 2];
      builder.addTriangle(base + a, base + b, base + c);
    }
  }
}

function unreadable(name: string): FloorPlanError {
  return new FloorPlanError(
    'input/unreadable',
    `${name}: expected a model of plain meshes, found one that needs the extension ${INSTANCING}`,
    { hint: 'Save the model without GPU instancing.', detail: { extension: INSTANCING } },
  );
}
