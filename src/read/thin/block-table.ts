import { placeHash } from './point-hash.ts';

const FIRST_BLOCKS = 1 << 10;

/** Numbers the blocks of a lattice from 0 on, as they are first asked for: open addressing with linear probing. */
export class BlockTable {
  count = 0;
  /** Number + 1 of the block that a slot holds; twice as many as there is room for blocks, and more. */
  #slots = new Int32Array(4 * FIRST_BLOCKS);
  /** x, y, z a block. */
  #places = new Int32Array(3 * FIRST_BLOCKS);

  /** Number of a block; {@link count} rises where it is new. */
  numberOf(x: number, y: number, z: number): number {
    const slots = this.#slots;
    const places = this.#places;
    const mask = slots.length - 1;
    let slot = placeHash(x, y, z) & mask;
    while (slots[slot] !== 0) {
      const number = slots[slot] - 1;
      if (places[3 * number] === x && places[3 * number + 1] === y && places[3 * number + 2] === z)
        return number;
      slot = (slot + 1) & mask;
    }
    if (3 * this.count === places.length) {
      this.#grow();
      return this.numberOf(x, y, z);
    }
    places.set([x, y, z], 3 * this.count);
    slots[slot] = ++this.count;
    return this.count - 1;
  }

  /** Coordinate of a block. */
  place(number: number, axis: 0 | 1 | 2): number {
    return this.#places[3 * number + axis];
  }

  /** Numbers of all blocks by z, then y, then x. */
  inOrder(): Uint32Array {
    const places = this.#places;
    return Uint32Array.from({ length: this.count }, (_, i) => i).sort(
      (a, b) =>
        places[3 * a + 2] - places[3 * b + 2] ||
        places[3 * a + 1] - places[3 * b + 1] ||
        places[3 * a] - places[3 * b],
    );
  }

  #grow(): void {
    const places = new Int32Array(2 * this.#places.length);
    places.set(this.#places);
    this.#places = places;
    this.#slots = new Int32Array(2 * this.#slots.length);
    const mask = this.#slots.length - 1;
    for (let number = 0; number < this.count; number++) {
      let slot = placeHash(places[3 * number], places[3 * number + 1], places[3 * number + 2]) & mask;
      while (this.#slots[slot] !== 0) slot = (slot + 1) & mask;
      this.#slots[slot] = number + 1;
    }
  }
}
