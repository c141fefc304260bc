import type { Solid, SolidGroup } from '../../core/types.ts';

/** Horizontal slabs of a solid whose faces are all vertical or horizontal, lowest first. */
export interface SolidSlab {
  /** m */
  readonly low: number;
  readonly high: number;
  /** What stands in the slab: its section is the same at every height. */
  readonly sections: readonly GroupRings[];
  /** Faces that look up at the slab's upper end. */
  readonly tops: readonly GroupRings[];
}

/** Rings x, y, m: the solid to the left, so outer rings turn counter-clockwise. */
export interface GroupRings {
  readonly group: SolidGroup;
  readonly rings: readonly Float64Array[];
}

/** Heights that differ by less than this, m, are one: Boolean operations round. */
const SAME_HEIGHT = 1e-6;
/** A vertex nearer than this to the line through its neighbours, m, came from a triangulation. */
const ON_LINE = 1e-6;

/**
 * Cuts a solid at the heights of its horizontal faces. Between two of them nothing changes, so each slab is an upright
 * prism over the section at its middle: the triangulation is gone and whole faces are left. O(triangles × slabs).
 *
 * @param solid plan frame; every face vertical or horizontal, as everything extruded from a plan is
 */
export function slabsOf(solid: Solid): SolidSlab[] {
  const levels = heightsOf(solid);
  return levels.slice(1).map((high, k) => ({
    low: levels[k],
    high,
    sections: solid.groups
      .map((group) => ({ group, rings: sectionAt(solid, group, (levels[k] + high) / 2) }))
      .filter(({ rings }) => rings.length > 0),
    tops: solid.groups
      .map((group) => ({ group, rings: topRings(solid, group, high) }))
      .filter(({ rings }) => rings.length > 0),
  }));
}

function heightsOf({ positions }: Solid): number[] {
  const sorted = Float64Array.from({ length: positions.length / 3 }, (_, i) => positions[3 * i + 2]).sort();
  const heights: number[] = [];
  for (const z of sorted) if (heights.length === 0 || z - heights.at(-1)! > SAME_HEIGHT) heights.push(z);
  return heights;
}

/** Where the triangles of a group meet a height that no vertex has. */
function sectionAt({ positions, indices }: Solid, { start, count }: SolidGroup, z: number): Float64Array[] {
  const ends: number[] = [];
  for (let at = start; at < start + count; at += 3) {
    const corners = [indices[at], indices[at + 1], indices[at + 2]];
    const above = corners.filter((corner) => positions[3 * corner + 2] > z);
    if (above.length === 0 || above.length === 3) continue;
    // Seen from outside, counter-clockwise: the edge that climbs is the right end, with the solid to the left behind.
    const climbing = corners.findIndex(
      (corner, k) => positions[3 * corner + 2] < z && positions[3 * corners[(k + 1) % 3] + 2] > z,
    );
    const falling = corners.findIndex(
      (corner, k) => positions[3 * corner + 2] > z && positions[3 * corners[(k + 1) % 3] + 2] < z,
    );
    ends.push(
      ...crossing(positions, corners[(falling + 1) % 3], corners[falling], z),
      ...crossing(positions, corners[climbing], corners[(climbing + 1) % 3], z),
    );
  }
  return joinEdges(ends);
}

/** Place on the edge from a lower to a higher vertex; equal for both triangles of the edge to the last bit. */
function crossing(positions: Float64Array, low: number, high: number, z: number): [x: number, y: number] {
  const share = (z - positions[3 * low + 2]) / (positions[3 * high + 2] - positions[3 * low + 2]);
  const at = (axis: 0 | 1): number => {
    const [from, to] = [positions[3 * low + axis], positions[3 * high + axis]];
    return from === to ? from : from + share * (to - from);
  };
  return [at(0), at(1)];
}

/** Rings around the faces of a group that look up at a height. */
function topRings({ positions, indices }: Solid, { start, count }: SolidGroup, z: number): Float64Array[] {
  const edges = new Map<string, readonly [number, number]>();
  for (let at = start; at < start + count; at += 3) {
    const corners = [indices[at], indices[at + 1], indices[at + 2]];
    if (!corners.every((corner) => Math.abs(positions[3 * corner + 2] - z) <= SAME_HEIGHT)) continue;
    if (turnOf(positions, corners) <= 0) continue;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      // An edge that two triangles share is none of the face's.
      if (!edges.delete(`${to} ${from}`)) edges.set(`${from} ${to}`, [from, to]);
    });
  }
  const ends = [...edges.values()].flatMap((edge) =>
    edge.flatMap((vertex) => [positions[3 * vertex], positions[3 * vertex + 1]]),
  );
  return joinEdges(ends);
}

/** Twice the area of a triangle seen from above, positive when it looks up. */
function turnOf(positions: Float64Array, [a, b, c]: readonly number[]): number {
  const x = (vertex: number): number => positions[3 * vertex];
  const y = (vertex: number): number => positions[3 * vertex + 1];
  return (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
}

/** Joins directed edges, four numbers each, into rings without needless vertices. */
function joinEdges(ends: readonly number[]): Float64Array[] {
  const from = new Map<string, number[]>();
  for (let e = 0; e < ends.length; e += 4) {
    const key = `${ends[e]} ${ends[e + 1]}`;
    const known = from.get(key);
    if (known === undefined) from.set(key, [e]);
    else known.push(e);
  }
  const used = new Uint8Array(ends.length / 4);
  const rings: Float64Array[] = [];
  for (let first = 0; first < ends.length; first += 4) {
    const ring: number[] = [];
    for (let e: number | undefined = first; e !== undefined && used[e / 4] === 0; ) {
      used[e / 4] = 1;
      ring.push(ends[e], ends[e + 1]);
      e = from.get(`${ends[e + 2]} ${ends[e + 3]}`)?.find((next) => used[next / 4] === 0);
    }
    const straight = withoutNeedless(ring);
    if (straight.length >= 6) rings.push(straight);
  }
  return rings;
}

/** Leaves out vertices on the line between their neighbours. */
function withoutNeedless(ring: readonly number[]): Float64Array {
  const kept: number[] = [];
  const n = ring.length;
  for (let i = 0; i < n; i += 2) {
    // The vertex before is the last one kept, or around the start the last of the ring.
    const [ax, ay] = kept.length > 0 ? kept.slice(-2) : [ring[n - 2], ring[n - 1]];
    const [bx, by] = [ring[i], ring[i + 1]];
    const [cx, cy] = [ring[(i + 2) % n], ring[(i + 3) % n]];
    const length = Math.hypot(cx - ax, cy - ay);
    const cross = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (length === 0 || Math.abs(cross) > ON_LINE * length) kept.push(bx, by);
  }
  return Float64Array.from(kept);
}
