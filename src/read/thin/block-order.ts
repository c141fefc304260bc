import type { CellBlocks } from './cell-blocks.ts';
import { IN_BLOCK, SIDE, SIDE_BITS } from './cell-code.ts';
import { type PointRecords, TAG_WORDS } from './point-records.ts';

/** Shown records and the places they have. */
export type Visit = (records: Uint32Array, places: Uint32Array) => void;

/** Blocks that differ in x only, in its order. */
interface Row {
  readonly blocks: Uint32Array;
  /** Of each line of cells along x, by z, then y, how many records it has; later the next free place of it. */
  readonly lines: Uint32Array;
}

/**
 * The places that points kept have by cell (z slowest, x fastest), then by coordinates: an order that forgets the one they
 * came in. Layer of blocks by layer of blocks, so that little is held beside the points. Complexity: O(points).
 */
export class BlockOrder {
  readonly #blocks: CellBlocks;
  /** Of the layer at hand: its records, their cells, and where those of each block begin. */
  #listed = new Uint32Array(0);
  #codes = new Uint16Array(0);
  #begins = new Uint32Array(0);
  #placed = new Uint32Array(0);

  constructor(blocks: CellBlocks) {
    this.#blocks = blocks;
  }

  /** Shows the points kept block by block, a layer a step. The arrays are used again. */
  *visit(visit: Visit): Generator<void> {
    let place = 0;
    for (const layer of this.#runsOf(this.#blocks.table.inOrder(), 2)) {
      this.#list(layer);
      place = this.#visitLayer(layer, place, visit);
      yield;
    }
  }

  /** Parts of a list of blocks that share a coordinate. */
  #runsOf(blocks: Uint32Array, axis: 1 | 2): readonly Uint32Array[] {
    const { table } = this.#blocks;
    const runs: Uint32Array[] = [];
    for (let begin = 0; begin < blocks.length; ) {
      const shared = table.place(blocks[begin], axis);
      let end = begin + 1;
      while (end < blocks.length && table.place(blocks[end], axis) === shared) end++;
      runs.push(blocks.subarray(begin, end));
      begin = end;
    }
    return runs;
  }

  /** Looks up who keeps a cell in the blocks of a layer. */
  #list(layer: Uint32Array): void {
    let most = 0;
    for (const block of layer) most += this.#blocks.lists.lengthOf(block);
    if (this.#listed.length < most) {
      this.#listed = new Uint32Array(most);
      this.#codes = new Uint16Array(most);
      this.#placed = new Uint32Array(most);
    }
    this.#begins = new Uint32Array(layer.length + 1);
    const [listed, codes] = [this.#listed, this.#codes];
    for (let i = 0; i < layer.length; i++) {
      const begin = this.#begins[i];
      const kept = this.#blocks.listKept(layer[i], listed.subarray(begin), codes.subarray(begin));
      this.#begins[i + 1] = begin + kept;
    }
  }

  /** The layer's records have the places from `first` on: layer of cells by layer of cells, row by row. Returns the place after. */
  #visitLayer(layer: Uint32Array, first: number, visit: Visit): number {
    let index = 0;
    const rows: Row[] = this.#runsOf(layer, 1).map((blocks) => {
      const lines = this.#countLines(index, index + blocks.length);
      index += blocks.length;
      return { blocks, lines };
    });
    let place = first;
    for (let z = 0; z < SIDE; z++) {
      for (const { lines } of rows) {
        for (let line = z * SIDE; line < (z + 1) * SIDE; line++) {
          const count = lines[line];
          lines[line] = place;
          place += count;
        }
      }
    }
    index = 0;
    for (const { blocks, lines } of rows)
      for (let i = 0; i < blocks.length; i++) this.#visitBlock(index++, lines, visit);
    return place;
  }

  /** For the blocks `begin` to `end` of the layer at hand. */
  #countLines(begin: number, end: number): Uint32Array {
    const codes = this.#codes;
    const lines = new Uint32Array(SIDE * SIDE);
    for (let at = this.#begins[begin]; at < this.#begins[end]; at++) lines[codes[at] >> SIDE_BITS]++;
    return lines;
  }

  #visitBlock(index: number, lines: Uint32Array, visit: Visit): void {
    const [begin, end] = [this.#begins[index], this.#begins[index + 1]];
    const listed = this.#listed.subarray(begin, end);
    const placed = this.#placed.subarray(begin, end);
    if (this.#blocks.keepsAll) placePoints(this.#blocks.records, listed, lines, placed);
    else placeCells(this.#codes.subarray(begin, end), lines, placed);
    visit(listed, placed);
  }
}

/** Of a block at hand, a word for each line of cells along x, with a bit for each cell in use; empty between uses. */
const IN_USE = new Int32Array(SIDE * SIDE);

/** A cell's place in its line is told by the bits below its own. @param lines the next free places */
function placeCells(codes: Uint16Array, lines: Uint32Array, placed: Uint32Array): void {
  for (let i = 0; i < codes.length; i++) IN_USE[codes[i] >> SIDE_BITS] |= 1 << (codes[i] & IN_BLOCK);
  for (let i = 0; i < codes.length; i++) {
    const line = codes[i] >> SIDE_BITS;
    placed[i] = lines[line] + countBits(IN_USE[line] & ((1 << (codes[i] & IN_BLOCK)) - 1));
  }
  for (let i = 0; i < codes.length; i++) {
    const line = codes[i] >> SIDE_BITS;
    lines[line] += countBits(IN_USE[line]);
    IN_USE[line] = 0;
  }
}

/** Cells that hold several points: those are sorted. @param lines the next free places */
function placePoints(
  { tags, stride, xyz }: PointRecords,
  listed: Uint32Array,
  lines: Uint32Array,
  placed: Uint32Array,
): void {
  const codeAt = (record: number) => tags[TAG_WORDS * record];
  listed.sort(
    (a, b) =>
      codeAt(a) - codeAt(b) ||
      xyz[stride * a + 2] - xyz[stride * b + 2] ||
      xyz[stride * a + 1] - xyz[stride * b + 1] ||
      xyz[stride * a] - xyz[stride * b],
  );
  for (let i = 0; i < listed.length; i++) placed[i] = lines[codeAt(listed[i]) >> SIDE_BITS]++;
}

/** Bits set in a word, summed in pairs, nibbles and bytes. */
function countBits(word: number): number {
  const pairs = word - ((word >>> 1) & 0x55555555);
  const nibbles = (pairs & 0x33333333) + ((pairs >>> 2) & 0x33333333);
  return Math.imul((nibbles + (nibbles >>> 4)) & 0x0f0f0f0f, 0x01010101) >>> 24;
}
