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
const ROUNDING = 1e-6;
/** A vertex nearer than this to the line through its neighbours, m, came from a triangulation. */
const ON_LINE = 1e-6;

/**
 * Cuts a solid at the heights of its horizontal faces. Between two of them nothing changes, so each slab is an upright
 * prism over the section at its middle: the triangulation is gone and whole faces are left. O(triangles × slabs).
 *
 * @param exact plan frame; every face vertical or horizontal, as everything extruded from a plan is
 * @param within level faces less than this apart, m, are shown at the height of the lowest of them
 */
export function slabsOf(exact: Solid, within = ROUNDING): SolidSlab[] {
  const levels = heightsOf(exact, within);
  const solid = { ...exact, positions: atLevels(exact.positions, levels, within) };
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

/** Boolean operations leave vertices on upright faces, at any height; only level faces count. */
function heightsOf({ positions, indices }: Solid, within: number): number[] {
  const level: number[] = [];
  for (let at = 0; at < indices.length; at += 3) {
    const [a, b, c] = [0, 1, 2].map((k) => positions[3 * indices[at + k] + 2]);
    if (Math.max(a, b, c) - Math.min(a, b, c) <= ROUNDING) level.push(a);
  }
  const sorted = Float64Array.from(level).sort();
  const heights: number[] = [];
  for (const z of sorted) if (heights.length === 0 || z - heights.at(-1)! > within) heights.push(z);
  return heights;
}

/** Vertices that lie above a level by no more than what does not count are on it. */
function atLevels(positions: Float64Array, levels: readonly number[], within: number): Float64Array {
  const moved = positions.slice();
  const ascending = Float64Array.from(levels);
  for (let i = 2; i < moved.length; i += 3) {
    const z = moved[i];
    const level = ascending.findLast((height) => height <= z);
    if (level !== undefined && z - level <= within) moved[i] = level;
  }
  return moved;
}

/** A directed edge of a section or face; keys name places of the mesh, so equal places need no comparing of numbers. */
interface RingEdge {
  readonly from: number;
  readonly to: number;
  /** Where `from` is, m. */
  readonly x: number;
  readonly y: number;
}

/** Where the triangles of a group meet a height that no vertex has. */
function sectionAt({ positions, indices }: Solid, { start, count }: SolidGroup, z: number): Float64Array[] {
  const vertices = positions.length / 3;
  const edges: RingEdge[] = [];
  for (let at = start; at < start + count; at += 3) {
    const corners = [indices[at], indices[at + 1], indices[at + 2]];
    const isAbove = corners.map((corner) => positions[3 * corner + 2] > z);
    // Counter-clockwise seen from outside: the edge that climbs is the right end, and the solid lies behind, to the left.
    const climbing = isAbove.findIndex((above, k) => !above && isAbove[(k + 1) % 3]);
    const falling = isAbove.findIndex((above, k) => above && !isAbove[(k + 1) % 3]);
    if (climbing < 0) continue;
    const [low, high] = [corners[(falling + 1) % 3], corners[falling]];
    const [x, y] = crossing(positions, low, high, z);
    const to = corners[climbing] * vertices + corners[(climbing + 1) % 3];
    edges.push({ from: low * vertices + high, to, x, y });
  }
  return joinEdges(edges);
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
  const vertices = positions.length / 3;
  const edges = new Map<number, RingEdge>();
  for (let at = start; at < start + count; at += 3) {
    const corners = [indices[at], indices[at + 1], indices[at + 2]];
    if (!corners.every((corner) => Math.abs(positions[3 * corner + 2] - z) <= ROUNDING)) continue;
    if (turnOf(positions, corners) <= 0) continue;
    corners.forEach((from, k) => {
      const to = corners[(k + 1) % 3];
      // An edge that two triangles share is none of the face's.
      if (edges.delete(to * vertices + from)) return;
      edges.set(from * vertices + to, { from, to, x: positions[3 * from], y: positions[3 * from + 1] });
    });
  }
  return joinEdges([...edges.values()]);
}

/** Twice the area of a triangle seen from above, positive when it looks up. */
function turnOf(positions: Float64Array, [a, b, c]: readonly number[]): number {
  const x = (vertex: number): number => positions[3 * vertex];
  const y = (vertex: number): number => positions[3 * vertex + 1];
  return (x(b) - x(a)) * (y(c) - y(a)) - (x(c) - x(a)) * (y(b) - y(a));
}

/** Joins edges into rings without needless vertices. */
function joinEdges(edges: readonly RingEdge[]): Float64Array[] {
  const leaving = new Map<number, number[]>();
  edges.forEach(({ from }, e) => {
    const known = leaving.get(from);
    if (known === undefined) leaving.set(from, [e]);
    else known.push(e);
  });
  const isUsed = new Uint8Array(edges.length);
  const rings: Float64Array[] = [];
  for (const first of edges.keys()) {
    const ring: number[] = [];
    for (let e: number | undefined = first; e !== undefined && !isUsed[e]; ) {
      isUsed[e] = 1;
      ring.push(edges[e].x, edges[e].y);
      e = leaving.get(edges[e].to)?.find((next) => !isUsed[next]);
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
    const last = kept.length;
    const [ax, ay] = last > 0 ? [kept[last - 2], kept[last - 1]] : [ring[n - 2], ring[n - 1]];
    const [bx, by] = [ring[i], ring[i + 1]];
    const [cx, cy] = [ring[(i + 2) % n], ring[(i + 3) % n]];
    const length = Math.hypot(cx - ax, cy - ay);
    const cross = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay);
    if (length === 0 || Math.abs(cross) > ON_LINE * length) kept.push(bx, by);
  }
  return Float64Array.from(kept);
}
