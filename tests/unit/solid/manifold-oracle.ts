import loadManifold, { type Manifold, type ManifoldToplevel } from 'manifold-3d';
import type { Polygon, Ring, Solid } from '../../../src/core/types.ts';

/** An independent kernel (manifold-3d, C++) as judge of ours. */

let loaded: Promise<ManifoldToplevel> | undefined;

export function manifoldKernel(): Promise<ManifoldToplevel> {
  loaded ??= loadManifold().then((kernel) => {
    kernel.setup();
    return kernel;
  });
  return loaded;
}

const contour = (ring: Ring): [number, number][] =>
  Array.from({ length: ring.length / 2 }, (_, i) => [ring[2 * i], ring[2 * i + 1]]);

/** The prism as the other kernel builds it. */
export function oraclePrism(
  { Manifold }: ManifoldToplevel,
  { outer, holes }: Polygon,
  [low, high]: readonly [number, number],
): Manifold {
  return Manifold.extrude([outer, ...holes].map(contour), high - low).translate([0, 0, low]);
}

/** A group of ours read by the other kernel; it throws where the mesh is no closed manifold. */
export function readGroup(
  { Manifold, Mesh }: ManifoldToplevel,
  { positions, indices, groups }: Solid,
  group: number,
): Manifold {
  const { start, count } = groups[group];
  const used = [...new Set(indices.subarray(start, start + count))];
  const numbers = new Map(used.map((vertex, i) => [vertex, i]));
  const vertProperties = Float32Array.from(
    used.flatMap((vertex) => [...positions.subarray(3 * vertex, 3 * vertex + 3)]),
  );
  const triVerts = indices.slice(start, start + count).map((vertex) => numbers.get(vertex)!);
  return new Manifold(new Mesh({ numProp: 3, vertProperties, triVerts }));
}
