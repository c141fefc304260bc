import type { AttributeSet, PointRecords } from './point-records.ts';
import { grown, RecordPages } from './record-pages.ts';

const FIRST_LISTS = 1 << 10;

/** Lists of records, each in linked pages of its own that are filled one after another. */
export class BlockLists {
  count = 0;
  /** A list's next free record, and what follows its last page in use. */
  nexts = new Int32Array(FIRST_LISTS);
  ends = new Int32Array(FIRST_LISTS);
  /** For the holder to note how many records of a list are settled, from its first on. */
  settled = new Int32Array(FIRST_LISTS);
  readonly #pages: RecordPages;
  /** A list's first and last page in use, and how many records are in those before the last. */
  #firsts = new Int32Array(FIRST_LISTS);
  #lasts = new Int32Array(FIRST_LISTS);
  #before = new Int32Array(FIRST_LISTS);

  constructor(has: AttributeSet, capacity: number) {
    this.#pages = new RecordPages(has, capacity);
  }

  get records(): PointRecords {
    return this.#pages.records;
  }

  /** A new list. */
  add(): void {
    const list = this.count++;
    if (list === this.#firsts.length) this.#grow();
    const page = this.#pages.add(0);
    this.#firsts[list] = page;
    this.#open(list, page);
  }

  /** How many records a list has. */
  lengthOf(list: number): number {
    return this.#before[list] + this.nexts[list] - this.#pages.begins[this.#lasts[list]];
  }

  /** Opens the next page of a list whose last one is full. */
  extend(list: number): void {
    const length = this.lengthOf(list);
    const page = this.#pages.add(length);
    this.#pages.links[this.#lasts[list]] = page;
    this.#before[list] = length;
    this.#open(list, page);
  }

  /** Writes the records of a list to the front of `into`, which has room for them. */
  copyTo(into: Uint32Array, list: number): void {
    const { begins, ends, links } = this.#pages;
    const length = this.lengthOf(list);
    let filled = 0;
    for (let page = this.#firsts[list]; filled < length; page = links[page]) {
      const end = Math.min(ends[page], begins[page] + length - filled);
      for (let record = begins[page]; record < end; record++) into[filled++] = record;
    }
  }

  /** Lets go of a list's records past the first `count`, and of their pages. */
  shorten(list: number, count: number): void {
    const { begins, ends, links } = this.#pages;
    let page = this.#firsts[list];
    let before = 0;
    while (before + ends[page] - begins[page] < count) {
      before += ends[page] - begins[page];
      page = links[page];
    }
    this.#pages.freeAfter(page);
    this.#before[list] = before;
    this.#open(list, page);
    this.nexts[list] += count - before;
  }

  #open(list: number, page: number): void {
    this.#lasts[list] = page;
    this.nexts[list] = this.#pages.begins[page];
    this.ends[list] = this.#pages.ends[page];
  }

  #grow(): void {
    this.nexts = grown(this.nexts);
    this.ends = grown(this.ends);
    this.settled = grown(this.settled);
    this.#firsts = grown(this.#firsts);
    this.#lasts = grown(this.#lasts);
    this.#before = grown(this.#before);
  }
}
