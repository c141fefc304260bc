import { lineIntersection } from '../../geometry/segments.ts';
import { isSimpleRing } from '../../geometry/simplicity.ts';
import type { Ring } from '../../types.ts';

/** Edges shorter than this are no shape of a wall but a seam of two fits, m. */
const SHORTEST = 0.06;
/** A corner moves no farther than this when a seam closes, m. */
const MOST_MOVE = 0.05;

/** Edges that meet in a vertex and run against each other like this or more are the sides of a spike, cosine. */
const BACKWARDS = -0.95;

/**
 * Closes the seams of an outline: very short edges give way to the corner that their neighbours make, and spikes of space
 * between two fits of one face go.
 *
 * @param ring the room on its left
 */
export function cleanRing(ring: Ring): Ring {
  let current = ring;
  for (;;) {
    const simpler = withoutSpike(current) ?? withoutShortest(current);
    if (simpler === null) return current;
    current = simpler;
  }
}

/** The ring without a spike no wider than a seam: it turns where the shorter side of that begins; null without any. */
function withoutSpike(ring: Ring): Ring | null {
  const n = ring.length / 2;
  for (let i = 0; i < n; i++) {
    // The spike ends in a vertex, or in an edge.
    for (const end of [i, i + 1]) {
      if (n - (end - i) <= 3) continue;
      const foot = spikeFoot([i - 1, i, end, end + 1].map((k) => vertex(ring, k)));
      if (foot === null) continue;
      const blunt = joinedVertices(ring, i, end, foot);
      if (isSimpleRing(blunt)) return blunt;
    }
  }
  return null;
}

/** Where the ring is to turn instead of going around a spike between two tips; null where there is none. */
function spikeFoot([before, tip, otherTip, after]: readonly Place[]): Place | null {
  const [comes, across, goes] = [minus(tip, before), minus(otherTip, tip), minus(after, otherTip)];
  const [inLength, outLength] = [Math.hypot(...comes), Math.hypot(...goes)];
  const isBack = comes[0] * goes[0] + comes[1] * goes[1] <= BACKWARDS * inLength * outLength;
  const isLeft =
    tip[0] === otherTip[0] && tip[1] === otherTip[1]
      ? cross(comes, goes) > 0
      : cross(comes, across) > 0 && cross(across, goes) > 0;
  if (!isBack || !isLeft || Math.hypot(...across) > SHORTEST) return null;
  const [begin, foot] =
    inLength <= outLength ? [before, footOn(before, otherTip, after)] : [after, footOn(after, before, tip)];
  return Math.hypot(...minus(foot, begin)) > SHORTEST ? null : foot;
}

/** The ring with one vertex in place of those from one to another. */
function joinedVertices(ring: Ring, from: number, to: number, place: Place): Ring {
  const n = ring.length / 2;
  const kept: number[] = [];
  for (let k = 0; k < n; k++) {
    if (k === from) kept.push(...place);
    else if (from === to || k !== to % n) kept.push(...vertex(ring, k));
  }
  return Float64Array.from(kept);
}

type Place = readonly [x: number, y: number];

const minus = (a: Place, b: Place): Place => [a[0] - b[0], a[1] - b[1]];
const cross = (a: Place, b: Place): number => a[0] * b[1] - a[1] * b[0];

/** Where the line through a and b is nearest to a place. */
function footOn([x, y]: Place, [ax, ay]: Place, [bx, by]: Place): Place {
  const [dx, dy] = [bx - ax, by - ay];
  const share = ((x - ax) * dx + (y - ay) * dy) / (dx * dx + dy * dy);
  return [ax + share * dx, ay + share * dy];
}

/** Vertex i of a ring, counted around it. */
function vertex(ring: Ring, i: number): Place {
  const n = ring.length / 2;
  return [ring[2 * ((i + n) % n)], ring[2 * ((i + n) % n) + 1]];
}

function withoutShortest(ring: Ring): Ring | null {
  const n = ring.length / 2;
  if (n <= 4) return null;
  const edges = Array.from({ length: n }, (_, i) => {
    const [[ax, ay], [bx, by]] = [vertex(ring, i), vertex(ring, i + 1)];
    return { i, length: Math.hypot(bx - ax, by - ay) };
  });
  const short = edges.filter(({ length }) => length < SHORTEST).sort((a, b) => a.length - b.length);
  for (const { i } of short) {
    const closed = closeEdge(ring, i);
    if (isSimpleRing(closed)) return closed;
  }
  return null;
}

/** The ring without edge i. */
function closeEdge(ring: Ring, i: number): Ring {
  const [before, a, b, after] = [i - 1, i, i + 1, i + 2].map((k) => vertex(ring, k));
  const [mx, my] = [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
  const corner = lineIntersection(...before, ...a, ...b, ...after);
  const isNear = corner !== null && Math.hypot(corner[0] - mx, corner[1] - my) <= MOST_MOVE;
  return joinedVertices(ring, i, i + 1, isNear ? corner : [mx, my]);
}
