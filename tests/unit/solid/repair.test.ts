import { expect, test } from 'vitest';
import { closeTJunctions } from '../../../src/solid/t-junctions.ts';
import { openEdges, type TriangleMesh } from '../../../src/solid/triangle-mesh.ts';
import { splitShells, weld } from '../../../src/solid/weld.ts';

/** A tetrahedron whose edge 0–1 is cut at its middle on one side only. */
const halved = (): TriangleMesh => ({
  positions: Float64Array.of(0, 0, 0, 2, 0, 0, 0, 2, 0, 0, 0, 2, 1, 0, 0),
  indices: Uint32Array.of(0, 2, 4, 4, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3),
});

test('a vertex on an edge splits the triangle that ran past it', () => {
  expect(openEdges(halved().indices).length / 2).toBe(3);
  const closed = closeTJunctions(halved(), 1e-6);
  expect(openEdges(closed.indices)).toHaveLength(0);
  expect(closed.indices.length / 3).toBe(6);
});

test('a vertex beside the edge is left alone', () => {
  const mesh = halved();
  mesh.positions[3 * 4 + 1] = 0.01;
  expect(closeTJunctions(mesh, 1e-6)).toBe(mesh);
});

test('welding joins corners within the tolerance and drops triangles that collapse', () => {
  const corners = Float64Array.of(
    ...[0, 0, 0, 1, 0, 0, 0, 1, 0],
    ...[1, 0, 1e-6, 1, 1, 0, -1e-6, 1, 0],
    ...[0, 0, 0, 1, 0, 0, 0.5, 1e-6, 0],
  );
  const mesh = weld(corners, 1e-5);
  expect(mesh.indices).toEqual(Uint32Array.of(0, 1, 2, 1, 3, 2));
});

test('shells are told apart', () => {
  const first = halved();
  const positions = new Float64Array(2 * first.positions.length);
  positions.set(first.positions);
  positions.set(
    first.positions.map((value) => value + 10),
    first.positions.length,
  );
  const indices = Uint32Array.from([...first.indices, ...first.indices.map((vertex) => vertex + 5)]);
  const shells = splitShells({ positions, indices });
  expect(shells.map((shell) => shell.indices.length)).toEqual([15, 15]);
  expect(shells[1].positions.length).toBe(first.positions.length);
});
