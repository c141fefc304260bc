import { STEPS_PER_METRE } from '../core/geometry/clip-grid.ts';
import type { Polygon, Ring } from '../core/types.ts';

/**
 * Sections cut from one another round the same crossing to places at most this far apart, and off the edge it lies on,
 * m: some steps of the Booleans' grid, far below what {@link separatePinches} keeps apart.
 */
const SAME = 4 / STEPS_PER_METRE;

interface Vertex {
  readonly x: number;
  readonly y: number;
}

/**
 * Makes sections cut from one another share their vertices and edges: vertices that rounding set apart become one, and
 * every edge takes up the vertices of other sections that lie on it. Edges × vertices near them in x.
 *
 * @param sections disjoint polygons each, no vertex on another edge
 */
export function shareVertices(sections: readonly (readonly Polygon[])[]): Polygon[][] {
  const vertices = new VertexPool();
  const joined = mapRings(sections, (ring) => vertices.join(ring));
  const sorted = vertices.sorted();
  return mapRings(joined, (ring) => withoutSpikes(withVertices(ring, sorted)));
}

/** Rings of which less than a triangle is left are gone. */
function mapRings(sections: readonly (readonly Polygon[])[], map: (ring: Ring) => Ring): Polygon[][] {
  const isArea = (ring: Ring) => ring.length >= 6;
  return sections.map((section) =>
    section
      .map(({ outer, holes }) => ({ outer: map(outer), holes: holes.map(map).filter(isArea) }))
      .filter(({ outer }) => isArea(outer)),
  );
}

/** Vertices met so far, in cells as wide as two of them may be apart. */
class VertexPool {
  readonly #cells = new Map<string, Vertex>();

  /** The ring over vertices of the pool; those new to it join it. */
  join(ring: Ring): Ring {
    const joined: number[] = [];
    let last: Vertex | null = null;
    for (let i = 0; i < ring.length; i += 2) {
      const vertex = this.#find(ring[i], ring[i + 1]);
      if (vertex !== last) joined.push(vertex.x, vertex.y);
      last = vertex;
    }
    const closes = joined.length > 2 && last !== null && last.x === joined[0] && last.y === joined[1];
    return Float64Array.from(closes ? joined.slice(0, -2) : joined);
  }

  sorted(): Vertex[] {
    return [...this.#cells.values()].sort((a, b) => a.x - b.x || a.y - b.y);
  }

  #find(x: number, y: number): Vertex {
    const [column, row] = [Math.floor(x / SAME), Math.floor(y / SAME)];
    for (let k = 0; k < 9; k++) {
      const known = this.#cells.get(`${column + (k % 3) - 1} ${row + Math.floor(k / 3) - 1}`);
      if (known !== undefined && Math.hypot(known.x - x, known.y - y) <= SAME) return known;
    }
    const vertex = { x, y };
    this.#cells.set(`${column} ${row}`, vertex);
    return vertex;
  }
}

function withVertices(ring: Ring, sorted: readonly Vertex[]): Ring {
  const shared: number[] = [];
  for (let i = 0; i < ring.length; i += 2) {
    const j = (i + 2) % ring.length;
    const [a, b] = [
      { x: ring[i], y: ring[i + 1] },
      { x: ring[j], y: ring[j + 1] },
    ];
    shared.push(a.x, a.y);
    for (const { x, y } of verticesOn(a, b, sorted)) shared.push(x, y);
  }
  return Float64Array.from(shared);
}

/** From a to b, neither included. */
function verticesOn(a: Vertex, b: Vertex, sorted: readonly Vertex[]): Vertex[] {
  const [dx, dy] = [b.x - a.x, b.y - a.y];
  const length = Math.hypot(dx, dy);
  const found: { vertex: Vertex; along: number }[] = [];
  const high = Math.max(a.x, b.x) + SAME;
  for (let k = firstFrom(sorted, Math.min(a.x, b.x) - SAME); k < sorted.length; k++) {
    const vertex = sorted[k];
    if (vertex.x > high) break;
    const [x, y] = [vertex.x - a.x, vertex.y - a.y];
    const along = (x * dx + y * dy) / length;
    const isOn = along > SAME && along < length - SAME && Math.abs(x * dy - y * dx) <= SAME * length;
    if (isOn) found.push({ vertex, along });
  }
  return found.sort((s, t) => s.along - t.along).map(({ vertex }) => vertex);
}

/** Without ways out and back along one edge, which is what a sliver shrinks to when its vertices become one. */
function withoutSpikes(ring: Ring): Ring {
  const kept: number[] = [];
  const isAt = (k: number, x: number, y: number) => kept.at(k) === x && kept.at(k + 1) === y;
  for (let i = 0; i < ring.length; i += 2) {
    if (isAt(-4, ring[i], ring[i + 1])) kept.length -= 2;
    else if (!isAt(-2, ring[i], ring[i + 1])) kept.push(ring[i], ring[i + 1]);
  }
  // Across the ring's end.
  for (;;) {
    if (kept.length > 2 && isAt(-2, kept[0], kept[1])) kept.length -= 2;
    else if (kept.length > 4 && isAt(-4, kept[0], kept[1])) kept.length -= 2;
    else if (kept.length > 4 && isAt(-2, kept[2], kept[3])) kept.splice(0, 2);
    else break;
  }
  return kept.length === ring.length ? ring : Float64Array.from(kept);
}

function firstFrom(sorted: readonly Vertex[], x: number): number {
  let [low, high] = [0, sorted.length];
  while (low < high) {
    const middle = (low + high) >>> 1;
    if (sorted[middle].x < x) low = middle + 1;
    else high = middle;
  }
  return low;
}
