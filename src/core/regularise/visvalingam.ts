import type { Ring } from '../types.ts';

/** Fewer vertices are no ring. */
const FEWEST = 3;

/**
 * Visvalingam simplification of a ring [Visvalingam93]: the vertex with the smallest effective area goes, over and
 * over, until none is below the tolerance.
 *
 * A vertex's effective area is that of its triangle with its neighbours, but never less than that of a vertex gone
 * before. A binary heap with places; equal areas go by x, then y, so the start of the ring does not matter.
 *
 * @param areaEpsilon m²; vertices with a smaller effective area go
 * @returns vertices of the ring, at least three. O(n log n).
 */
export function visvalingam(ring: Ring, areaEpsilon: number): Ring {
  const n = ring.length / 2;
  if (n <= FEWEST) return ring;
  const next = new Int32Array(n);
  const previous = new Int32Array(n);
  for (let v = 0; v < n; v++) {
    next[v] = (v + 1) % n;
    previous[v] = (v + n - 1) % n;
  }
  const heap = new AreaHeap(ring);
  for (let v = 0; v < n; v++) heap.put(v, triangleArea(ring, previous[v], v, next[v]));
  let left = n;
  while (left > FEWEST && heap.leastArea() < areaEpsilon) {
    const area = heap.leastArea();
    const v = heap.takeLeast();
    const before = previous[v];
    const after = next[v];
    next[before] = after;
    previous[after] = before;
    left--;
    heap.put(before, Math.max(area, triangleArea(ring, previous[before], before, after)));
    heap.put(after, Math.max(area, triangleArea(ring, before, after, next[after])));
  }
  return heap.remaining();
}

function triangleArea(ring: Ring, a: number, b: number, c: number): number {
  const abx = ring[2 * b] - ring[2 * a];
  const aby = ring[2 * b + 1] - ring[2 * a + 1];
  const acx = ring[2 * c] - ring[2 * a];
  const acy = ring[2 * c + 1] - ring[2 * a + 1];
  return Math.abs(abx * acy - aby * acx) / 2;
}

/** Vertices of a ring, least area on top. */
class AreaHeap {
  private readonly ring: Ring;
  private readonly areas: Float64Array;
  private readonly heap: Int32Array;
  /** Place of each vertex in the heap, -1 when it is not there. */
  private readonly placeOf: Int32Array;
  private size = 0;

  constructor(ring: Ring) {
    this.ring = ring;
    this.areas = new Float64Array(ring.length / 2);
    this.heap = new Int32Array(ring.length / 2);
    this.placeOf = new Int32Array(ring.length / 2).fill(-1);
  }

  leastArea(): number {
    return this.areas[this.heap[0]];
  }

  /** Puts a vertex in, or moves it to where its new area belongs. */
  put(vertex: number, area: number): void {
    this.areas[vertex] = area;
    if (this.placeOf[vertex] < 0) this.set(this.size++, vertex);
    this.rise(this.placeOf[vertex]);
    this.sink(this.placeOf[vertex]);
  }

  takeLeast(): number {
    const least = this.heap[0];
    const last = this.heap[--this.size];
    this.placeOf[least] = -1;
    if (last !== least) {
      this.set(0, last);
      this.sink(0);
    }
    return least;
  }

  /** The ring of the vertices still in. */
  remaining(): Ring {
    const kept = new Float64Array(2 * this.size);
    let end = 0;
    for (let v = 0; v < this.placeOf.length; v++) {
      if (this.placeOf[v] < 0) continue;
      kept[end++] = this.ring[2 * v];
      kept[end++] = this.ring[2 * v + 1];
    }
    return kept;
  }

  private set(place: number, vertex: number): void {
    this.heap[place] = vertex;
    this.placeOf[vertex] = place;
  }

  private rise(from: number): void {
    const vertex = this.heap[from];
    let at = from;
    while (at > 0) {
      const parent = (at - 1) >> 1;
      if (!this.isBefore(vertex, this.heap[parent])) break;
      this.set(at, this.heap[parent]);
      at = parent;
    }
    this.set(at, vertex);
  }

  private sink(from: number): void {
    const vertex = this.heap[from];
    let at = from;
    for (let child = 2 * at + 1; child < this.size; child = 2 * at + 1) {
      if (child + 1 < this.size && this.isBefore(this.heap[child + 1], this.heap[child])) child++;
      if (!this.isBefore(this.heap[child], vertex)) break;
      this.set(at, this.heap[child]);
      at = child;
    }
    this.set(at, vertex);
  }

  private isBefore(v: number, w: number): boolean {
    const { ring, areas } = this;
    if (areas[v] !== areas[w]) return areas[v] < areas[w];
    return ring[2 * v] !== ring[2 * w] ? ring[2 * v] < ring[2 * w] : ring[2 * v + 1] < ring[2 * w + 1];
  }
}
