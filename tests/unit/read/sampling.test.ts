import { describe, expect, it } from 'vitest';
import { type Mesh, MeshBuilder } from '../../../src/read/mesh/mesh.ts';
import { meshCloud } from '../../../src/read/mesh/mesh-cloud.ts';
import { finestStep, measureMesh, sampleMesh } from '../../../src/read/mesh/sample-mesh.ts';
import { memorySource } from './memory-source.ts';

type Point = readonly [number, number, number];

function meshOf(
  vertices: readonly Point[],
  faces: readonly (readonly number[])[],
  colours?: readonly Point[],
): Mesh {
  const builder = new MeshBuilder('a');
  vertices.forEach((vertex, i) => {
    builder.addVertex(...vertex);
    if (colours) builder.paintVertex(...colours[i]);
  });
  for (const face of faces) builder.addPolygon(face);
  return builder.build();
}

function samples(mesh: Mesh, step: number, isEveryTriangleSeen = true): number[][] {
  const found: number[][] = [];
  for (const { count, xyz } of sampleMesh(mesh, { step, isEveryTriangleSeen })) {
    for (let i = 0; i < count; i++) found.push([...xyz.subarray(3 * i, 3 * i + 3)]);
  }
  return found;
}

/** To a nanometre, in an order of their own. */
const asSet = (points: number[][]) => points.map((point) => point.map((v) => v.toFixed(9)).join(' ')).sort();

const RECTANGLE: Point[] = [
  [1, 2, 0.5],
  [5, 2, 0.5],
  [5, 2, 3],
  [1, 2, 3],
];
const TILTED: Point[] = RECTANGLE.map(([x, y, z]) => [
  0.36 * x + 0.48 * y - 0.8 * z,
  -0.8 * x + 0.6 * y,
  0.48 * x + 0.64 * y + 0.6 * z,
]);

describe.each([
  ['upright', RECTANGLE],
  ['tilted', TILTED],
])('a rectangle %s', (_, corners) => {
  const [a, b, c, d] = corners;
  const mesh = meshOf(corners, [
    [0, 1, 2],
    [0, 2, 3],
  ]);
  const step = 0.03;
  const points = samples(mesh, step);

  it('gets a point a square of the step', () => {
    // The lattice's own error runs with the perimeter in steps.
    expect(Math.abs(points.length - 10 / step ** 2)).toBeLessThan(13 / step / 10);
  });

  it('has neighbours a step apart, none nearer, and none outside', () => {
    for (const p of points.slice(0, 300)) {
      const distances = points
        .map((q) => Math.hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]))
        .filter((v) => v > 0);
      expect(Math.min(...distances)).toBeCloseTo(step, 9);
    }
    const edge = (p: number[], from: Point, to: Point) =>
      from.reduce((sum, value, k) => sum + (p[k] - value) * (to[k] - value), 0);
    for (const p of points) {
      expect(edge(p, a, b)).toBeGreaterThan(-1e-9);
      expect(edge(p, a, b)).toBeLessThan(16 + 1e-9);
      expect(edge(p, a, d)).toBeGreaterThan(-1e-9);
      expect(edge(p, a, d)).toBeLessThan(6.25 + 1e-9);
    }
  });

  it('does not depend on the order of triangles and corners, nor on the diagonal', () => {
    const expected = asSet(points);
    expect(
      asSet(
        samples(
          meshOf(corners, [
            [2, 3, 0],
            [1, 2, 0],
          ]),
          step,
        ),
      ),
    ).toEqual(expected);
    expect(
      asSet(
        samples(
          meshOf(
            corners,
            [
              [3, 0, 2],
              [2, 0, 1],
            ].map((face) => face.reverse()),
          ),
          step,
        ),
      ),
    ).toEqual(expected);
    expect(
      asSet(
        samples(
          meshOf(
            [b, c, d, a],
            [
              [0, 1, 2],
              [0, 2, 3],
            ],
          ),
          step,
        ),
      ),
    ).toEqual(expected);
  });

  it('has no two points above each other', () => {
    const level = points.map(([x, y]) => `${x.toFixed(6)} ${y.toFixed(6)}`);
    expect(new Set(level).size).toBe(points.length);
  });
});

describe('sampling', () => {
  it('sees every triangle, however small, unless it is to be rough', () => {
    const vertices = Array.from(
      { length: 90 },
      (_, i): Point => [i - (i % 3), (i % 3) * 1e-4, i % 3 === 2 ? 1e-4 : 0],
    );
    const faces = Array.from({ length: 30 }, (_, i) => [3 * i, 3 * i + 1, 3 * i + 2]);
    const mesh = meshOf(
      vertices.map(([x, y, z], i) => [x + (i % 3 === 1 ? 1e-4 : 0), y, z]),
      faces,
    );
    expect(samples(mesh, 0.01)).toHaveLength(30);
    expect(samples(mesh, 0.01, false).length).toBeLessThan(30);
  });

  it('is unbiased: the same area in small triangles gets about as many points', () => {
    const n = 200;
    const vertices: Point[] = [];
    for (let i = 0; i <= n; i++)
      for (let j = 0; j <= n; j++) vertices.push([i / n, 0.3 * Math.sin(i / 30), j / n]);
    const faces: number[][] = [];
    for (let i = 0; i < n; i++) {
      for (let j = 0; j < n; j++)
        faces.push([(n + 1) * i + j, (n + 1) * (i + 1) + j, (n + 1) * (i + 1) + j + 1, (n + 1) * i + j + 1]);
    }
    const mesh = meshOf(vertices, faces);
    const { area } = measureMesh(mesh);
    const step = 0.02;
    expect(samples(mesh, step, false).length / (area / step ** 2)).toBeCloseTo(1, 1);
  });

  it('lets colours run between the corners', () => {
    const mesh = meshOf(
      RECTANGLE,
      [[0, 1, 2, 3]],
      [
        [0, 0, 0],
        [200, 0, 0],
        [200, 100, 0],
        [0, 100, 0],
      ],
    );
    for (const { count, xyz, colour } of sampleMesh(mesh, { step: 0.1, isEveryTriangleSeen: true })) {
      for (let i = 0; i < count; i++) {
        expect(Math.abs(colour![3 * i] - 50 * (xyz[3 * i] - 1))).toBeLessThanOrEqual(0.5001);
        expect(Math.abs(colour![3 * i + 1] - 40 * (xyz[3 * i + 2] - 0.5))).toBeLessThanOrEqual(0.5001);
      }
    }
  });

  it('passes over triangles without area and corners without place', () => {
    const mesh = meshOf(
      [...RECTANGLE, [Number.NaN, 2, 0.5], [3, 2, 1.75]],
      [
        [0, 1, 2],
        [0, 0, 1],
        [0, 2, 5],
        [0, 1, 4],
      ],
    );
    expect(measureMesh(mesh)).toMatchObject({ area: 5, misplaced: 1 });
    expect(asSet(samples(mesh, 0.2))).toEqual(asSet(samples(meshOf(RECTANGLE, [[0, 1, 2]]), 0.2)));
  });

  it('closes no door: concave polygons are cut, not fanned', () => {
    const wall: Point[] = [
      [0, 0, 0],
      [1, 0, 0],
      [1, 0, 2],
      [2, 0, 2],
      [2, 0, 0],
      [5, 0, 0],
      [5, 0, 2.5],
      [0, 0, 2.5],
    ];
    const mesh = meshOf(wall, [[0, 1, 2, 3, 4, 5, 6, 7]]);
    expect(measureMesh(mesh).area).toBeCloseTo(5 * 2.5 - 2, 12);
    expect(samples(mesh, 0.05).filter(([x, , z]) => x > 1 && x < 2 && z < 2)).toEqual([]);
  });

  it('costs no more than it may', () => {
    const size = measureMesh(
      meshOf(
        [
          [0, 0, 0],
          [1e6, 0, 0],
          [1e6, 1e-6, 0],
        ],
        [[0, 1, 2]],
      ),
    );
    const step = finestStep(size, 1000);
    expect(size.area / step ** 2 + size.halfPerimeter / step).toBeCloseTo(1000, 6);
  });

  it('ends on corners that no step can count', () => {
    const far = meshOf(
      [
        [0, 0, 0],
        [1e-9, 0, 0],
        [0, 1e-9, 0],
        [1e12, 1e12, 0],
        [1e12, 1e12, 1e-3],
        [1e12, 1e12 - 1, 0],
      ],
      [
        [0, 1, 2],
        [3, 4, 5],
      ],
    );
    expect(samples(far, 1e-5).length).toBeGreaterThan(0);
  });
});

it('ends on areas too small for a number', () => {
  const builder = new MeshBuilder('a');
  for (const [x, y] of [
    [0, 0],
    [1e-162, 0],
    [0, 1e-162],
  ])
    builder.addVertex(x, y, 0);
  builder.addTriangle(0, 1, 2);
  builder.addPoints(0, 1);
  expect(samples(builder.build(), 0).length).toBeGreaterThan(0);
});

describe('a mesh as a cloud', () => {
  const cloudOf = (mesh: Mesh) => meshCloud({ source: memorySource('', 'a.obj'), load: async () => mesh });
  const count = async (mesh: Mesh, spacing: number) => {
    let points = 0;
    for await (const chunk of cloudOf(mesh).chunks(() => {}, spacing)) points += chunk.count;
    return points;
  };

  it('gives a rough whole, then two points a spacing along each axis', async () => {
    const mesh = meshOf(RECTANGLE, [[0, 1, 2, 3]]);
    expect((await count(mesh, 0)) / 200_000).toBeCloseTo(1, 1);
    expect((await count(mesh, 0.1)) / 4000).toBeCloseTo(1, 1);
  });

  it('coarsens what is absurdly large, and says so', async () => {
    const mesh = meshOf(
      [
        [0, 0, 0],
        [1e6, 0, 0],
        [1e6, 1e6, 0],
      ],
      [[0, 1, 2]],
    );
    const cloud = cloudOf(mesh);
    for await (const { count: points } of cloud.chunks(() => {}, 0.01)) if (points > 0) break;
    expect(cloud.warnings).toMatchObject([{ code: 'read/mesh-coarsened' }]);
  });

  it('gives no more than a budget of points can use, nor more of what is no building', async () => {
    const mesh = meshOf(RECTANGLE, [[0, 1, 2, 3]]);
    let points = 0;
    for await (const chunk of cloudOf(mesh).chunks(() => {}, 1e-4, 1_000)) points += chunk.count;
    expect(points).toBeLessThan(70_000);
    const huge = meshOf(
      RECTANGLE.map(([x, y, z]): Point => [1e6 * x, 1e6 * y, 1e6 * z]),
      [[0, 1, 2, 3]],
    );
    expect(await count(huge, 0.01)).toBeLessThan(2.5e7);
  });

  it('refuses meshes without area or content', async () => {
    await expect(count(meshOf(RECTANGLE, []), 0.1)).rejects.toMatchObject({ code: 'input/empty' });
    await expect(count(meshOf(RECTANGLE, [[0, 1, 1]]), 0.1)).rejects.toMatchObject({
      code: 'input/degenerate',
    });
  });
});
