/**
 * The one judge of rings and polygons in tests. Written apart from `src`: only the predicate library is shared.
 */
import { orient2d } from 'robust-predicates';
import { expect } from 'vitest';
import type { Polygon, Ring } from '../src/core/types.ts';

/** What is wrong with a ring: fewer than three vertices, not finite, repeated vertex, edges that meet or fold. */
export function ringProblems(ring: Ring, name = 'ring'): string[] {
  const n = ring.length / 2;
  if (!Number.isInteger(n) || n < 3) return [`${name}: expected 3 or more vertices, found ${n}`];
  if (!ring.every(Number.isFinite)) return [`${name}: a coordinate is not finite`];
  return edgeConflicts([ring]).map((conflict) => `${name}: ${conflict}`);
}

/**
 * What is wrong with a polygon: a bad ring, an outer ring that is not counter-clockwise, a hole that is not
 * clockwise or lies outside, rings that cross. Rings may share a vertex.
 */
export function polygonProblems(polygon: Polygon, name = 'polygon'): string[] {
  const problems = ringProblems(polygon.outer, `${name} outer`);
  if (turnOf(polygon.outer) <= 0) problems.push(`${name} outer: expected counter-clockwise`);
  polygon.holes.forEach((hole, h) => {
    problems.push(...ringProblems(hole, `${name} hole ${h}`));
    if (turnOf(hole) >= 0) problems.push(`${name} hole ${h}: expected clockwise`);
    if (!liesInside(hole, polygon.outer)) problems.push(`${name} hole ${h}: lies outside the outer ring`);
  });
  if (problems.length === 0) {
    const conflicts = edgeConflicts([polygon.outer, ...polygon.holes]);
    problems.push(...conflicts.map((conflict) => `${name}: ${conflict}`));
  }
  return problems;
}

/** Fails the test unless the ring is simple, closed and encloses an area. */
export function expectValidRing(ring: Ring, name?: string): void {
  expect(ringProblems(ring, name)).toEqual([]);
}

/** Fails the test unless the polygon is valid, see {@link polygonProblems}. */
export function expectValidPolygon(polygon: Polygon, name?: string): void {
  expect(polygonProblems(polygon, name)).toEqual([]);
}

/** Fails the test unless there is a polygon and each one is valid. */
export function expectValidPolygons(polygons: readonly Polygon[]): void {
  expect(polygons.length).toBeGreaterThan(0);
  expect(polygons.flatMap((polygon, p) => polygonProblems(polygon, `polygon ${p}`))).toEqual([]);
}

/** 1 for a counter-clockwise simple ring, -1 for a clockwise one, exactly: its turn at the leftmost, lowest vertex. */
export function turnOf(ring: Ring): number {
  const vertices = Array.from({ length: ring.length / 2 }, (_, k): Point => [ring[2 * k], ring[2 * k + 1]]);
  const isBefore = (a: Point, b: Point) => a[0] < b[0] || (a[0] === b[0] && a[1] < b[1]);
  const least = vertices.reduce((best, vertex, k) => (isBefore(vertex, vertices[best]) ? k : best), 0);
  const at = (k: number) => vertices[(k + vertices.length) % vertices.length];
  return -side(at(least - 1), at(least), at(least + 1));
}

/** Twice the signed area, relative to the first vertex. */
export function twiceArea(ring: Ring): number {
  let sum = 0;
  for (let i = 2; i + 3 < ring.length; i += 2) {
    sum += (ring[i] - ring[0]) * (ring[i + 3] - ring[1]) - (ring[i + 2] - ring[0]) * (ring[i + 1] - ring[1]);
  }
  return sum;
}

interface Edge {
  readonly ring: number;
  readonly number: number;
  readonly size: number;
  readonly a: readonly [number, number];
  readonly b: readonly [number, number];
}

/** Pairs of edges that share more than a lawful vertex, found by sweeping edges in order of their least x. */
function edgeConflicts(rings: readonly Ring[]): string[] {
  const edges: Edge[] = rings.flatMap((ring, r) => {
    const size = ring.length / 2;
    return Array.from({ length: size }, (_, k) => {
      const m = (k + 1) % size;
      return {
        ring: r,
        number: k,
        size,
        a: [ring[2 * k], ring[2 * k + 1]],
        b: [ring[2 * m], ring[2 * m + 1]],
      };
    });
  });
  edges.sort((e, f) => Math.min(e.a[0], e.b[0]) - Math.min(f.a[0], f.b[0]));
  const conflicts: string[] = [];
  edges.forEach((e, k) => {
    const right = Math.max(e.a[0], e.b[0]);
    for (let m = k + 1; m < edges.length; m++) {
      const f = edges[m];
      if (Math.min(f.a[0], f.b[0]) > right) break;
      if (meetUnlawfully(e, f)) conflicts.push(`edges ${wording(e)} and ${wording(f)} meet`);
    }
  });
  return conflicts;
}

function meetUnlawfully(e: Edge, f: Edge): boolean {
  if (!touch(e, f)) return false;
  const isNext = e.ring === f.ring && f.number === (e.number + 1) % e.size;
  const isBefore = e.ring === f.ring && e.number === (f.number + 1) % e.size;
  if (isNext) return folds(e.a, e.b, f.b) || same(e.a, e.b);
  if (isBefore) return folds(f.a, f.b, e.b) || same(e.a, e.b);
  if (e.ring === f.ring) return true;
  // Different rings may share a vertex, and nothing else.
  const ends = [
    [e.a, e.b, f.a, f.b],
    [e.a, e.b, f.b, f.a],
    [e.b, e.a, f.a, f.b],
    [e.b, e.a, f.b, f.a],
  ] as const;
  const shared = ends.find(([p, , q]) => same(p, q));
  return shared === undefined || folds(shared[1], shared[0], shared[3]);
}

type Point = readonly [number, number];
const side = (a: Point, b: Point, c: Point) => Math.sign(orient2d(a[0], a[1], b[0], b[1], c[0], c[1]));
const same = (a: Point, b: Point) => a[0] === b[0] && a[1] === b[1];

function folds(a: Point, b: Point, c: Point): boolean {
  return side(a, b, c) === 0 && (a[0] - b[0]) * (c[0] - b[0]) + (a[1] - b[1]) * (c[1] - b[1]) > 0;
}

function touch({ a, b }: Edge, { a: c, b: d }: Edge): boolean {
  for (const axis of [0, 1] as const) {
    if (Math.max(a[axis], b[axis]) < Math.min(c[axis], d[axis])) return false;
    if (Math.max(c[axis], d[axis]) < Math.min(a[axis], b[axis])) return false;
  }
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0;
}

/** Whether most vertices of `inner` lie in `outer`, even-odd; a vertex on the outer ring may go either way. */
function liesInside(inner: Ring, outer: Ring): boolean {
  let inside = 0;
  for (let k = 0; k < inner.length; k += 2) {
    const m = (k + 2) % inner.length;
    if (contains(outer, (inner[k] + inner[m]) / 2, (inner[k + 1] + inner[m + 1]) / 2)) inside++;
  }
  return inside > inner.length / 4;
}

function contains(ring: Ring, x: number, y: number): boolean {
  let isInside = false;
  for (let i = 0, j = ring.length - 2; i < ring.length; j = i, i += 2) {
    const [ax, ay, bx, by] = [ring[j], ring[j + 1], ring[i], ring[i + 1]];
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isInside = !isInside;
  }
  return isInside;
}

function wording({ ring, number, a, b }: Edge): string {
  return `${ring}:${number} (${a.join(' ')} to ${b.join(' ')})`;
}
