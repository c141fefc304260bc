import { describe, expect, it } from 'vitest';
import type { Solid } from '../../../src/core/types.ts';
import { featureEdges, triangleNormals } from '../../../src/view/feature-edges.ts';

/** A unit cube, outward, each face cut along a diagonal. */
const CUBE: Solid = {
  positions: new Float64Array([0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 0, 0, 1, 1, 0, 1, 1, 1, 1, 0, 1, 1]),
  indices: new Uint32Array(
    [
      [0, 2, 1, 0, 3, 2],
      [4, 5, 6, 4, 6, 7],
      [0, 1, 5, 0, 5, 4],
      [1, 2, 6, 1, 6, 5],
      [2, 3, 7, 2, 7, 6],
      [3, 0, 4, 3, 4, 7],
    ].flat(),
  ),
  groups: [],
};

describe('featureEdges', () => {
  it('draws the twelve edges of a cube and none of its diagonals', () => {
    const normals = triangleNormals(CUBE);
    const segments = featureEdges(CUBE, normals, 0, CUBE.indices.length);
    expect(segments.length / 6).toBe(12);
    for (let i = 0; i < segments.length; i += 6) {
      const length = Math.hypot(...[0, 1, 2].map((k) => segments[i + k] - segments[i + 3 + k]));
      expect(length).toBeCloseTo(1, 12);
    }
  });

  it('draws where a face ends', () => {
    const one: Solid = { ...CUBE, indices: CUBE.indices.slice(0, 6) };
    expect(featureEdges(one, triangleNormals(one), 0, 6).length / 6).toBe(4);
  });

  it('sees no edge between runs that are given apart', () => {
    const normals = triangleNormals(CUBE);
    expect(featureEdges(CUBE, normals, 0, 3).length / 6).toBe(3);
  });
});

describe('triangleNormals', () => {
  it('point out of the cube', () => {
    const normals = triangleNormals(CUBE);
    expect([...normals.slice(0, 3)]).toEqual([0, 0, -1]);
    expect([...normals.slice(6, 9)]).toEqual([0, 0, 1]);
  });
});
