import type { TriangleMesh } from '../../solid/triangle-mesh.ts';

/** A mesh's triangles with one normal a vertex: float32, y up, metres. */
export interface FlatMesh {
  readonly positions: Float32Array;
  readonly normals: Float32Array;
  readonly indices: Uint32Array;
}

/** Normals that agree to this share of a unit are one face's. */
const NORMAL_STEPS = 1e4;

/**
 * Splits vertices where faces meet at an edge, so that every viewer shades flat faces flat; vertices within a face
 * stay shared. Plan axes (x right, y ahead, z up) become glTF's (x right, y up, z back). Linear.
 */
export function flattenMesh({ positions: p, indices }: TriangleMesh): FlatMesh {
  const positions: number[] = [];
  const normals: number[] = [];
  const numbers = new Map<string, number>();
  const flat = new Uint32Array(indices.length);
  for (let i = 0; i < indices.length; i += 3) {
    const normal = triangleNormal(p, indices[i], indices[i + 1], indices[i + 2]);
    const face = normal.map((value) => Math.round(value * NORMAL_STEPS)).join(' ');
    for (let corner = i; corner < i + 3; corner++) {
      const vertex = indices[corner];
      const key = `${vertex} ${face}`;
      let number = numbers.get(key);
      if (number === undefined) {
        number = numbers.size;
        numbers.set(key, number);
        positions.push(p[3 * vertex], p[3 * vertex + 2], -p[3 * vertex + 1]);
        normals.push(normal[0], normal[2], -normal[1]);
      }
      flat[corner] = number;
    }
  }
  return { positions: Float32Array.from(positions), normals: Float32Array.from(normals), indices: flat };
}

/** Unit normal; upwards for a triangle without area, which has none. */
function triangleNormal(p: Float64Array, a: number, b: number, c: number): [number, number, number] {
  const [ux, uy, uz] = [p[3 * b] - p[3 * a], p[3 * b + 1] - p[3 * a + 1], p[3 * b + 2] - p[3 * a + 2]];
  const [vx, vy, vz] = [p[3 * c] - p[3 * a], p[3 * c + 1] - p[3 * a + 1], p[3 * c + 2] - p[3 * a + 2]];
  const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(x, y, z);
  return length === 0 ? [0, 0, 1] : [x / length, y / length, z / length];
}
