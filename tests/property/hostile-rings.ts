/** Rings that simplification finds hard, for property tests: from a seed, near the origin or far from it. */
import fc from 'fast-check';
import type { Ring } from '../../src/core/types.ts';
import { ringProblems } from '../invariants.ts';
import { randomNumbers } from '../unit/core/boundary/wall-slices.ts';

/** A wobbling radius: thin necks and spikes. */
const star = fc
  .tuple(fc.integer({ min: 3, max: 200 }), fc.integer(), fc.double({ min: 0, max: 1, noNaN: true }))
  .map(([n, seed, wobble]): Ring => {
    const random = randomNumbers(seed);
    const vertices = new Float64Array(2 * n);
    for (let k = 0; k < n; k++) {
      const radius = 1 + 0.98 * wobble * (random() - 1);
      vertices[2 * k] = 4 * radius * Math.cos((2 * Math.PI * k) / n);
      vertices[2 * k + 1] = 3 * radius * Math.sin((2 * Math.PI * k) / n);
    }
    return vertices;
  });

/** Teeth thinner than most tolerances. */
const comb = fc
  .tuple(fc.integer({ min: 1, max: 25 }), fc.constantFrom(0.001, 0.02, 0.1))
  .map(([teeth, width]): Ring => {
    const vertices = [0, 0, teeth, 0];
    for (let k = teeth; k > 0; k--)
      vertices.push(k, 2, k - width, 2, k - width, width, k - 1 + width, width, k - 1 + width, 2);
    return Float64Array.from(vertices);
  });

/** A corridor wound about itself: the two faces of its wall lie as far apart as `width` says. */
const spiral = fc
  .tuple(fc.integer({ min: 10, max: 150 }), fc.constantFrom(0.01, 0.1, 0.25), fc.integer())
  .map(([n, width, seed]): Ring => {
    const random = randomNumbers(seed);
    const outside: number[] = [];
    const inside: number[] = [];
    for (let k = 0; k < n; k++) {
      const angle = 0.25 * k;
      const radius = 1 + 0.08 * angle;
      const place = (r: number) => [r * Math.cos(angle), r * Math.sin(angle)];
      outside.push(...place(radius + width * (0.5 + 0.2 * random())));
      inside.unshift(...place(radius - 0.2 * width * random()));
    }
    return Float64Array.from([...outside, ...inside]);
  });

/** Both faces of a thin wall, each with its own noise. */
const thinWall = fc
  .tuple(fc.integer({ min: 3, max: 80 }), fc.constantFrom(1e-4, 0.02, 0.1), fc.integer())
  .map(([n, thickness, seed]): Ring => {
    const random = randomNumbers(seed);
    const there: number[] = [];
    const back: number[] = [];
    for (let k = 0; k < n; k++) {
      const bend = 2 * Math.sin((5 * k) / n);
      there.push(k * 0.1, bend + 0.3 * thickness * random());
      back.unshift(bend + thickness * (1 + 0.3 * random()));
      back.unshift(k * 0.1);
    }
    return Float64Array.from([...there, ...back]);
  });

/** All vertices within a hair of a line. */
const sliver = fc
  .tuple(fc.integer({ min: 1, max: 30 }), fc.constantFrom(1e-9, 1e-6, 1e-3), fc.integer())
  .map(([n, height, seed]): Ring => {
    const random = randomNumbers(seed);
    const vertices = [0, 0];
    for (let k = 1; k < n; k++) vertices.push(k, -height * random());
    vertices.push(n, 0);
    for (let k = n - 1; k > 0; k--) vertices.push(k, height * random());
    return Float64Array.from(vertices.length === 4 ? [0, 0, n, 0, n / 2, height] : vertices);
  });

/** A rectangle on a lattice: all distances and areas tie. */
const lattice = fc
  .tuple(fc.integer({ min: 1, max: 20 }), fc.integer({ min: 1, max: 20 }))
  .map(([w, h]): Ring => {
    const vertices: number[] = [];
    for (let k = 0; k < w; k++) vertices.push(k, 0);
    for (let k = 0; k < h; k++) vertices.push(w, k);
    for (let k = w; k > 0; k--) vertices.push(k, h);
    for (let k = h; k > 0; k--) vertices.push(0, k);
    return Float64Array.from(vertices);
  });

const origins = fc.constantFrom([0, 0], [0, 0], [1e6, -1e6], [691_000.25, 5_336_000.5]);

/** Any of them, simple, turned and put somewhere. */
export const hostileRing = fc
  .tuple(
    fc.oneof(star, comb, spiral, thinWall, sliver, lattice),
    origins,
    fc.constantFrom(0, 0, 0.3, Math.PI / 2),
  )
  .map(([ring, [x, y], angle]): Ring => {
    const [cos, sin] = angle === 0 ? [1, 0] : [Math.cos(angle), Math.sin(angle)];
    return ring.map((_, i) => {
      const [a, b] = [ring[i - (i % 2)], ring[i - (i % 2) + 1]];
      return i % 2 === 0 ? x + a * cos - b * sin : y + a * sin + b * cos;
    });
  })
  .filter((ring) => ringProblems(ring).length === 0);
