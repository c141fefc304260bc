import type { PointGrid } from '../geometry/point-grid.ts';

/** Edges of a ring by length, longest first; equal lengths by the coordinates of the first point. A binary heap. */
export class EdgeHeap {
  /** Length of the edge {@link pop} gave last. */
  length = 0;
  private keys = new Float64Array(64);
  private edges = new Int32Array(64);
  private size = 0;
  private readonly grid: PointGrid;

  constructor(grid: PointGrid) {
    this.grid = grid;
  }

  /** @param edge its first point */
  push(edge: number, length: number): void {
    if (this.size === this.keys.length) this.grow();
    let at = this.size++;
    while (at > 0) {
      const parent = (at - 1) >> 1;
      if (!this.isBefore(length, edge, parent)) break;
      this.keys[at] = this.keys[parent];
      this.edges[at] = this.edges[parent];
      at = parent;
    }
    this.keys[at] = length;
    this.edges[at] = edge;
  }

  /** Takes the longest edge out; -1 when none is left. */
  pop(): number {
    if (this.size === 0) return -1;
    const { keys, edges } = this;
    const top = edges[0];
    this.length = keys[0];
    const key = keys[--this.size];
    const edge = edges[this.size];
    let at = 0;
    for (;;) {
      let child = 2 * at + 1;
      if (child >= this.size) break;
      if (child + 1 < this.size && this.isBefore(keys[child + 1], edges[child + 1], child)) child++;
      if (this.isBefore(key, edge, child)) break;
      keys[at] = keys[child];
      edges[at] = edges[child];
      at = child;
    }
    keys[at] = key;
    edges[at] = edge;
    return top;
  }

  /** Whether an edge comes before the one at place `other`. */
  private isBefore(length: number, edge: number, other: number): boolean {
    if (length !== this.keys[other]) return length > this.keys[other];
    const { x, y } = this.grid;
    const rival = this.edges[other];
    return x[edge] !== x[rival] ? x[edge] < x[rival] : y[edge] < y[rival];
  }

  private grow(): void {
    const keys = new Float64Array(2 * this.keys.length);
    const edges = new Int32Array(2 * this.edges.length);
    keys.set(this.keys);
    edges.set(this.edges);
    this.keys = keys;
    this.edges = edges;
  }
}
