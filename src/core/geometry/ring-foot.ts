import type { Ring } from '../types.ts';

/** Of a corner of 10°, by the distance that walls stand from the ring: sharper ones are looked for no further. */
const LONGEST_MITRE = 1 / Math.tan((5 * Math.PI) / 180);
/** Cosine of 30°: a sharper turn is a corner. */
const STRAIGHT_ON = Math.cos(Math.PI / 6);

type Direction = readonly [x: number, y: number];

/** The place on a ring nearest to a point. */
export interface Foot {
  /** On the ring. */
  readonly x: number;
  readonly y: number;
  /** The edge it lies on: offset of its first vertex's x in the ring. */
  readonly edge: number;
  /** From the point, m. */
  readonly distance: number;
}

/**
 * The place on a ring that is nearest to a point once every edge is moved to its right; linear.
 *
 * @param aside how far edges are moved, m: with outer rings counter-clockwise and holes clockwise, outwards
 */
export function nearestFoot(ring: Ring, x: number, y: number, aside: number): Foot {
  let nearest: Foot = { x: ring[0], y: ring[1], edge: 0, distance: Infinity };
  for (let edge = 0; edge < ring.length; edge += 2) {
    const next = (edge + 2) % ring.length;
    const [dx, dy] = [ring[next] - ring[edge], ring[next + 1] - ring[edge + 1]];
    const length = Math.hypot(dx, dy);
    if (length === 0) continue;
    const [nx, ny] = [(aside * dy) / length, (-aside * dx) / length];
    const along = (x - ring[edge] - nx) * dx + (y - ring[edge + 1] - ny) * dy;
    const share = Math.min(1, Math.max(0, along / (length * length)));
    const [footX, footY] = [ring[edge] + share * dx, ring[edge + 1] + share * dy];
    const distance = Math.hypot(x - footX - nx, y - footY - ny);
    if (distance < nearest.distance) nearest = { x: footX, y: footY, edge, distance };
  }
  return nearest;
}

/**
 * The ring's direction at a foot: its edge's, or where that is but a kink, the chord's of the stretch around it.
 *
 * @param along half the stretch's length along the ring, m
 * @param kink edges shorter than this say nothing of a wall's direction, m
 */
export function directionAt(
  ring: Ring,
  foot: Foot,
  { along, kink }: { readonly along: number; readonly kink: number },
): Direction {
  const next = (foot.edge + 2) % ring.length;
  const edge = unit(ring[next] - ring[foot.edge], ring[next + 1] - ring[foot.edge + 1]);
  if (Math.hypot(ring[next] - ring[foot.edge], ring[next + 1] - ring[foot.edge + 1]) >= kink) return edge;
  const [before, after] = [pointAlong(ring, foot, -1, along), pointAlong(ring, foot, 1, along)];
  const [dx, dy] = [after[0] - before[0], after[1] - before[1]];
  return dx === 0 && dy === 0 ? edge : unit(dx, dy);
}

/**
 * How far the ring runs straight on from a foot, along a direction: to where it leaves the line by more than a bulge,
 * or turns by more than 30° into an edge longer than that. What stands along the edge behind such a corner takes its
 * part of the stretch: from the mitre to the corner.
 *
 * @param stands how far walls stand to the left and right of the ring, m
 * @param way 1 along the ring, −1 against it
 * @param limit no more is asked, m
 * @returns metres along the direction, at most `limit`; negative where the foot itself lies in the wall behind a corner
 */
export function straightReach(
  ring: Ring,
  foot: Foot,
  ask: {
    readonly direction: Direction;
    readonly way: 1 | -1;
    readonly limit: number;
    readonly bulge: number;
    readonly stands: { readonly left: number; readonly right: number };
  },
): number {
  const [ux, uy] = [ask.way * ask.direction[0], ask.way * ask.direction[1]];
  let [reached, fromAside] = [0, 0];
  let vertex = ask.way === 1 ? (foot.edge + 2) % ring.length : foot.edge;
  const far = ask.limit + LONGEST_MITRE * Math.max(ask.stands.left, ask.stands.right);
  for (let steps = 0; steps < ring.length && reached < far; steps += 2) {
    const [dx, dy] = [ring[vertex] - foot.x, ring[vertex + 1] - foot.y];
    const [ahead, aside] = [dx * ux + dy * uy, ux * dy - uy * dx];
    const [run, drift] = [ahead - reached, aside - fromAside];
    const length = Math.hypot(run, drift);
    if (length > ask.bulge && run < STRAIGHT_ON * length) {
      const isLeft = drift > 0 === (ask.way === 1);
      const mitre = Math.tan(Math.acos(Math.max(-1, run / length)) / 2);
      return Math.min(ask.limit, reached - mitre * (isLeft ? ask.stands.left : ask.stands.right));
    }
    if (Math.abs(aside) > ask.bulge) {
      const share = (Math.sign(aside) * ask.bulge - fromAside) / drift;
      return Math.min(ask.limit, reached + share * run);
    }
    [reached, fromAside] = [ahead, aside];
    vertex = (vertex + 2 * ask.way + ring.length) % ring.length;
  }
  return Math.min(ask.limit, reached);
}

/** The place so far along the ring from a foot; at most once around. */
function pointAlong(ring: Ring, foot: Foot, way: 1 | -1, along: number): Direction {
  let [x, y, left] = [foot.x, foot.y, along];
  let vertex = way === 1 ? (foot.edge + 2) % ring.length : foot.edge;
  for (let steps = 0; steps < ring.length; steps += 2) {
    const [dx, dy] = [ring[vertex] - x, ring[vertex + 1] - y];
    const length = Math.hypot(dx, dy);
    if (length >= left) return [x + (dx * left) / length, y + (dy * left) / length];
    [x, y, left] = [ring[vertex], ring[vertex + 1], left - length];
    vertex = (vertex + 2 * way + ring.length) % ring.length;
  }
  return [x, y];
}

function unit(dx: number, dy: number): Direction {
  const length = Math.hypot(dx, dy);
  return [dx / length, dy / length];
}
