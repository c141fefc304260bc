import type { Product } from '../plan-writer.ts';
import { oneLine } from './model-notes.ts';
import { type MaterialName, meshSize, modelParts } from './model-parts.ts';

const HEADER = 80;
/** A normal, three corners and two bytes without a meaning. */
const FACET = 50;
/** STL names no unit; what reads it takes millimetres. */
const PER_METRE = 1000;
/** Of these are frames and panes: too thin to print. */
const THIN: ReadonlySet<MaterialName> = new Set(['frame', 'glass']);

/**
 * Writes plan.stl: the closed shells of the model's parts, fit for print, so without frames and panes; binary, millimetres,
 * z up, float32 relative to the frame's origin, which the header names as far as its 80 bytes reach. Facets without area
 * once rounded are left out: their corners are one.
 */
export function writeStl({ plan, solid }: Product): Uint8Array<ArrayBuffer> {
  const meshes = modelParts({ plan, solid })
    .flatMap(({ surfaces }) => surfaces)
    .filter(({ material }) => !THIN.has(material))
    .map(({ mesh }) => mesh);
  const view = new DataView(new ArrayBuffer(HEADER + 4 + meshSize(meshes).triangles * FACET));
  const origin = plan.frame.planOrigin.map((value) => Number(value.toFixed(4))).join(' ');
  // A header that began with "solid" would pass for text.
  const header = new TextEncoder().encode(`mm, z up, from ${origin} ${oneLine(plan.frame.unit)}; Grundriss`);
  new Uint8Array(view.buffer).set(header.subarray(0, HEADER));
  let facets = 0;
  for (const { positions, indices } of meshes) {
    const corners = new Float32Array(positions.map((value) => value * PER_METRE));
    for (let i = 0; i < indices.length; i += 3) {
      const triangle = [0, 1, 2].map((k) => corners.subarray(3 * indices[i + k], 3 * indices[i + k] + 3));
      if (hasCommonCorner(triangle)) continue;
      writeFacet(view, HEADER + 4 + facets++ * FACET, triangle);
    }
  }
  view.setUint32(HEADER, facets, true);
  return new Uint8Array(view.buffer, 0, HEADER + 4 + facets * FACET);
}

function hasCommonCorner([a, b, c]: readonly Float32Array[]): boolean {
  const isSame = (u: Float32Array, v: Float32Array) => u[0] === v[0] && u[1] === v[1] && u[2] === v[2];
  return isSame(a, b) || isSame(b, c) || isSame(c, a);
}

function writeFacet(view: DataView, offset: number, [a, b, c]: readonly Float32Array[]): void {
  const [ux, uy, uz] = [b[0] - a[0], b[1] - a[1], b[2] - a[2]];
  const [vx, vy, vz] = [c[0] - a[0], c[1] - a[1], c[2] - a[2]];
  const normal = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
  const length = Math.hypot(...normal) || 1;
  [...normal.map((value) => value / length), ...a, ...b, ...c].forEach((value, k) => {
    view.setFloat32(offset + 4 * k, value, true);
  });
}
