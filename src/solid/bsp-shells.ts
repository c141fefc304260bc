import { BufferAttribute, BufferGeometry } from 'three';
import { CSG } from 'three-csg-ts';
import { combine } from '../core/geometry/areas.ts';
import type { Polygon } from '../core/types.ts';
import { extrude } from './extrude.ts';
import type { Engine } from './part.ts';
import { separatePinches } from './pinches.ts';
import { closeTJunctions } from './t-junctions.ts';
import { splitShells, weld } from './weld.ts';

/** The BSP trees tell points apart at 1e-5 m; twice that joins what they cut apart. */
const SAME_POINT = 2e-5;
/** Cutters stick out this far below and above, so that no cut is flush, m. */
const OVERSHOOT = 0.5;

/**
 * The paper's engine ([Stojanovic19] §3.2): prisms combined by Boolean operations on BSP trees.
 *
 * three-csg-ts stands in for ThreeCSG.js, which no longer runs on any three of today; it gives the same triangles.
 * The trees cut one side of an edge only, so the result is welded and its T-junctions closed.
 */
export const bspShells: Engine = ({ base, changes, openings, low, high }) => {
  let csg = prisms(base, low, high);
  for (const opening of openings) {
    const bottom = opening.low > low ? opening.low : low - OVERSHOOT;
    const top = opening.high < high ? opening.high : high + OVERSHOOT;
    csg = csg.subtract(prisms([opening.base], bottom, top));
  }
  for (const { outline, operation } of changes) {
    const shape = separatePinches(combine('union', [outline]));
    csg =
      operation === 'add'
        ? csg.union(prisms(shape, low, high))
        : csg.subtract(prisms(shape, low - OVERSHOOT, high + OVERSHOOT));
  }
  const heights = [low, high, ...openings.flatMap((opening) => [opening.low, opening.high])];
  const welded = weld(toTriangles(csg, heights), SAME_POINT);
  return splitShells(closeTJunctions(welded, SAME_POINT));
};

/** Disjoint prisms as one operand. */
const prisms = (polygons: readonly Polygon[], low: number, high: number): CSG =>
  CSG.fromPolygons(polygons.flatMap((polygon) => prism(polygon, low, high).toPolygons()));

function prism(polygon: Polygon, low: number, high: number): CSG {
  const { positions, indices } = extrude(polygon, low, high);
  const geometry = new BufferGeometry();
  const corners = new Float64Array(3 * indices.length);
  indices.forEach((vertex, i) => {
    corners.set(positions.subarray(3 * vertex, 3 * vertex + 3), 3 * i);
  });
  geometry.setAttribute('position', new BufferAttribute(corners, 3));
  // The library carries normals along without using them.
  geometry.setAttribute('normal', new BufferAttribute(new Float64Array(corners.length), 3));
  return CSG.fromGeometry(geometry);
}

/** Fans of the convex polygons, float64 (the library's own mesh is float32); heights that are meant are met. */
function toTriangles(csg: CSG, heights: readonly number[]): Float64Array {
  const corners: number[] = [];
  for (const { vertices } of csg.toPolygons()) {
    for (let i = 1; i + 1 < vertices.length; i++) {
      for (const { pos } of [vertices[0], vertices[i], vertices[i + 1]]) {
        corners.push(pos.x, pos.y, levelled(pos.z, heights));
      }
    }
  }
  return Float64Array.from(corners);
}

/**
 * The height meant by z. Upright cutters leave points only on a prism's two levels and on the diagonals of its sides,
 * which may slide to a level; between openings they may not.
 */
function levelled(z: number, heights: readonly number[]): number {
  const nearest = heights.reduce((best, height) =>
    Math.abs(height - z) < Math.abs(best - z) ? height : best,
  );
  return heights.length === 2 || Math.abs(nearest - z) < SAME_POINT ? nearest : z;
}
