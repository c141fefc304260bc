import { rotationOf } from '../pose.ts';
import type { GltfJson, JsonObject } from './gltf-json.ts';

/** Column-major 4 × 4. */
export type Matrix = readonly number[];

const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

/** The meshes of a scene: for each mesh that stands somewhere, where it stands. @throws input/malformed */
export function instancesOf(gltf: GltfJson): Map<number, Matrix[]> {
  const instances = new Map<number, Matrix[]>();
  const seen = new Set<number>();
  const waiting = rootsOf(gltf).map((node) => ({ node, parent: IDENTITY }));
  for (let next = waiting.pop(); next; next = waiting.pop()) {
    const json = gltf.item('nodes', next.node, 'a scene or node');
    const node = next.node as number;
    if (seen.has(node)) throw gltf.malformed('a tree of nodes', `node ${node} twice`);
    seen.add(node);
    const matrix = multiply(next.parent, matrixOf(gltf, json, `nodes[${node}]`));
    if (json.mesh !== undefined) {
      gltf.item('meshes', json.mesh, `nodes[${node}]`);
      const mesh = json.mesh as number;
      instances.set(mesh, [...(instances.get(mesh) ?? []), matrix]);
    }
    for (const child of gltf.array(json.children ?? [], `nodes[${node}].children`)) {
      waiting.push({ node: child, parent: matrix });
    }
  }
  return instances;
}

/** The nodes of the scene that is shown; without scenes, those that are nobody's children. */
function rootsOf(gltf: GltfJson): readonly unknown[] {
  if (gltf.list('scenes').length > 0) {
    const scene = gltf.item('scenes', gltf.root.scene ?? 0, 'scene');
    return gltf.array(scene.nodes ?? [], 'nodes of the scene');
  }
  const nodes = gltf.list('nodes');
  const children = new Set(nodes.flatMap((node, i) => childrenOf(gltf, node, i)));
  return nodes.map((_, index) => index).filter((index) => !children.has(index));
}

function childrenOf(gltf: GltfJson, node: unknown, index: number): readonly unknown[] {
  return gltf.array(gltf.object(node, `nodes[${index}]`).children ?? [], `nodes[${index}].children`);
}

function matrixOf(gltf: GltfJson, node: JsonObject, where: string): Matrix {
  if (node.matrix !== undefined) return numbers(gltf, node.matrix, 16, `${where}.matrix`);
  const [tx, ty, tz] = numbers(gltf, node.translation ?? [0, 0, 0], 3, `${where}.translation`);
  const [x, y, z, w] = numbers(gltf, node.rotation ?? [0, 0, 0, 1], 4, `${where}.rotation`);
  const [sx, sy, sz] = numbers(gltf, node.scale ?? [1, 1, 1], 3, `${where}.scale`);
  const r = rotationOf(w, x, y, z);
  return [
    ...[sx * r[0], sx * r[3], sx * r[6], 0],
    ...[sy * r[1], sy * r[4], sy * r[7], 0],
    ...[sz * r[2], sz * r[5], sz * r[8], 0],
    ...[tx, ty, tz, 1],
  ];
}

function numbers(gltf: GltfJson, value: unknown, length: number, where: string): readonly number[] {
  const list = gltf.array(value, where);
  if (list.length === length && list.every((item) => typeof item === 'number')) return list as number[];
  throw gltf.malformed(`${length} numbers at ${where}`, JSON.stringify(list));
}

function multiply(a: Matrix, b: Matrix): Matrix {
  return IDENTITY.map((_, at) => {
    const [row, column] = [at % 4, at - (at % 4)];
    return (
      a[row] * b[column] +
      a[row + 4] * b[column + 1] +
      a[row + 8] * b[column + 2] +
      a[row + 12] * b[column + 3]
    );
  });
}
