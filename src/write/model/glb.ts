import { areaOf } from '../../core/geometry/areas.ts';
import type { PointCloud, Storey } from '../../core/types.ts';
import type { TriangleMesh } from '../../solid/triangle-mesh.ts';
import { rounded } from '../decimals.ts';
import { noPointsFor, type Product } from '../plan-writer.ts';
import { flattenMesh } from './flat-mesh.ts';
import { GlbFile } from './glb-file.ts';
import { meshoptPacker } from './meshopt-packer.ts';
import { MATERIALS, type MaterialName, modelParts } from './model-parts.ts';

/** Points of the cloud that go along where asked for: a few MB. */
const CLOUD_POINTS = 200_000;
/** Drawing mode of glTF. */
const POINTS = 0;
/** Decimals of measures in extras: 0.1 mm. */
const DIGITS = 4;

/**
 * Writes plan.glb: glTF 2.0 in metres, y up, flat-shaded; a node a storey, which tells its rooms in `extras`, and in it
 * a node a part: `wall-0`, `floor-0`, `column-0`, `door-0`, `window-0` …
 *
 * Coordinates are float32 relative to the frame's origin, which stands with full digits in `asset.extras.frame`, so
 * a building at UTM coordinates loses nothing.
 */
export async function writeGlb(product: Product): Promise<Uint8Array<ArrayBuffer>> {
  const file = new GlbFile();
  return finish(file, product, addStoreys(file, product));
}

/**
 * Writes {@link writeGlb} with an even sample of the scan's points in their colours, as the node `cloud`.
 *
 * @throws result/cannot-write for a plan without its scan
 */
export async function writeCloudGlb(product: Product): Promise<Uint8Array<ArrayBuffer>> {
  const { crop, outliers } = product;
  if (crop === undefined) throw noPointsFor('plan.points.glb', 'glb-points');
  const file = new GlbFile();
  const nodes = addStoreys(file, product);
  if (crop.positions.length > 0) nodes.push(addCloud(file, crop, outliers));
  return finish(file, product, nodes);
}

async function finish(
  file: GlbFile,
  { name, plan, options }: Product,
  nodes: readonly number[],
): Promise<Uint8Array<ArrayBuffer>> {
  const root = {
    asset: { version: '2.0', generator: 'Grundriss', extras: { frame: plan.frame } },
    scene: 0,
    scenes: [nodes.length > 0 ? { name, nodes } : { name }],
  };
  return file.toBytes(root, options.glbPacking === 'meshopt' ? await meshoptPacker() : undefined);
}

/** @returns the nodes of storeys that have parts; a node without any would be empty */
function addStoreys(file: GlbFile, product: Product): number[] {
  const materials = new Map<MaterialName, number>();
  const materialOf = (name: MaterialName): number => {
    const known = materials.get(name) ?? file.add('materials', material(name));
    materials.set(name, known);
    return known;
  };
  const children = product.plan.storeys.map((): number[] => []);
  for (const { name, storey, facts, surfaces } of modelParts(product)) {
    const primitives = surfaces.map((surface) => ({
      ...meshPrimitive(file, surface.mesh),
      material: materialOf(surface.material),
    }));
    const mesh = file.add('meshes', { name, primitives });
    const extras = { ...facts, storey: product.plan.storeys[storey].index };
    children[storey].push(file.add('nodes', { name, mesh, extras }));
  }
  return product.plan.storeys.flatMap((storey, i) => {
    if (children[i].length === 0) return [];
    const name = `storey-${storey.index}`;
    return file.add('nodes', { name, children: children[i], extras: storeyFacts(storey) });
  });
}

function storeyFacts({ index, floor, height, rooms }: Storey): object {
  return {
    storey: index,
    floor: rounded(floor, DIGITS),
    height: rounded(height, DIGITS),
    rooms: rooms.map((room) => ({
      name: room.name,
      areaM2: rounded(areaOf([room.outline]), DIGITS),
      height: rounded(room.height, DIGITS),
    })),
  };
}

function meshPrimitive(file: GlbFile, mesh: TriangleMesh): object {
  const { positions, normals, indices } = flattenMesh(mesh);
  return {
    attributes: { POSITION: file.addPositions(positions), NORMAL: file.addNormals(normals) },
    indices: file.addIndices(indices, positions.length / 3),
  };
}

function material(name: MaterialName): object {
  const { colour, opacity, roughness } = MATERIALS[name];
  const pbrMetallicRoughness = {
    baseColorFactor: [...colour, opacity],
    metallicFactor: 0,
    roughnessFactor: roughness,
  };
  return { name, pbrMetallicRoughness, ...(opacity < 1 && { alphaMode: 'BLEND' }) };
}

/**
 * Every so manieth point that is no outlier: a cloud is in order of its lattice cells, so the sample is even.
 *
 * @returns its node
 */
function addCloud(
  file: GlbFile,
  { positions, attributes }: PointCloud,
  kept: Uint32Array | undefined,
): number {
  const all = kept?.length ?? positions.length / 3;
  const count = Math.min(CLOUD_POINTS, all);
  const places = new Float32Array(3 * count);
  const { colour } = attributes;
  const colours = new Uint8Array(colour === undefined ? 0 : 4 * count).fill(255);
  for (let i = 0; i < count; i++) {
    const at = Math.floor((i * all) / count);
    const point = 3 * (kept?.[at] ?? at);
    // 0 − y, since −y may be a negative zero.
    places.set([positions[point], positions[point + 2], 0 - positions[point + 1]], 3 * i);
    if (colour !== undefined) {
      for (let k = 0; k < 3; k++) colours[4 * i + k] = LINEAR[colour[point + k]];
    }
  }
  const coloured = colour === undefined ? {} : { COLOR_0: file.addColours(colours) };
  const attributesOf = { POSITION: file.addPositions(places), ...coloured };
  const mesh = file.add('meshes', {
    name: 'cloud',
    primitives: [{ mode: POINTS, attributes: attributesOf }],
  });
  return file.add('nodes', { name: 'cloud', mesh, extras: { points: count, of: all } });
}

/** Colours of scans are sRGB, those of glTF's vertices are linear (IEC 61966-2-1). */
const LINEAR = Uint8Array.from({ length: 256 }, (_, i) => {
  const value = i / 255;
  return Math.round(255 * (value <= 0.04045 ? value / 12.92 : ((value + 0.055) / 1.055) ** 2.4));
});
