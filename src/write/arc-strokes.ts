import { edgesBetween } from '../core/geometry/ring-arcs.ts';
import type { Ring, RingArc } from '../core/types.ts';

/** A stroke of a pen around a ring: straight, or along an arc of at most half a circle. */
export interface ArcStroke {
  /** Where it begins; it ends where the next one does. */
  readonly x: number;
  readonly y: number;
  /** Angle it turns by around the arc's centre, radians, from x towards y; 0 where it is straight. */
  readonly turn: number;
  readonly radius: number;
}

/** A ring drawn with its arcs as such: the vertices within an arc are left out, but for the middle one of a long arc. */
export function arcStrokes(ring: Ring, arcs: readonly RingArc[]): ArcStroke[] {
  const n = ring.length / 2;
  const within = new Map<number, ArcStroke | null>();
  for (const arc of arcs) {
    const count = edgesBetween(arc.from, arc.to, n);
    for (let k = 1; k < count; k++) within.set((arc.from + k) % n, null);
    for (const [begin, length] of halves(ring, arc, count)) {
      const from = (arc.from + begin) % n;
      within.set(from, strokeAlong(ring, arc, from, length));
    }
  }
  return Array.from({ length: n }, (_, i) => {
    const own = within.get(i);
    return own === undefined ? { x: ring[2 * i], y: ring[2 * i + 1], turn: 0, radius: 0 } : own;
  }).filter((stroke) => stroke !== null);
}

/** The centre of an arc between two places that turns by an angle, from x towards y. */
export function arcCentre(from: Place, to: Place, turn: number): [x: number, y: number] {
  const height = 1 / (2 * Math.tan(turn / 2));
  return [(from.x + to.x) / 2 - (to.y - from.y) * height, (from.y + to.y) / 2 + (to.x - from.x) * height];
}

type Place = Pick<ArcStroke, 'x' | 'y'>;

/** Angle from an arc's first vertex to its last, radians, from x towards y. */
export function arcTurn(ring: Ring, { centre, from, to }: RingArc): number {
  return turnAlong(ring, centre, from, edgesBetween(from, to, ring.length / 2));
}

/** Angle from an arc's centre to its first vertex, radians. */
export function arcStart(ring: Ring, { centre, from }: RingArc): number {
  return Math.atan2(ring[2 * from + 1] - centre[1], ring[2 * from] - centre[0]);
}

function halves(
  ring: Ring,
  arc: RingArc,
  count: number,
): readonly (readonly [begin: number, count: number])[] {
  if (Math.abs(arcTurn(ring, arc)) <= Math.PI) return [[0, count]];
  const half = count >> 1;
  return [
    [0, half],
    [half, count - half],
  ];
}

function strokeAlong(ring: Ring, { centre, radius }: RingArc, from: number, count: number): ArcStroke {
  return { x: ring[2 * from], y: ring[2 * from + 1], turn: turnAlong(ring, centre, from, count), radius };
}

function turnAlong(ring: Ring, [cx, cy]: RingArc['centre'], from: number, count: number): number {
  const n = ring.length / 2;
  let turn = 0;
  for (let k = 0; k < count; k++) {
    const [i, j] = [(from + k) % n, (from + k + 1) % n];
    const [ax, ay] = [ring[2 * i] - cx, ring[2 * i + 1] - cy];
    const [bx, by] = [ring[2 * j] - cx, ring[2 * j + 1] - cy];
    turn += Math.atan2(ax * by - ay * bx, ax * bx + ay * by);
  }
  return turn;
}
