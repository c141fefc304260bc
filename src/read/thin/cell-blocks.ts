import { BlockLists } from './block-lists.ts';
import { BlockOrder, type Visit } from './block-order.ts';
import { BlockTable } from './block-table.ts';
import { codeOf, SIDE_BITS } from './cell-code.ts';
import { CellContest, copyCodes } from './cell-contest.ts';
import { type AttributeSet, CODE, type PointRecords, PRIORITY } from './point-records.ts';
import { PointRun, RUN_POINTS } from './point-run.ts';

/** Points that were appended since those who lose their cell were left out, as a share of those that stayed: then it is done again. */
const UNSEEN_SHARE = 1;
/** Points below which it is not worth while: a block that a surface crosses has some thousand cells. */
const LEAST_UNSEEN = 2048;

/** Points looked at in one step: some tens of milliseconds. */
const STEP_POINTS = 1 << 18;

/** So many cells apart along an axis, cells are taken for one: their number has 32 bits. */
export const CELLS_TOLD_APART = 2 ** 32;

export interface BlockOptions {
  /** Edge of a cell, source units. */
  readonly cell: number;
  /** Cells hold every distinct point, not one. */
  readonly keepsAll: boolean;
  readonly has: AttributeSet;
  /** Records that will be needed at most, as far as known. */
  readonly capacity: number;
}

/** Coordinates of points, x, y, z from every `stride` on. */
interface Places {
  readonly xyz: Float64Array;
  readonly stride: number;
}

/**
 * Points by blocks of cells. Points are appended to the pages of their block, unseen; now and then those that lose their
 * cell to another are left out, by a table of the block's cells that fits the cache.
 *
 * So memory is walked through block by block, as in a partitioned hash join, not cell by cell: a table of all cells took
 * up to 1.6 × the processor time. Complexity: O(points).
 */
export class CellBlocks {
  readonly cell: number;
  readonly keepsAll: boolean;
  /** Points held, of which some may yet lose their cell. */
  held = 0;
  /** Numbers the blocks. */
  readonly table = new BlockTable();
  /** The records of each block; settled are those that are the only ones in their cell. */
  readonly lists: BlockLists;
  readonly #contest: CellContest;
  /** Blocks to be settled. */
  readonly #due: number[] = [];
  /** The records of the block at hand, and those that keep their cell. */
  #listed = new Uint32Array(0);
  #kept = new Uint32Array(0);
  #codes = new Uint16Array(0);

  constructor({ cell, keepsAll, has, capacity }: BlockOptions) {
    this.cell = cell;
    this.keepsAll = keepsAll;
    this.lists = new BlockLists(has, capacity);
    this.#contest = new CellContest(keepsAll);
  }

  get records(): PointRecords {
    return this.lists.records;
  }

  /**
   * Adds the points of a run and notes in it which records they became.
   *
   * @param setAttributes gives these records their attributes, before any of them is moved
   */
  append(from: Places, run: PointRun, setAttributes: (records: PointRecords) => void): void {
    this.#appendPlaces(from, run);
    setAttributes(this.records);
    for (const block of this.#due) this.#settleBlock(block);
    this.#due.length = 0;
  }

  /** Leaves out all points that lose their cell, step by step. */
  *settling(): Generator<void> {
    let looked = 0;
    for (let block = 0; block < this.table.count; block++) {
      looked += this.lists.lengthOf(block);
      this.#settleBlock(block);
      if (looked < STEP_POINTS) continue;
      looked = 0;
      yield;
    }
  }

  /** Hands the records of all blocks to others, step by step. */
  *moving(other: CellBlocks): Generator<void> {
    let moved = 0;
    const { records } = this;
    const { words, stride } = records;
    const run = new PointRun();
    for (let block = 0; block < this.table.count; block++) {
      const listed = this.#list(block);
      for (let begin = 0; begin < listed.length; begin += RUN_POINTS) {
        run.count = Math.min(RUN_POINTS, listed.length - begin);
        run.points.set(listed.subarray(begin, begin + run.count));
        for (let k = 0; k < run.count; k++) run.priorities[k] = words[2 * stride * run.points[k] + PRIORITY];
        other.append(records, run, (others) => others.copyAttributes(records, run));
      }
      moved += listed.length;
      if (moved < STEP_POINTS) continue;
      moved = 0;
      yield;
    }
  }

  /** Shows the points kept, and their places in an order that forgets the one they came in; see {@link BlockOrder}. */
  visitInOrder(visit: Visit): Generator<void> {
    return new BlockOrder(this).visit(visit);
  }

  /** Writes the records of a block that keep their cell, and these cells, to the front of arrays. Returns how many they are. */
  listKept(block: number, into: Uint32Array, codes: Uint16Array): number {
    const length = this.lists.lengthOf(block);
    this.lists.copyTo(into, block);
    const listed = into.subarray(0, length);
    if (this.lists.settled[block] !== length) return this.#contest.decide(this.records, listed, codes);
    copyCodes(this.records, listed, codes);
    return length;
  }

  #appendPlaces({ xyz, stride }: Places, { count, points, priorities, records }: PointRun): void {
    const { lists, cell } = this;
    const inverse = 1 / cell;
    let { nexts, ends } = lists;
    let { xyz: ownXyz, words: ownWords } = this.records;
    const ownStride = this.records.stride;
    let block = -1;
    let [lastX, lastY, lastZ] = [0, 0, 0];
    for (let k = 0; k < count; k++) {
      const at = stride * points[k];
      // −0 becomes 0: one place, different bits.
      const x = xyz[at] + 0;
      const y = xyz[at + 1] + 0;
      const z = xyz[at + 2] + 0;
      const ix = Math.floor(x * inverse) | 0;
      const iy = Math.floor(y * inverse) | 0;
      const iz = Math.floor(z * inverse) | 0;
      // A scanner mostly stays in a block.
      if (block < 0 || ix >> SIDE_BITS !== lastX || iy >> SIDE_BITS !== lastY || iz >> SIDE_BITS !== lastZ) {
        lastX = ix >> SIDE_BITS;
        lastY = iy >> SIDE_BITS;
        lastZ = iz >> SIDE_BITS;
        block = this.#blockAt(lastX, lastY, lastZ);
        ({ nexts, ends } = lists);
        ({ xyz: ownXyz, words: ownWords } = this.records);
      }
      let record = nexts[block];
      if (record === ends[block]) {
        record = this.#roomIn(block);
        ({ xyz: ownXyz, words: ownWords } = this.records);
      }
      nexts[block] = record + 1;
      records[k] = record;
      const to = ownStride * record;
      ownXyz[to] = x;
      ownXyz[to + 1] = y;
      ownXyz[to + 2] = z;
      ownWords[2 * to + CODE] = codeOf(ix, iy, iz);
      ownWords[2 * to + PRIORITY] = priorities[k];
    }
    this.held += count;
  }

  #blockAt(x: number, y: number, z: number): number {
    const block = this.table.numberOf(x, y, z);
    if (block === this.lists.count) this.lists.add();
    return block;
  }

  /** The next free record of a block whose last page is full. */
  #roomIn(block: number): number {
    const { lists } = this;
    const settled = lists.settled[block];
    if (lists.lengthOf(block) - settled >= Math.max(LEAST_UNSEEN, UNSEEN_SHARE * settled))
      this.#due.push(block);
    lists.extend(block);
    return lists.nexts[block];
  }

  #list(block: number): Uint32Array {
    const length = this.lists.lengthOf(block);
    if (this.#listed.length < length) {
      this.#listed = new Uint32Array(2 * length);
      this.#kept = new Uint32Array(2 * length);
      this.#codes = new Uint16Array(2 * length);
    }
    this.lists.copyTo(this.#listed, block);
    return this.#listed.subarray(0, length);
  }

  #settleBlock(block: number): void {
    const listed = this.#list(block);
    if (this.lists.settled[block] === listed.length) return;
    const kept = this.#kept.subarray(0, listed.length);
    kept.set(listed);
    const count = this.#contest.decide(this.records, kept, this.#codes);
    // In the order of the list, so that nothing is written over that is still to be moved.
    for (let i = 0; i < count; i++) if (kept[i] !== listed[i]) this.records.move(kept[i], listed[i]);
    this.held -= listed.length - count;
    if (count < listed.length) this.lists.shorten(block, count);
    this.lists.settled[block] = count;
  }
}
