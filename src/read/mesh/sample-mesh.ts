import type { PointChunk } from '../cloud-reader.ts';
import { isPlace } from '../is-place.ts';
import { LatticeSampler } from './lattice-sampler.ts';
import type { Mesh } from './mesh.ts';

/** What a mesh's triangles amount to. */
export interface MeshSize {
  /** Area, source units squared. */
  readonly area: number;
  /** Sum of half the triangles' perimeters: as many rows are scanned, at most, a step. */
  readonly halfPerimeter: number;
  /** Triangles with a corner that is nowhere. */
  readonly misplaced: number;
}

/** Measures a mesh. Complexity: O(triangles) */
export function measureMesh({ xyz, triangles }: Mesh): MeshSize {
  let area = 0;
  let halfPerimeter = 0;
  let misplaced = 0;
  for (let i = 0; i < triangles.length; i += 3) {
    const [a, b, c] = [3 * triangles[i], 3 * triangles[i + 1], 3 * triangles[i + 2]];
    if (!(isPlace(xyz, a) && isPlace(xyz, b) && isPlace(xyz, c))) {
      misplaced++;
      continue;
    }
    const [ux, uy, uz] = [xyz[b] - xyz[a], xyz[b + 1] - xyz[a + 1], xyz[b + 2] - xyz[a + 2]];
    const [vx, vy, vz] = [xyz[c] - xyz[a], xyz[c + 1] - xyz[a + 1], xyz[c + 2] - xyz[a + 2]];
    const twice = Math.sqrt((uy * vz - uz * vy) ** 2 + (uz * vx - ux * vz) ** 2 + (ux * vy - uy * vx) ** 2);
    area += twice / 2;
    const rest = Math.sqrt((ux - vx) ** 2 + (uy - vy) ** 2 + (uz - vz) ** 2);
    halfPerimeter +=
      (Math.sqrt(ux * ux + uy * uy + uz * uz) + Math.sqrt(vx * vx + vy * vy + vz * vz) + rest) / 2;
  }
  return { area, halfPerimeter, misplaced };
}

/** The finest step with which sampling costs no more than `most` points and rows. */
export function finestStep({ area, halfPerimeter }: MeshSize, most: number): number {
  return (halfPerimeter + Math.sqrt(halfPerimeter ** 2 + 4 * most * area)) / (2 * most);
}

export interface SampleOptions {
  /** Distance of neighbours, source units. */
  readonly step: number;
  /** Whether a triangle that the lattice misses gives its middle. */
  readonly isEveryTriangleSeen: boolean;
}

/**
 * Points on a mesh's triangles, one a square of `step`, see {@link LatticeSampler}; and its points as they are.
 *
 * Complexity: O(triangles + area / step² + perimeters / step)
 */
export function* sampleMesh(mesh: Mesh, options: SampleOptions): Generator<PointChunk> {
  const sampler = new LatticeSampler(mesh, options.step);
  for (const [begin, end] of mesh.points) {
    for (let vertex = begin; vertex < end; vertex++) {
      if (sampler.free === 0) yield sampler.take();
      sampler.addVertex(vertex);
    }
  }
  for (let triangle = 0; triangle < mesh.triangles.length; triangle += 3) {
    if (!sampler.start(triangle)) continue;
    while (!sampler.fill()) yield sampler.take();
    if (sampler.found === 0 && options.isEveryTriangleSeen) {
      if (sampler.free === 0) yield sampler.take();
      sampler.addMiddle();
    }
  }
  if (sampler.count > 0) yield sampler.take();
}
