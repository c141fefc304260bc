import { type Bounds, boundsOf } from '../geometry/rings.ts';
import type { Ring } from '../types.ts';
import { BoxTree } from './box-tree.ts';

/** Edges in a row that share a box of the search. */
const RUN = 8;
/** Deepest search: a tree over the edges of a ring has fewer levels, and each leaves one node behind. */
const MOST_LEVELS = 64;
/** What rounding may set apart, m: no edge as near as another is passed over. */
const ROUNDING = 1e-9;

/** Edges of rings in one flat list; a place on them is an edge, the way along it and the distance to its left. */
export class RingEdges {
  readonly count: number;
  /** Length of each edge, and of all edges before it. */
  readonly length: Float64Array;
  readonly before: Float64Array;
  /** Where the last {@link project} ended. */
  edge = 0;
  /** Way along the edge's line from its start; may leave the edge. */
  along = 0;
  /** Distance to the left of the edge's line: into a polygon. */
  across = 0;
  /** Way along the edge's line by which it leaves the edge: negative before its start, 0 beside it. */
  past = 0;
  readonly #x: Float64Array;
  readonly #y: Float64Array;
  readonly #dx: Float64Array;
  readonly #dy: Float64Array;
  readonly #boxes: BoxTree;
  readonly #stack = new Int32Array(MOST_LEVELS);

  constructor(rings: readonly Ring[]) {
    this.count = rings.reduce((sum, ring) => sum + ring.length / 2, 0);
    const empty = () => new Float64Array(this.count);
    [this.length, this.before, this.#x, this.#y, this.#dx, this.#dy] = Array.from({ length: 6 }, empty);
    let e = 0;
    let way = 0;
    for (const ring of rings) {
      for (let i = 0; i < ring.length; i += 2, e++) {
        const j = (i + 2) % ring.length;
        const length = Math.hypot(ring[j] - ring[i], ring[j + 1] - ring[i + 1]);
        this.#x[e] = ring[i];
        this.#y[e] = ring[i + 1];
        this.#dx[e] = (ring[j] - ring[i]) / length;
        this.#dy[e] = (ring[j + 1] - ring[i + 1]) / length;
        this.length[e] = length;
        this.before[e] = way;
        way += length;
      }
    }
    this.#boxes = new BoxTree(runBoxes(rings));
  }

  /** Finds the edge nearest to a point; of equals the first. About O(log edges) for rings of rooms. */
  project(x: number, y: number): void {
    let least = Infinity;
    let bound = Infinity;
    let top = 0;
    this.#stack[top++] = 1;
    while (top > 0) {
      const node = this.#stack[--top];
      if (this.#boxes.squaredDistance(node, x, y) > bound) continue;
      const run = node - this.#boxes.leaves;
      if (run < 0) {
        const isFirstNearer =
          this.#boxes.squaredDistance(2 * node, x, y) <= this.#boxes.squaredDistance(2 * node + 1, x, y);
        this.#stack[top++] = isFirstNearer ? 2 * node + 1 : 2 * node;
        this.#stack[top++] = isFirstNearer ? 2 * node : 2 * node + 1;
        continue;
      }
      const nearer = this.#projectOn(run, x, y, least);
      if (nearer === least) continue;
      least = nearer;
      bound = (Math.sqrt(least) + ROUNDING) ** 2;
    }
  }

  /** Distance from a point to the nearest edge. */
  distanceTo(x: number, y: number): number {
    this.project(x, y);
    return Math.hypot(this.across, this.past);
  }

  /** As {@link project} over a run of edges, if any is nearer than found yet. */
  #projectOn(run: number, x: number, y: number, found: number): number {
    let least = found;
    for (let e = run * RUN; e < Math.min(this.count, (run + 1) * RUN); e++) {
      const [u, v] = [x - this.#x[e], y - this.#y[e]];
      const along = u * this.#dx[e] + v * this.#dy[e];
      const across = v * this.#dx[e] - u * this.#dy[e];
      const past = along < 0 ? along : Math.max(0, along - this.length[e]);
      const squared = across * across + past * past;
      if (squared > least || (squared === least && e > this.edge)) continue;
      least = squared;
      this.edge = e;
      this.along = along;
      this.across = across;
      this.past = past;
    }
    return least;
  }
}

/** Boxes around the edges of the rings, {@link RUN} to each. */
function runBoxes(rings: readonly Ring[]): Bounds[] {
  const ends = rings.flatMap((ring) =>
    Array.from({ length: ring.length / 2 }, (_, k) => {
      const [i, j] = [2 * k, (2 * k + 2) % ring.length];
      return [ring[i], ring[i + 1], ring[j], ring[j + 1]];
    }),
  );
  const boxes: Bounds[] = [];
  for (let e = 0; e < ends.length; e += RUN) boxes.push(boundsOf(ends.slice(e, e + RUN).flat()));
  return boxes;
}
