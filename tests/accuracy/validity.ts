import { orient2d } from 'robust-predicates';
import { contains, type XY } from '../../fixtures/simulator/ring.ts';
import type { Polygon } from './regions.ts';

interface Edge {
  readonly a: XY;
  readonly b: XY;
  readonly ring: number;
  /** Number in its ring, and size of the ring. */
  readonly number: number;
  readonly size: number;
}

/**
 * Whether a polygon is valid by OGC Simple Features §6.1.11: simple rings, holes inside and apart, interior connected.
 *
 * Rings may touch each other in single points. Exact predicates; edges are paired by a sweep over x.
 */
export function isValidPolygon(polygon: Polygon): boolean {
  const rings = polygon.map(withoutRepeats);
  if (rings.length === 0 || rings.some((ring) => ring.length < 3 || !ring.flat().every(Number.isFinite)))
    return false;
  const touches = findTouches(rings);
  return touches !== null && !closesLoop(touches) && holesLieInside(rings);
}

function withoutRepeats(ring: readonly XY[]): XY[] {
  return ring.filter(([x, y], i) => {
    const [nextX, nextY] = ring[(i + 1) % ring.length];
    return x !== nextX || y !== nextY;
  });
}

interface Touch {
  readonly rings: readonly [number, number];
  readonly at: string;
}

/** Points where different rings touch, or null when edges cross, overlap, or touch within a ring. */
function findTouches(rings: readonly XY[][]): Touch[] | null {
  const edges = rings.flatMap((ring, index) =>
    ring.map(
      (a, number): Edge => ({
        a,
        b: ring[(number + 1) % ring.length],
        ring: index,
        number,
        size: ring.length,
      }),
    ),
  );
  const minX = ({ a, b }: Edge): number => Math.min(a[0], b[0]);
  const maxX = ({ a, b }: Edge): number => Math.max(a[0], b[0]);
  edges.sort((p, q) => minX(p) - minX(q));
  const touches: Touch[] = [];
  for (let i = 0; i < edges.length; i++) {
    for (let k = i + 1; k < edges.length && minX(edges[k]) <= maxX(edges[i]); k++) {
      const meeting = meet(edges[i], edges[k]);
      if (meeting === 'clash') return null;
      if (meeting !== 'apart') touches.push({ rings: [edges[i].ring, edges[k].ring], at: meeting.join() });
    }
  }
  return touches;
}

function meet(p: Edge, q: Edge): 'apart' | 'clash' | XY {
  if (p.ring === q.ring && areNeighbours(p, q)) return doublesBack(p, q) ? 'clash' : 'apart';
  const [p1, p2] = [side(p, q.a), side(p, q.b)];
  const [q1, q2] = [side(q, p.a), side(q, p.b)];
  if (p1 * p2 > 0 || q1 * q2 > 0) return 'apart';
  if (p1 === 0 && p2 === 0) return meetOnLine(p, q);
  if (p1 * p2 < 0 && q1 * q2 < 0) return 'clash';
  if (p.ring === q.ring) return 'clash';
  return p1 === 0 ? q.a : p2 === 0 ? q.b : q1 === 0 ? p.a : p.b;
}

const side = ({ a, b }: Edge, [x, y]: XY): number => Math.sign(orient2d(a[0], a[1], b[0], b[1], x, y));

function areNeighbours(p: Edge, q: Edge): boolean {
  const step = Math.abs(p.number - q.number);
  return step === 1 || step === p.size - 1;
}

/** Neighbouring edges may only share their vertex. In a triangle all edges are neighbours. */
function doublesBack(p: Edge, q: Edge): boolean {
  const [first, second] = (p.number + 1) % p.size === q.number ? [p, q] : [q, p];
  if (side(first, second.b) !== 0) return false;
  const [{ a, b }, c] = [first, second.b];
  return (b[0] - a[0]) * (c[0] - b[0]) + (b[1] - a[1]) * (c[1] - b[1]) < 0;
}

/** Edges on one line: apart, touching in one end point, or overlapping. */
function meetOnLine(p: Edge, q: Edge): 'apart' | 'clash' | XY {
  const axis = Math.abs(p.b[0] - p.a[0]) > Math.abs(p.b[1] - p.a[1]) ? 0 : 1;
  const [pLow, pHigh] = [p.a, p.b].sort((u, v) => u[axis] - v[axis]);
  const [qLow, qHigh] = [q.a, q.b].sort((u, v) => u[axis] - v[axis]);
  if (pHigh[axis] < qLow[axis] || qHigh[axis] < pLow[axis]) return 'apart';
  const isPoint = pHigh[axis] === qLow[axis] || qHigh[axis] === pLow[axis];
  if (!isPoint || p.ring === q.ring) return 'clash';
  return pHigh[axis] === qLow[axis] ? pHigh : qHigh;
}

/** Rings that touch around a loop cut the interior in two. */
function closesLoop(touches: readonly Touch[]): boolean {
  // Rings and touching points are the nodes of a graph: a loop in it encloses a part of the interior.
  const parent = new Map<string, string>();
  const find = (node: string): string => {
    const up = parent.get(node);
    return up === undefined ? node : find(up);
  };
  const links = new Set<string>();
  for (const { rings, at } of touches) for (const ring of rings) links.add(`r${ring}|p${at}`);
  for (const link of links) {
    const [ring, point] = link.split('|').map(find);
    if (ring === point) return true;
    parent.set(ring, point);
  }
  return false;
}

function holesLieInside([outer, ...holes]: readonly XY[][]): boolean {
  return holes.every(
    (hole, i) =>
      witness(hole, outer, (inside) => inside) &&
      holes.every((other, k) => k === i || witness(hole, other, (inside) => !inside)),
  );
}

/** Judges a ring by its first vertex that is not on the other ring; rings are known not to cross. */
function witness(ring: readonly XY[], other: readonly XY[], judge: (inside: boolean) => boolean): boolean {
  const point = ring.find(([x, y]) => !isOn(other, x, y));
  return point !== undefined && judge(contains(other, point[0], point[1]));
}

function isOn(ring: readonly XY[], x: number, y: number): boolean {
  return ring.some((a, i) => {
    const b = ring[(i + 1) % ring.length];
    const isBetween =
      x >= Math.min(a[0], b[0]) &&
      x <= Math.max(a[0], b[0]) &&
      y >= Math.min(a[1], b[1]) &&
      y <= Math.max(a[1], b[1]);
    return isBetween && orient2d(a[0], a[1], b[0], b[1], x, y) === 0;
  });
}
