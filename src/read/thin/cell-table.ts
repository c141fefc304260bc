import type { HashedRun } from './hashed-run.ts';
import { MATE, NAME_SHIFT, PLACE, PRIORITY, RUN_POINTS } from './hashed-run.ts';

const FIRST_SLOTS = 1 << 16;
/** Share of slots in use past which probing gets long. */
const FULLEST = 0.5;
/** Odd multiplier without pattern: the digits of the golden ratio. */
const SPREAD = 0x9e3779b1;

/**
 * Which of the points kept is in a cell: open addressing with linear probing.
 *
 * A slot is one word, the number of a point and some bits of the hash of its cell's name. The names lie in the order of
 * the points: what a scanner sees together lies together, which random slots do not. Slots that
 * held the names themselves took 1.4 × as long for 4 M kept.
 */
export class CellTable {
  /** Bits of a slot's word that number the point, from 1 on; those above tell cells apart before names are looked at. */
  readonly #numberBits: number;
  #slots: Int32Array<ArrayBuffer>;
  /** Of point i from (i + 1) << NAME_SHIFT on, as {@link HashedRun} makes them. */
  #names: Int32Array<ArrayBuffer>;
  readonly #numbers = new Int32Array(RUN_POINTS);
  /** Keeps the compiler from leaving {@link fetch} out. */
  touched = 0;

  /** @param most points it will ever hold @param expected points it will probably hold */
  constructor(most: number, expected: number) {
    this.#numberBits = 32 - Math.clz32(most);
    this.#slots = new Int32Array(slotsFor(expected));
    this.#names = new Int32Array((expected + 1) << NAME_SHIFT);
  }

  /** Whether it holds `count` points without probing long. */
  hasRoom(count: number): boolean {
    return count <= this.#slots.length * FULLEST;
  }

  /** Room for the names of as many points. */
  growNames(points: number): void {
    const names = new Int32Array((points + 1) << NAME_SHIFT);
    names.set(this.#names.subarray(0, names.length));
    this.#names = names;
  }

  /** Twice the slots, for the first `count` points. */
  growSlots(count: number): void {
    const slots = 2 * this.#slots.length;
    // Let go of the old slots first: the new ones are filled from the names.
    this.#slots = new Int32Array(0);
    this.#slots = new Int32Array(slots);
    const table = this.#slots;
    const names = this.#names;
    const mask = table.length - 1;
    for (let number = 1; number <= count; number++) {
      const name = number << NAME_SHIFT;
      let slot = names[name + PLACE] & mask;
      while (table[slot] !== 0) slot = (slot + 1) & mask;
      table[slot] = this.#wordOf(names[name], names[name + MATE], number);
    }
  }

  /** Forgets all points. */
  clear(): void {
    this.#slots.fill(0);
  }

  /**
   * Touches what {@link find} will look at for the first `count` points of a run, without a branch that waits for it, so
   * that the processor fetches much from memory at a time.
   */
  fetch(run: Int32Array, count: number): void {
    const slots = this.#slots;
    const names = this.#names;
    const numbers = this.#numbers;
    const mask = slots.length - 1;
    const low = (1 << this.#numberBits) - 1;
    let touched = 0;
    for (let k = 0; k < count; k++) numbers[k] = slots[run[(k << NAME_SHIFT) + PLACE] & mask] & low;
    for (let k = 0; k < count; k++) touched ^= names[numbers[k] << NAME_SHIFT];
    this.touched = touched;
  }

  /** Index of the point kept in the cell of the name at `at` of a run; where there is none, ~ of the slot that is its. */
  find(run: Int32Array, at: number): number {
    const slots = this.#slots;
    const names = this.#names;
    const mask = slots.length - 1;
    const low = (1 << this.#numberBits) - 1;
    const key = run[at];
    const mate = run[at + MATE];
    const mark = markOf(key, mate) & ~low;
    let slot = run[at + PLACE] & mask;
    let word = slots[slot];
    while (word !== 0) {
      if ((word & ~low) === mark) {
        const name = (word & low) << NAME_SHIFT;
        if (names[name] === key && names[name + MATE] === mate) return (word & low) - 1;
      }
      slot = (slot + 1) & mask;
      word = slots[slot];
    }
    return ~slot;
  }

  priorityOf(index: number): number {
    return this.#names[((index + 1) << NAME_SHIFT) + PRIORITY];
  }

  /** Puts point `index` into the free slot that {@link find} told of. */
  insert(slot: number, index: number, run: Int32Array, at: number): void {
    const names = this.#names;
    const name = (index + 1) << NAME_SHIFT;
    const key = run[at];
    const mate = run[at + MATE];
    names[name] = key;
    names[name + MATE] = mate;
    names[name + PLACE] = run[at + PLACE];
    names[name + PRIORITY] = run[at + PRIORITY];
    this.#slots[slot] = this.#wordOf(key, mate, index + 1);
  }

  replace(index: number, priority: number): void {
    this.#names[((index + 1) << NAME_SHIFT) + PRIORITY] = priority;
  }

  #wordOf(key: number, mate: number, number: number): number {
    return (markOf(key, mate) & (-1 << this.#numberBits)) | number;
  }
}

function markOf(key: number, mate: number): number {
  return Math.imul(key ^ Math.imul(mate, SPREAD), SPREAD);
}

function slotsFor(points: number): number {
  return 2 ** Math.ceil(Math.log2(Math.max(FIRST_SLOTS, points / FULLEST)));
}
