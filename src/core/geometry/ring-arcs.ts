import type { Polygon, Ring, RingArc, Vec2 } from '../types.ts';
import type { Circle } from './circle.ts';
import { ringsOf } from './rings.ts';
import { isSimpleRing } from './simplicity.ts';

/** The chords that stand for a curve leave it by no more than this, m: less than a scanner's noise. */
export const SAGITTA = 0.004;
/** A vertex this near to a circle is on it, m: areas that touched stand 0.2 mm apart, and files are written to 0.1 mm. */
export const ON_ARC = 0.0003;
/** An edge is along a circle while it keeps within so many sagittas of it: two fits of a wall's end differ as much. */
const ALONG = 2;
/** … and turns from it by less than this, as a sine. */
const MOST_TURN = 0.5;
/** Along the wall it meets a curve's end moves no farther than this, m. */
const MOST_MOVE = 2 * ALONG * SAGITTA;
/** Fewer edges in a row are no curve. */
const FEWEST_EDGES = 2;

/** The widest angle that a chord may take of a circle, radians. */
export function chordTurn(radius: number): number {
  return 2 * Math.acos(Math.max(0, 1 - SAGITTA / radius));
}

/** A stretch of a ring along a circle: edges `first` to `first + count − 1`, past the last to the first. */
interface Run {
  readonly first: number;
  readonly count: number;
}

/**
 * The polygon with the runs of its vertices that lie on circles told. O(vertices · circles).
 *
 * What clips or moves an outline makes no exception: what is no more on its circle is no more told.
 *
 * @param metresPerUnit of the coordinates of both
 */
export function withArcs({ outer, holes }: Polygon, circles: readonly Circle[], metresPerUnit = 1): Polygon {
  const arcs = ringsOf([{ outer, holes }]).flatMap((ring, k) => arcsOfRing(ring, k, circles, metresPerUnit));
  return arcs.length > 0 ? { outer, holes, arcs } : { outer, holes };
}

function arcsOfRing(ring: Ring, k: number, circles: readonly Circle[], metresPerUnit: number): RingArc[] {
  const n = ring.length / 2;
  const arcs = circles.flatMap((circle) => {
    const { cx, cy, radius } = circle;
    const isOn = (i: number) =>
      Math.abs(Math.hypot(ring[2 * i] - cx, ring[2 * i + 1] - cy) - radius) * metresPerUnit <= ON_ARC;
    return runsAlong(ring, circle, (ALONG * SAGITTA) / metresPerUnit, isOn).map(
      ({ first, count }): RingArc => ({
        ring: k,
        from: first,
        to: (first + count) % n,
        centre: [cx, cy],
        radius,
      }),
    );
  });
  return arcs.sort((a, b) => a.from - b.from);
}

/** Longest runs of edges along a circle between vertices that are on it. */
function runsAlong(
  ring: Ring,
  { cx, cy, radius }: Circle,
  reach: number,
  isOn: (vertex: number) => boolean,
): Run[] {
  const n = ring.length / 2;
  const off = (x: number, y: number) => Math.abs(Math.hypot(x - cx, y - cy) - radius);
  const isAlong = Array.from({ length: n }, (_, i) => {
    const j = (i + 1) % n;
    if (!isOn(i) || !isOn(j)) return false;
    const [ax, ay, bx, by] = [ring[2 * i], ring[2 * i + 1], ring[2 * j], ring[2 * j + 1]];
    const [mx, my] = [(ax + bx) / 2, (ay + by) / 2];
    const across = Math.abs((bx - ax) * (mx - cx) + (by - ay) * (my - cy));
    return (
      off(mx, my) <= reach &&
      across <= MOST_TURN * Math.hypot(bx - ax, by - ay) * Math.hypot(mx - cx, my - cy)
    );
  });
  const begin = isAlong.indexOf(false);
  if (begin < 0) return [{ first: 0, count: n }];
  const runs: Run[] = [];
  let count = 0;
  for (let k = 1; k <= n; k++) {
    const i = (begin + k) % n;
    if (isAlong[i]) {
      count++;
      continue;
    }
    if (count >= FEWEST_EDGES) runs.push({ first: (i - count + n) % n, count });
    count = 0;
  }
  return runs;
}

/**
 * A ring whose vertices along circles are on them: chords meet walls a little off the curve they stand for.
 *
 * Where a curve meets a straight edge the vertex moves along that; the ring stays as it is where it would cross itself.
 */
export function placedOnArcs(ring: Ring, circles: readonly Circle[]): Ring {
  const placed = Float64Array.from(ring);
  const n = ring.length / 2;
  const at = (i: number): Vec2 => [ring[2 * (i % n)], ring[2 * (i % n) + 1]];
  for (const circle of circles) {
    const { cx, cy, radius } = circle;
    const isNear = (i: number) =>
      Math.abs(Math.hypot(at(i)[0] - cx, at(i)[1] - cy) - radius) <= ALONG * SAGITTA;
    for (const { first, count } of runsAlong(ring, circle, ALONG * SAGITTA, isNear)) {
      for (let k = 0; k <= count; k++) {
        const [x, y] = at(first + k);
        const isEnd = count < n && (k === 0 || k === count);
        const beyond = at(k === 0 ? first + n - 1 : first + k + 1);
        const crossing = isEnd ? crossingWithCircle([x, y], beyond, circle) : null;
        const isNext = crossing !== null && Math.hypot(crossing[0] - x, crossing[1] - y) <= MOST_MOVE;
        const share = radius / Math.hypot(x - cx, y - cy);
        placed.set(isNext ? crossing : [cx + (x - cx) * share, cy + (y - cy) * share], 2 * ((first + k) % n));
      }
    }
  }
  return isSimpleRing(placed) ? placed : ring;
}

/** Where the line through two places crosses a circle, next to the first; null where it passes by. */
export function crossingWithCircle([x, y]: Vec2, [toX, toY]: Vec2, { cx, cy, radius }: Circle): Vec2 | null {
  const length = Math.hypot(toX - x, toY - y);
  const [ux, uy] = [(toX - x) / length, (toY - y) / length];
  const along = (x - cx) * ux + (y - cy) * uy;
  const rest = along * along - ((x - cx) ** 2 + (y - cy) ** 2 - radius * radius);
  if (!(rest > 0)) return null;
  const root = Math.sqrt(rest);
  const step = Math.abs(-along - root) < Math.abs(-along + root) ? -along - root : -along + root;
  return [x + step * ux, y + step * uy];
}

/** The circles that a polygon's arcs are of, each once. */
export function circlesOf({ arcs = [] }: Polygon): Circle[] {
  const known = new Map<string, Circle>();
  for (const { centre, radius } of arcs) {
    const [cx, cy] = centre;
    known.set(`${cx} ${cy} ${radius}`, { cx, cy, radius });
  }
  return [...known.values()];
}

/** How many edges an arc has in a ring of `count` vertices. */
export function edgesBetween(from: number, to: number, count: number): number {
  return from === to ? count : (to - from + count) % count;
}
