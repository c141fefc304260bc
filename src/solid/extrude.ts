import earcut from 'earcut';
import { STEPS_PER_METRE } from '../core/geometry/clip-grid.ts';
import type { Polygon, Ring } from '../core/types.ts';
import { closeTJunctions } from './t-junctions.ts';
import type { TriangleMesh } from './triangle-mesh.ts';

/** Vertices dropped by the triangulation lie on an edge up to rounding: a hundredth of the Booleans' grid, m. */
export const ON_EDGE = 1e-8;

/**
 * A vertical prism: the polygon raised from one height to another.
 *
 * V vertices and h holes give 4V + 4h − 4 triangles over 2V shared vertices, closed as long as the polygon's rings
 * are simple and do not share vertices.
 *
 * @param polygon metres; rings simple, on the Booleans' grid
 * @param low, high heights, metres
 */
export function extrude(polygon: Polygon, low: number, high: number): TriangleMesh {
  const { xy, triangles } = capTriangles(polygon);
  const count = xy.length / 2;
  const positions = new Float64Array(6 * count);
  for (let i = 0; i < count; i++) {
    positions.set([xy[2 * i], xy[2 * i + 1], low], 3 * i);
    positions.set([xy[2 * i], xy[2 * i + 1], high], 3 * (count + i));
  }
  const indices: number[] = [];
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [triangles[i], triangles[i + 1], triangles[i + 2]];
    indices.push(count + a, count + b, count + c, c, b, a);
  }
  // One by one: an outline may have more sides than a call takes arguments.
  for (const index of sideTriangles([polygon.outer, ...polygon.holes], count)) indices.push(index);
  return closeTJunctions({ positions, indices: Uint32Array.from(indices) }, ON_EDGE);
}

/**
 * Triangulates a polygon; vertices on straight runs may be left out.
 *
 * @returns the vertices of all rings behind each other, and three numbers a triangle, counter-clockwise
 */
export function capTriangles({ outer, holes }: Polygon): { xy: Float64Array; triangles: number[] } {
  const rings = [outer, ...holes];
  const xy = new Float64Array(rings.reduce((sum, ring) => sum + ring.length, 0));
  const starts = placeRings(rings, xy);
  // Whole steps from a corner of the plan: products of such numbers are exact, so the triangulation never errs on
  // points that lie on edges.
  const steps = xy.map((value, i) => Math.round((value - xy[i % 2]) * STEPS_PER_METRE));
  const cap = earcut(steps, starts.slice(1));
  const triangles: number[] = [];
  for (let i = 0; i < cap.length; i += 3) {
    const [a, b, c] = [cap[i], cap[i + 1], cap[i + 2]];
    triangles.push(...(isCounterClockwise(steps, a, b, c) ? [a, b, c] : [a, c, b]));
  }
  return { xy, triangles };
}

/** Copies the rings behind each other; returns the first vertex of each. */
function placeRings(rings: readonly Ring[], into: Float64Array): number[] {
  const starts: number[] = [];
  let offset = 0;
  for (const ring of rings) {
    starts.push(offset / 2);
    into.set(ring, offset);
    offset += ring.length;
  }
  return starts;
}

function isCounterClockwise(flat: Float64Array, a: number, b: number, c: number): boolean {
  const [ax, ay] = [flat[2 * a], flat[2 * a + 1]];
  return (flat[2 * b] - ax) * (flat[2 * c + 1] - ay) > (flat[2 * c] - ax) * (flat[2 * b + 1] - ay);
}

/** Two triangles an edge; outer rings run counter-clockwise and holes clockwise, so all face away from the material. */
function sideTriangles(rings: readonly Ring[], count: number): number[] {
  const indices: number[] = [];
  let first = 0;
  for (const ring of rings) {
    const size = ring.length / 2;
    for (let i = 0; i < size; i++) {
      const [a, b] = [first + i, first + ((i + 1) % size)];
      indices.push(a, b, count + b, a, count + b, count + a);
    }
    first += size;
  }
  return indices;
}
