import { BlockLists } from './block-lists.ts';
import { BlockOrder, type Visit } from './block-order.ts';
import { BlockTable } from './block-table.ts';
import { CellContest, copyCodes } from './cell-contest.ts';
import { type AttributeSet, type PointRecords, PRIORITY, TAG_WORDS } from './point-records.ts';
import { type Places, PointRun, RUN_POINTS } from './point-run.ts';

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

/**
 * Points by blocks of cells. Points are appended to the pages of their block, unseen; now and then those that lose their
 * cell to another are left out, by a table of the block's cells that fits the cache.
 *
 * So memory is walked through block by block, as in a partitioned hash join, not cell by cell. A table of all cells, its
 * lines fetched ahead, took 1.4 × the processor time of adding and twice the memory where most points are kept, but
 * two thirds of the time where a cell has seventeen. Complexity: O(points).
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
    run.findCells(from, this.cell);
    this.#takeRecords(run);
    this.records.setPlaces(from, run);
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
    const { tags } = records;
    const run = new PointRun();
    for (let block = 0; block < this.table.count; block++) {
      const listed = this.#list(block);
      for (let begin = 0; begin < listed.length; begin += RUN_POINTS) {
        run.count = Math.min(RUN_POINTS, listed.length - begin);
        run.points.set(listed.subarray(begin, begin + run.count));
        for (let k = 0; k < run.count; k++) run.priorities[k] = tags[TAG_WORDS * run.points[k] + PRIORITY];
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

  /** Gives the points of a run a free record each, in their block. A scanner mostly stays in one. */
  #takeRecords(run: PointRun): void {
    const { blockX, blockY, blockZ, records } = run;
    for (let k = 0; k < run.count; ) {
      const block = this.#blockAt(blockX[k], blockY[k], blockZ[k]);
      for (const end = run.endOfBlock(k); k < end; ) k = this.#fill(block, records, k, end);
    }
    this.held += run.count;
  }

  /** Writes free records of a block to a part of `into`, as many as its page has. Returns what follows them. */
  #fill(block: number, into: Int32Array, begin: number, end: number): number {
    const { lists } = this;
    if (lists.nexts[block] === lists.ends[block]) this.#openPage(block);
    let record = lists.nexts[block];
    const last = Math.min(end, begin + lists.ends[block] - record);
    for (let k = begin; k < last; k++) into[k] = record++;
    lists.nexts[block] = record;
    return last;
  }

  #blockAt(x: number, y: number, z: number): number {
    const block = this.table.numberOf(x, y, z);
    if (block === this.lists.count) this.lists.add();
    return block;
  }

  /** For a block whose last page is full. */
  #openPage(block: number): void {
    const { lists } = this;
    const settled = lists.settled[block];
    if (lists.lengthOf(block) - settled >= Math.max(LEAST_UNSEEN, UNSEEN_SHARE * settled))
      this.#due.push(block);
    lists.extend(block);
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
    this.#closeGaps(listed, kept, count);
    this.held -= listed.length - count;
    if (count < listed.length) this.lists.shorten(block, count);
    this.lists.settled[block] = count;
  }

  /** Moves the last of the records kept to the places of those left out before them. */
  #closeGaps(listed: Uint32Array, kept: Uint32Array, count: number): void {
    let stayed = 0;
    let moved = 0;
    for (let i = 0; i < count; i++) {
      if (listed[i] === kept[stayed]) stayed++;
      else listed[moved++] = listed[i];
    }
    this.records.move(kept.subarray(count - moved, count), listed, moved);
  }
}
