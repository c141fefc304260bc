import type { Solid } from '../core/types.ts';

/** Faces that meet flatter than this are one face to the eye. cos 20°. */
const FLAT = Math.cos(Math.PI / 9);

/**
 * Edges of a solid worth a line: where two faces meet at an angle, or where a face ends.
 *
 * Unlike three's EdgesGeometry this takes shared vertices as given and hashes numbers, not strings: 50 k triangles
 * take some tens of milliseconds. O(triangles).
 *
 * @param normals unit normal of every triangle, x, y, z
 * @param from first entry in `indices`, `to` one past the last
 * @returns line segments: x, y, z of either end
 */
export function featureEdges(
  { positions, indices }: Solid,
  normals: Float32Array,
  from: number,
  to: number,
): Float32Array {
  const vertices = positions.length / 3;
  const open = new Map<number, number>();
  const ends: number[] = [];
  for (let corner = from; corner < to; corner++) {
    const triangle = Math.floor(corner / 3);
    const a = indices[corner];
    const b = indices[corner % 3 === 2 ? corner - 2 : corner + 1];
    const key = Math.min(a, b) * vertices + Math.max(a, b);
    const other = open.get(key);
    if (other === undefined) {
      open.set(key, triangle);
      continue;
    }
    open.delete(key);
    if (cosine(normals, triangle, other) < FLAT) ends.push(a, b);
  }
  for (const key of open.keys()) ends.push(Math.floor(key / vertices), key % vertices);
  const segments = new Float32Array(ends.length * 3);
  ends.forEach((vertex, i) => {
    for (let axis = 0; axis < 3; axis++) segments[3 * i + axis] = positions[3 * vertex + axis];
  });
  return segments;
}

/** Unit normal of every triangle, x, y, z. */
export function triangleNormals({ positions, indices }: Solid): Float32Array {
  const normals = new Float32Array(indices.length);
  for (let t = 0; t < indices.length; t += 3) {
    const [a, b, c] = [3 * indices[t], 3 * indices[t + 1], 3 * indices[t + 2]];
    const [ux, uy, uz] = [0, 1, 2].map((k) => positions[b + k] - positions[a + k]);
    const [vx, vy, vz] = [0, 1, 2].map((k) => positions[c + k] - positions[a + k]);
    const [x, y, z] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    const length = Math.hypot(x, y, z) || 1;
    normals[t] = x / length;
    normals[t + 1] = y / length;
    normals[t + 2] = z / length;
  }
  return normals;
}

function cosine(normals: Float32Array, p: number, q: number): number {
  return (
    normals[3 * p] * normals[3 * q] +
    normals[3 * p + 1] * normals[3 * q + 1] +
    normals[3 * p + 2] * normals[3 * q + 2]
  );
}
