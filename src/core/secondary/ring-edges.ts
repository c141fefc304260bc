import type { Ring } from '../types.ts';

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
  readonly #x: Float64Array;
  readonly #y: Float64Array;
  readonly #dx: Float64Array;
  readonly #dy: Float64Array;

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
  }

  /** Finds the edge nearest to a point. O(edges). */
  project(x: number, y: number): void {
    let least = Infinity;
    for (let e = 0; e < this.count; e++) {
      const [u, v] = [x - this.#x[e], y - this.#y[e]];
      const along = u * this.#dx[e] + v * this.#dy[e];
      const across = v * this.#dx[e] - u * this.#dy[e];
      const past = along < 0 ? along : Math.max(0, along - this.length[e]);
      const squared = across * across + past * past;
      if (squared >= least) continue;
      least = squared;
      this.edge = e;
      this.along = along;
      this.across = across;
    }
  }
}
