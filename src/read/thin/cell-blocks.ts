import { BlockTable } from './block-table.ts';
import { type AttributeSet, CODE, type PointRecords, PRIORITY } from './point-records.ts';
import { grown, RecordPages } from './record-pages.ts';

/** Cells a side of a block as a power of two: a surface crosses it in some thousand cells, which fit the cache; 32 are the bits of a word. */
const SIDE_BITS = 5;
const SIDE = 1 << SIDE_BITS;
const IN_BLOCK = SIDE - 1;
const BLOCK_CELLS = 1 << (3 * SIDE_BITS);
/** Points that were appended since those who lose their cell were left out, as a share of those that stayed: then it is done again. */
const UNSEEN_SHARE = 1;
/** Points below which it is not worth while. */
const LEAST_UNSEEN = 48;
const FIRST_BLOCKS = 1 << 10;

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
 * So memory is walked through block by block, as in a partitioned hash join, not cell by cell: a table of all cells took
 * up to 1.6 × the processor time. Complexity: O(points).
 */
export class CellBlocks {
  readonly cell: number;
  readonly keepsAll: boolean;
  /** Points held, of which some may yet lose their cell. */
  held = 0;
  readonly #pages: RecordPages;
  readonly #table = new BlockTable();
  /** A block's first and last page in use, and how many records are in those before the last. */
  #firsts = new Int32Array(FIRST_BLOCKS);
  #lasts = new Int32Array(FIRST_BLOCKS);
  #before = new Int32Array(FIRST_BLOCKS);
  /** Its next free record, and what follows the last page. */
  #nexts = new Int32Array(FIRST_BLOCKS);
  #ends = new Int32Array(FIRST_BLOCKS);
  /** Records of it that are the only ones in their cell, from the first on. */
  #settled = new Int32Array(FIRST_BLOCKS);
  /** Record + 1 of a block's cell, or of a slot; empty between uses. */
  #cells = new Int32Array(BLOCK_CELLS);
  /** The records of the block at hand. */
  #listed = new Uint32Array(BLOCK_CELLS);
  #placed = new Uint32Array(BLOCK_CELLS);

  constructor({ cell, keepsAll, has, capacity }: BlockOptions) {
    this.cell = cell;
    this.keepsAll = keepsAll;
    this.#pages = new RecordPages(has, capacity);
  }

  get records(): PointRecords {
    return this.#pages.records;
  }

  /** Adds records `begin` to `end` of others that have the same attributes. */
  append(from: PointRecords, begin: number, end: number): void {
    const inverse = 1 / this.cell;
    const { xyz, words, stride } = from;
    const wordStride = 2 * stride;
    let { xyz: ownXyz, words: ownWords } = this.records;
    let block = -1;
    let [lastX, lastY, lastZ] = [0, 0, 0];
    for (let i = begin; i < end; i++) {
      const at = stride * i;
      const ix = Math.floor(xyz[at] * inverse) | 0;
      const iy = Math.floor(xyz[at + 1] * inverse) | 0;
      const iz = Math.floor(xyz[at + 2] * inverse) | 0;
      // A scanner mostly stays in a block.
      if (block < 0 || ix >> SIDE_BITS !== lastX || iy >> SIDE_BITS !== lastY || iz >> SIDE_BITS !== lastZ) {
        lastX = ix >> SIDE_BITS;
        lastY = iy >> SIDE_BITS;
        lastZ = iz >> SIDE_BITS;
        block = this.#blockAt(lastX, lastY, lastZ);
        ({ xyz: ownXyz, words: ownWords } = this.records);
      }
      let record = this.#nexts[block];
      if (record === this.#ends[block]) {
        record = this.#roomIn(block);
        ({ xyz: ownXyz, words: ownWords } = this.records);
      }
      this.#nexts[block] = record + 1;
      const to = stride * record;
      ownXyz[to] = xyz[at];
      ownXyz[to + 1] = xyz[at + 1];
      ownXyz[to + 2] = xyz[at + 2];
      ownWords[2 * to + CODE] = codeOf(ix, iy, iz);
      ownWords[2 * to + PRIORITY] = words[2 * at + PRIORITY];
      for (let k = CODE + 1; k < wordStride; k++) ownWords[2 * to + k] = words[2 * at + k];
    }
    this.held += end - begin;
  }

  /** Leaves out all points that lose their cell. */
  settle(): void {
    for (let block = 0; block < this.#table.count; block++) this.#settleBlock(block);
  }

  /** Hands the records of all blocks to others. */
  moveTo(other: CellBlocks): void {
    const { begins, ends, links } = this.#pages;
    for (let block = 0; block < this.#table.count; block++) {
      let page = this.#firsts[block];
      for (; page !== this.#lasts[block]; page = links[page])
        other.append(this.records, begins[page], ends[page]);
      other.append(this.records, begins[page], this.#nexts[block]);
    }
  }

  /**
   * Shows the records block by block, and the places they have by cell (z slowest, x fastest), then by coordinates: an
   * order that forgets the one they came in. The arrays are used again.
   */
  visitInOrder(visit: (records: Uint32Array, places: Uint32Array) => void): void {
    const blocks = this.#table.inOrder();
    let place = 0;
    for (let begin = 0; begin < blocks.length; ) {
      const end = this.#endOfRun(blocks, begin, 2);
      place = this.#visitLayer(blocks.subarray(begin, end), place, visit);
      begin = end;
    }
  }

  /** Where the blocks that share a coordinate with block `begin` end. */
  #endOfRun(blocks: Uint32Array, begin: number, axis: 1 | 2): number {
    const shared = this.#table.place(blocks[begin], axis);
    let end = begin + 1;
    while (end < blocks.length && this.#table.place(blocks[end], axis) === shared) end++;
    return end;
  }

  /**
   * Blocks of one z, whose records have the places from `first` on: cell layer by cell layer, and in it row of blocks by
   * row of blocks. Returns the place after.
   */
  #visitLayer(
    blocks: Uint32Array,
    first: number,
    visit: (records: Uint32Array, places: Uint32Array) => void,
  ): number {
    const rows: Uint32Array[] = [];
    for (let begin = 0; begin < blocks.length; ) {
      const end = this.#endOfRun(blocks, begin, 1);
      rows.push(blocks.subarray(begin, end));
      begin = end;
    }
    // Records of each line of cells along x, in a row of blocks: by z, then y.
    const lines = rows.map((row) => this.#countLines(row));
    let place = first;
    for (let z = 0; z < SIDE; z++) {
      for (const counts of lines) {
        for (let line = z * SIDE; line < (z + 1) * SIDE; line++) {
          const count = counts[line];
          counts[line] = place;
          place += count;
        }
      }
    }
    rows.forEach((row, i) => {
      for (const block of row) this.#visitBlock(block, lines[i], visit);
    });
    return place;
  }

  #countLines(row: Uint32Array): Uint32Array {
    const counts = new Uint32Array(SIDE * SIDE);
    for (const block of row) {
      this.#settleBlock(block);
      const { words, stride } = this.records;
      for (const record of this.#list(block)) counts[words[2 * stride * record + CODE] >> SIDE_BITS]++;
    }
    return counts;
  }

  /** @param lines the next free place of each line of cells */
  #visitBlock(
    block: number,
    lines: Uint32Array,
    visit: (records: Uint32Array, places: Uint32Array) => void,
  ): void {
    const listed = this.#list(block);
    if (this.#placed.length < listed.length) this.#placed = new Uint32Array(2 * listed.length);
    const placed = this.#placed.subarray(0, listed.length);
    if (this.keepsAll) this.#placePoints(listed, lines, placed);
    else this.#placeCells(listed, lines, placed);
    visit(listed, placed);
  }

  #blockAt(x: number, y: number, z: number): number {
    const before = this.#table.count;
    const block = this.#table.numberOf(x, y, z);
    if (this.#table.count === before) return block;
    if (block === this.#firsts.length) this.#growBlocks();
    const page = this.#pages.add(0);
    this.#firsts[block] = page;
    this.#open(block, page);
    return block;
  }

  #growBlocks(): void {
    this.#firsts = grown(this.#firsts);
    this.#lasts = grown(this.#lasts);
    this.#before = grown(this.#before);
    this.#nexts = grown(this.#nexts);
    this.#ends = grown(this.#ends);
    this.#settled = grown(this.#settled);
  }

  #open(block: number, page: number): void {
    this.#lasts[block] = page;
    this.#nexts[block] = this.#pages.begins[page];
    this.#ends[block] = this.#pages.ends[page];
  }

  #heldIn(block: number): number {
    return this.#before[block] + this.#nexts[block] - this.#pages.begins[this.#lasts[block]];
  }

  /** The next free record of a block whose last page is full. */
  #roomIn(block: number): number {
    const unseen = this.#heldIn(block) - this.#settled[block];
    if (unseen >= Math.max(LEAST_UNSEEN, UNSEEN_SHARE * this.#settled[block])) this.#settleBlock(block);
    if (this.#nexts[block] === this.#ends[block]) {
      const held = this.#heldIn(block);
      const last = this.#lasts[block];
      if (this.#pages.links[last] < 0) {
        // Not in one expression: adding a page may renew the array.
        const page = this.#pages.add(held);
        this.#pages.links[last] = page;
      }
      this.#before[block] = held;
      this.#open(block, this.#pages.links[last]);
    }
    return this.#nexts[block];
  }

  /** The records of a block. */
  #list(block: number): Uint32Array {
    const count = this.#heldIn(block);
    if (count > this.#listed.length) this.#listed = new Uint32Array(2 * count);
    const listed = this.#listed;
    const { begins, ends, links } = this.#pages;
    let filled = 0;
    for (let page = this.#firsts[block]; filled < count; page = links[page]) {
      const end = Math.min(ends[page], begins[page] + count - filled);
      for (let record = begins[page]; record < end; record++) listed[filled++] = record;
    }
    return listed.subarray(0, count);
  }

  #settleBlock(block: number): void {
    if (this.#settled[block] === this.#heldIn(block)) return;
    const listed = this.#list(block);
    const count = this.keepsAll ? this.#leaveOutDoubles(listed) : this.#leaveOutLosers(listed);
    this.held -= listed.length - count;
    this.#settled[block] = count;
    if (count < listed.length) this.#shorten(block, count);
  }

  /** Lets go of a block's records past the first `count`, but not of their pages. */
  #shorten(block: number, count: number): void {
    const { begins, ends, links } = this.#pages;
    let page = this.#firsts[block];
    let before = 0;
    while (before + ends[page] - begins[page] < count) {
      before += ends[page] - begins[page];
      page = links[page];
    }
    this.#before[block] = before;
    this.#open(block, page);
    this.#nexts[block] += count - before;
  }

  /** Moves the points with the lowest priority of their cell to the front of a list of records. Returns how many they are. */
  #leaveOutLosers(listed: Uint32Array): number {
    const { records } = this;
    const { words } = records;
    const step = 2 * records.stride;
    const cells = this.#cells;
    let count = 0;
    for (let i = 0; i < listed.length; i++) {
      const record = listed[i];
      const code = words[step * record + CODE];
      const rival = cells[code] - 1;
      if (rival < 0) {
        const to = listed[count++];
        if (to !== record) moveRecord(records, record, to);
        cells[code] = to + 1;
        continue;
      }
      const lead = words[step * record + PRIORITY] - words[step * rival + PRIORITY];
      if (lead < 0 || (lead === 0 && records.precedes(record, rival))) moveRecord(records, record, rival);
    }
    for (let i = 0; i < count; i++) cells[words[step * listed[i] + CODE]] = 0;
    return count;
  }

  /** The same for points that are the first by attributes in their place: a table by priority, the hash of the place. */
  #leaveOutDoubles(listed: Uint32Array): number {
    const { records } = this;
    const { words } = records;
    const step = 2 * records.stride;
    const slots = this.#slotsFor(listed.length);
    const mask = slots.length - 1;
    let count = 0;
    for (const record of listed) {
      let slot = words[step * record + PRIORITY] & mask;
      while (slots[slot] !== 0 && records.comparePlaces(slots[slot] - 1, record) !== 0)
        slot = (slot + 1) & mask;
      if (slots[slot] === 0) {
        const to = listed[count++];
        if (to !== record) moveRecord(records, record, to);
        slots[slot] = to + 1;
      } else if (records.precedes(record, slots[slot] - 1)) moveRecord(records, record, slots[slot] - 1);
    }
    slots.fill(0);
    return count;
  }

  /** At least twice as many empty slots. */
  #slotsFor(points: number): Int32Array {
    const length = 2 ** Math.ceil(Math.log2(2 * points + 1));
    if (length > this.#cells.length) this.#cells = new Int32Array(length);
    return this.#cells.subarray(0, length);
  }

  /** A line of cells is a word with a bit for each cell in use; the bits below a cell's tell its place in the line. */
  #placeCells(listed: Uint32Array, lines: Uint32Array, placed: Uint32Array): void {
    const { words, stride } = this.records;
    const step = 2 * stride;
    for (const record of listed) {
      const code = words[step * record + CODE];
      IN_USE[code >> SIDE_BITS] |= 1 << (code & IN_BLOCK);
    }
    for (let i = 0; i < listed.length; i++) {
      const code = words[step * listed[i] + CODE];
      const line = code >> SIDE_BITS;
      placed[i] = lines[line] + countBits(IN_USE[line] & ((1 << (code & IN_BLOCK)) - 1));
    }
    for (const record of listed) {
      const line = words[step * record + CODE] >> SIDE_BITS;
      lines[line] += countBits(IN_USE[line]);
      IN_USE[line] = 0;
    }
  }

  #placePoints(listed: Uint32Array, lines: Uint32Array, placed: Uint32Array): void {
    const { words, stride, xyz } = this.records;
    const codeAt = (record: number) => words[2 * stride * record + CODE];
    listed.sort(
      (a, b) =>
        codeAt(a) - codeAt(b) ||
        xyz[stride * a + 2] - xyz[stride * b + 2] ||
        xyz[stride * a + 1] - xyz[stride * b + 1] ||
        xyz[stride * a] - xyz[stride * b],
    );
    for (let i = 0; i < listed.length; i++) placed[i] = lines[codeAt(listed[i]) >> SIDE_BITS]++;
  }
}

/** Of a block at hand, a word for each line of cells along x; empty between uses. */
const IN_USE = new Int32Array(SIDE * SIDE);

/** A cell's number in its block: x fastest. */
function codeOf(ix: number, iy: number, iz: number): number {
  return ((((iz & IN_BLOCK) << SIDE_BITS) | (iy & IN_BLOCK)) << SIDE_BITS) | (ix & IN_BLOCK);
}

/** Bits set in a word, summed in pairs, nibbles and bytes. */
function countBits(word: number): number {
  const pairs = word - ((word >>> 1) & 0x55555555);
  const nibbles = (pairs & 0x33333333) + ((pairs >>> 2) & 0x33333333);
  return Math.imul((nibbles + (nibbles >>> 4)) & 0x0f0f0f0f, 0x01010101) >>> 24;
}

function moveRecord({ xyz, words, stride }: PointRecords, from: number, to: number): void {
  xyz[stride * to] = xyz[stride * from];
  xyz[stride * to + 1] = xyz[stride * from + 1];
  xyz[stride * to + 2] = xyz[stride * from + 2];
  for (let k = PRIORITY; k < 2 * stride; k++) words[2 * stride * to + k] = words[2 * stride * from + k];
}
