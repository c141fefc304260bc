import { rootOf, separateSets, unite } from '../core/union-find.ts';
import type { TriangleMesh } from './triangle-mesh.ts';

/**
 * Gives coincident corners of loose triangles one vertex and drops triangles that collapse.
 *
 * Corners join the first vertex within `tolerance`, found through a grid of cells that wide; linear.
 *
 * @param corners nine numbers a triangle, metres
 */
export function weld(corners: Float64Array, tolerance: number): TriangleMesh {
  const positions: number[] = [];
  const cells = new Map<string, number[]>();
  const vertices = new Uint32Array(corners.length / 3);
  for (let i = 0; i < vertices.length; i++) {
    vertices[i] = vertexAt(corners.subarray(3 * i, 3 * i + 3), { positions, cells, tolerance });
  }
  const indices: number[] = [];
  for (let i = 0; i < vertices.length; i += 3) {
    const [a, b, c] = vertices.subarray(i, i + 3);
    if (isThin(positions, [a, b, c], tolerance)) continue;
    indices.push(a, b, c);
  }
  return { positions: Float64Array.from(positions), indices: Uint32Array.from(indices) };
}

/** Splits a mesh into the pieces that hang together by shared vertices, each with its own compact vertices. */
export function splitShells({ positions, indices }: TriangleMesh): TriangleMesh[] {
  const parent = separateSets(positions.length / 3);
  for (let i = 0; i < indices.length; i += 3) {
    unite(parent, indices[i], indices[i + 1]);
    unite(parent, indices[i], indices[i + 2]);
  }
  const byRoot = new Map<number, number[]>();
  for (let i = 0; i < indices.length; i += 3) {
    const root = rootOf(parent, indices[i]);
    const shell = byRoot.get(root) ?? [];
    shell.push(indices[i], indices[i + 1], indices[i + 2]);
    byRoot.set(root, shell);
  }
  return [...byRoot.values()].map((shell) => compact(positions, shell));
}

function compact(positions: Float64Array, indices: readonly number[]): TriangleMesh {
  const numbers = new Map<number, number>();
  const kept: number[] = [];
  const renumbered = indices.map((vertex) => {
    const known = numbers.get(vertex);
    if (known !== undefined) return known;
    numbers.set(vertex, numbers.size);
    kept.push(...positions.subarray(3 * vertex, 3 * vertex + 3));
    return numbers.size - 1;
  });
  return { positions: Float64Array.from(kept), indices: Uint32Array.from(renumbered) };
}

function vertexAt(
  [x, y, z]: Float64Array,
  known: { positions: number[]; cells: Map<string, number[]>; tolerance: number },
): number {
  const { positions, cells, tolerance } = known;
  const cell = [x, y, z].map((value) => Math.floor(value / tolerance));
  for (let k = 0; k < 27; k++) {
    const [dx, dy, dz] = [(k % 3) - 1, (Math.floor(k / 3) % 3) - 1, Math.floor(k / 9) - 1];
    for (const vertex of cells.get(`${cell[0] + dx} ${cell[1] + dy} ${cell[2] + dz}`) ?? []) {
      const p = 3 * vertex;
      if (Math.hypot(positions[p] - x, positions[p + 1] - y, positions[p + 2] - z) <= tolerance)
        return vertex;
    }
  }
  const vertex = positions.length / 3;
  positions.push(x, y, z);
  const key = cell.join(' ');
  cells.set(key, [...(cells.get(key) ?? []), vertex]);
  return vertex;
}

/** Whether the triangle's smallest height is below the tolerance: its neighbours close over it. */
function isThin(
  p: readonly number[],
  [a, b, c]: readonly [number, number, number],
  tolerance: number,
): boolean {
  if (a === b || b === c || c === a) return true;
  const side = (from: number, to: number) => [0, 1, 2].map((k) => p[3 * to + k] - p[3 * from + k]);
  const [u, v, w] = [side(a, b), side(a, c), side(b, c)];
  const doubled = Math.hypot(u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]);
  const longest = Math.max(Math.hypot(...u), Math.hypot(...v), Math.hypot(...w));
  return doubled / longest < tolerance;
}
