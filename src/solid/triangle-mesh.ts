/** Triangles over shared vertices: the material of a solid's groups. */
export interface TriangleMesh {
  /** x, y, z a vertex, metres. */
  readonly positions: Float64Array;
  /** Three a triangle, counter-clockwise seen from outside. */
  readonly indices: Uint32Array;
}

/** Joins two vertex numbers of a directed edge into one key; exact below 2^26 vertices. */
const edgeKey = (from: number, to: number): number => from * 2 ** 26 + to;

/**
 * The directed edges that no neighbour closes: those not matched by exactly one edge the other way.
 *
 * A mesh is a closed, consistently oriented two-manifold exactly when there are none. Linear.
 *
 * @param begin first entry in `indices`
 * @param end entry behind the last
 * @returns from, to an edge
 */
export function openEdges(indices: Uint32Array, begin = 0, end = indices.length): Uint32Array {
  const uses = new Map<number, number>();
  forEachEdge(indices, begin, end, (from, to) => {
    const key = edgeKey(from, to);
    uses.set(key, (uses.get(key) ?? 0) + 1);
  });
  const open: number[] = [];
  forEachEdge(indices, begin, end, (from, to) => {
    const isMatched = uses.get(edgeKey(from, to)) === 1 && uses.get(edgeKey(to, from)) === 1;
    if (!isMatched) open.push(from, to);
  });
  return Uint32Array.from(open);
}

function forEachEdge(
  indices: Uint32Array,
  begin: number,
  end: number,
  visit: (from: number, to: number) => void,
): void {
  for (let i = begin; i < end; i += 3) {
    visit(indices[i], indices[i + 1]);
    visit(indices[i + 1], indices[i + 2]);
    visit(indices[i + 2], indices[i]);
  }
}
