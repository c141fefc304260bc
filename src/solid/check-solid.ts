import type { Solid } from '../core/types.ts';
import { openEdges } from './triangle-mesh.ts';

/** What a solid measures, and whether it would hold water. */
export interface SolidCheck {
  /** Every group is a closed, outward-facing two-manifold, and there is at least one. */
  readonly watertight: boolean;
  /** Sum over the groups, m³. */
  readonly volume: number;
  /** Of all faces, m². */
  readonly area: number;
  /** Directed edges without exactly one partner. */
  readonly openEdges: number;
}

/** Measures a solid by the divergence theorem and counts its open edges, group by group; linear. */
export function checkSolid({ positions, indices, groups }: Solid): SolidCheck {
  let [volume, area, open] = [0, 0, 0];
  let isOutward = groups.length > 0;
  for (const { start, count } of groups) {
    open += openEdges(indices, start, start + count).length / 2;
    const measured = measureGroup(positions, indices.subarray(start, start + count));
    volume += measured.volume;
    area += measured.area;
    isOutward &&= measured.volume > 0;
  }
  return { watertight: isOutward && open === 0, volume, area, openEdges: open };
}

/** Tetrahedra from the group's first vertex, so a far origin costs no digits. */
function measureGroup(p: Float64Array, indices: Uint32Array): { volume: number; area: number } {
  const origin = 3 * indices[0];
  let [volume, area] = [0, 0];
  for (let i = 0; i < indices.length; i += 3) {
    const [a, b, c] = [3 * indices[i], 3 * indices[i + 1], 3 * indices[i + 2]];
    const [ux, uy, uz] = [p[b] - p[a], p[b + 1] - p[a + 1], p[b + 2] - p[a + 2]];
    const [vx, vy, vz] = [p[c] - p[a], p[c + 1] - p[a + 1], p[c + 2] - p[a + 2]];
    const [nx, ny, nz] = [uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx];
    area += Math.hypot(nx, ny, nz) / 2;
    volume +=
      (nx * (p[a] - p[origin]) + ny * (p[a + 1] - p[origin + 1]) + nz * (p[a + 2] - p[origin + 2])) / 6;
  }
  return { volume, area };
}
