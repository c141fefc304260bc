/** Less than this is no capacity left. */
const NOTHING = 1e-12;

/**
 * The cheapest cut of a graph into a source's and a sink's side, by Dinic's algorithm ([Dinic70]).
 *
 * O(n² e) at worst, near linear on the planar graphs of a plan.
 */
export class MinCut {
  readonly #nodes: number;
  readonly #first: Int32Array;
  readonly #to: number[] = [];
  readonly #next: number[] = [];
  readonly #capacity: number[] = [];

  /** @param nodes numbered from 0; the source and the sink come after them */
  constructor(nodes: number) {
    this.#nodes = nodes;
    this.#first = new Int32Array(nodes + 2).fill(-1);
  }

  /** What it costs to put a node on the sink's side, and on the source's. */
  addTerminals(node: number, costAtSink: number, costAtSource: number): void {
    if (costAtSink > 0) this.#link(this.#nodes, node, costAtSink, 0);
    if (costAtSource > 0) this.#link(node, this.#nodes + 1, costAtSource, 0);
  }

  /** What it costs to part two nodes. */
  addEdge(a: number, b: number, cost: number): void {
    if (cost > 0) this.#link(a, b, cost, cost);
  }

  /** 1 for the nodes on the source's side. */
  solve(): Uint8Array {
    const [source, sink] = [this.#nodes, this.#nodes + 1];
    const level = new Int32Array(this.#nodes + 2);
    for (;;) {
      this.#layer(level, source);
      if (level[sink] < 0) break;
      const at = this.#first.slice();
      while (this.#augment(level, at, source, sink) > NOTHING);
    }
    return Uint8Array.from({ length: this.#nodes }, (_, node) => (level[node] >= 0 ? 1 : 0));
  }

  #link(a: number, b: number, there: number, back: number): void {
    for (const [from, to, capacity] of [
      [a, b, there],
      [b, a, back],
    ]) {
      this.#to.push(to);
      this.#capacity.push(capacity);
      this.#next.push(this.#first[from]);
      this.#first[from] = this.#to.length - 1;
    }
  }

  /** Fewest links from the source, −1 where no capacity leads. */
  #layer(level: Int32Array, source: number): void {
    level.fill(-1);
    level[source] = 0;
    const queue = [source];
    for (let k = 0; k < queue.length; k++) {
      for (let e = this.#first[queue[k]]; e >= 0; e = this.#next[e]) {
        if (this.#capacity[e] <= NOTHING || level[this.#to[e]] >= 0) continue;
        level[this.#to[e]] = level[queue[k]] + 1;
        queue.push(this.#to[e]);
      }
    }
  }

  /** Sends flow along one path of falling distance; without recursion, as paths may be long. */
  #augment(level: Int32Array, at: Int32Array, source: number, sink: number): number {
    const path: number[] = [];
    let node = source;
    while (node !== sink) {
      const e = at[node];
      if (e < 0) {
        if (path.length === 0) return 0;
        const back = path.pop()!;
        node = this.#to[back ^ 1];
        at[node] = this.#next[at[node]];
        continue;
      }
      if (this.#capacity[e] > NOTHING && level[this.#to[e]] === level[node] + 1) {
        path.push(e);
        node = this.#to[e];
      } else at[node] = this.#next[e];
    }
    let flow = Infinity;
    for (const e of path) flow = Math.min(flow, this.#capacity[e]);
    for (const e of path) {
      this.#capacity[e] -= flow;
      this.#capacity[e ^ 1] += flow;
    }
    return flow;
  }
}
