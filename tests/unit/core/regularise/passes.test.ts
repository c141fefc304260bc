import simplify from 'simplify-js';
import { describe, expect, it } from 'vitest';
import { cutRing, cutVertices, joinLines } from '../../../../src/core/regularise/cut-ring.ts';
import { douglasPeucker } from '../../../../src/core/regularise/douglas-peucker.ts';
import { radialDistance } from '../../../../src/core/regularise/radial-distance.ts';
import { visvalingam } from '../../../../src/core/regularise/visvalingam.ts';
import type { Ring } from '../../../../src/core/types.ts';
import { randomNumbers } from '../boundary/wall-slices.ts';

function wobblyLine(n: number, seed: number): Float64Array {
  const random = randomNumbers(seed);
  return Float64Array.from({ length: 2 * n }, (_, i) => (i % 2 === 0 ? (i / 2) * 0.1 : 0) + random() * 0.3);
}
const toPoints = (line: Float64Array) =>
  Array.from({ length: line.length / 2 }, (_, k) => ({ x: line[2 * k], y: line[2 * k + 1] }));

describe('radial distance and Douglas-Peucker', () => {
  it.each([1, 2, 3, 4, 5])('in a row are what simplify-js does in one call, seed %i', (seed) => {
    const line = wobblyLine(400, seed);
    for (const epsilon of [0.01, 0.1, 0.3, 1]) {
      const ours = douglasPeucker(radialDistance(line, epsilon), epsilon);
      expect(toPoints(ours)).toEqual(simplify(toPoints(line), epsilon, false));
    }
  });

  it('split a long line as the package would, and survive the line that makes it recurse deepest', () => {
    const long = wobblyLine(9_000, 7);
    expect(toPoints(douglasPeucker(long, 0.15))).toEqual(simplify(toPoints(long), 0.15, true));
    const n = 12_000;
    // A zigzag that shrinks: each split takes one vertex.
    const worst = Float64Array.from({ length: 2 * n }, (_, i) => {
      const k = i >> 1;
      return i % 2 === 0 ? k : (k % 2 === 0 ? 1 : -1) * (n - k);
    });
    expect(douglasPeucker(worst, 0.5).length).toBe(2 * n);
  });

  it('keep both ends', () => {
    const line = Float64Array.of(0, 0, 0.1, 0, 0.2, 0);
    expect([...radialDistance(line, 5)]).toEqual([0, 0, 0.2, 0]);
    expect([...douglasPeucker(line, 5)]).toEqual([0, 0, 0.2, 0]);
  });
});

describe('cutting a ring', () => {
  it('cuts at two far vertices and joins again', () => {
    const ring = Float64Array.of(1, 0, 9, 0, 10, 1, 10, 4, 0, 4, 0, 1);
    const [first, second] = cutVertices(ring);
    expect([ring[2 * first], ring[2 * first + 1]]).toEqual([0, 1]);
    expect([ring[2 * second], ring[2 * second + 1]]).toEqual([10, 4]);
    const joined = joinLines(cutRing(ring, [first, second]));
    expect(joined.length).toBe(ring.length);
    expect([...joined.slice(0, 4)]).toEqual([0, 1, 1, 0]);
  });
});

/** Effective areas by scanning all vertices for every removal. */
function bruteVisvalingam(ring: Ring, areaEpsilon: number): Ring {
  let vertices = toPoints(ring);
  let floor = 0;
  while (vertices.length > 3) {
    const areas = vertices.map((b, k) => {
      const a = vertices[(k + vertices.length - 1) % vertices.length];
      const c = vertices[(k + 1) % vertices.length];
      return Math.max(floor, Math.abs((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x)) / 2);
    });
    let least = 0;
    areas.forEach((area, k) => {
      const [v, w] = [vertices[k], vertices[least]];
      if (area < areas[least] || (area === areas[least] && (v.x < w.x || (v.x === w.x && v.y < w.y))))
        least = k;
    });
    if (areas[least] >= areaEpsilon) break;
    floor = areas[least];
    vertices = vertices.filter((_, k) => k !== least);
  }
  return Float64Array.from(vertices.flatMap(({ x, y }) => [x, y]));
}

describe('visvalingam', () => {
  it.each([1, 2, 3, 4, 5, 6, 7, 8])('removes what the brute oracle removes, seed %i', (seed) => {
    const random = randomNumbers(seed);
    const n = 80;
    const ring = new Float64Array(2 * n);
    for (let k = 0; k < n; k++) {
      const radius = 5 + random();
      ring[2 * k] = radius * Math.cos((2 * Math.PI * k) / n);
      ring[2 * k + 1] = radius * Math.sin((2 * Math.PI * k) / n);
    }
    for (const areaEpsilon of [0, 0.001, 0.05, 0.3, 2, 1_000]) {
      expect(visvalingam(ring, areaEpsilon)).toEqual(bruteVisvalingam(ring, areaEpsilon));
    }
  });

  it('does the same on a lattice ring, where areas tie', () => {
    const ring = Float64Array.of(
      0,
      0,
      1,
      0,
      2,
      0,
      2,
      1,
      3,
      1,
      3,
      0,
      4,
      0,
      4,
      4,
      3,
      4,
      3,
      3,
      2,
      3,
      2,
      4,
      0,
      4,
    );
    for (const areaEpsilon of [0.1, 0.6, 1.1, 3]) {
      expect(visvalingam(ring, areaEpsilon)).toEqual(bruteVisvalingam(ring, areaEpsilon));
    }
  });

  it('keeps three vertices', () => {
    expect(visvalingam(Float64Array.of(0, 0, 1, 0, 1, 1, 0, 1), 1e9).length).toBe(6);
  });
});
