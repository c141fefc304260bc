import type { Bounds } from '../geometry/rings.ts';

/** A balanced tree of boxes over boxes in a row: node 1 is the root, nodes 2n and 2n + 1 lie below node n. */
export class BoxTree {
  /** Node of the first box; the others follow. */
  readonly leaves: number;
  /** minX, minY, maxX, maxY a node; inverted and infinite where nothing is. */
  readonly #boxes: Float64Array;

  constructor(boxes: readonly Bounds[]) {
    this.leaves = 2 ** Math.ceil(Math.log2(Math.max(1, boxes.length)));
    const all = new Float64Array(8 * this.leaves);
    for (let at = 0; at < all.length; at++) all[at] = at % 4 < 2 ? Infinity : -Infinity;
    boxes.forEach(({ minX, minY, maxX, maxY }, k) => {
      all.set([minX, minY, maxX, maxY], 4 * (this.leaves + k));
    });
    for (let node = this.leaves - 1; node > 0; node--) {
      for (let side = 0; side < 4; side++) {
        const [one, other] = [all[8 * node + side], all[8 * node + 4 + side]];
        all[4 * node + side] = side < 2 ? Math.min(one, other) : Math.max(one, other);
      }
    }
    this.#boxes = all;
  }

  /** From a point to the box of a node: 0 inside, infinite where nothing is. */
  squaredDistance(node: number, x: number, y: number): number {
    const at = 4 * node;
    const dx = Math.max(this.#boxes[at] - x, 0, x - this.#boxes[at + 2]);
    const dy = Math.max(this.#boxes[at + 1] - y, 0, y - this.#boxes[at + 3]);
    return dx * dx + dy * dy;
  }
}
