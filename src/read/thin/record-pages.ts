import { type AttributeSet, PointRecords } from './point-records.ts';

/** Records of a page: as many as are held already, within these. */
const LEAST_RECORDS = 4;
const MOST_RECORDS = 64;
const FIRST_PAGES = 1 << 12;
/** Share by which the store grows. */
const GROWTH = 1.5;

/** Pages of records, linked to lists: a list grows without moving. */
export class RecordPages {
  readonly records: PointRecords;
  count = 0;
  /** A page's first record, what follows its last one, and the page after it or −1. */
  begins = new Int32Array(FIRST_PAGES);
  ends = new Int32Array(FIRST_PAGES);
  links = new Int32Array(FIRST_PAGES);
  #used = 0;
  /** The first of the linked pages that were given back, or −1. */
  #free = -1;

  constructor(has: AttributeSet, capacity: number) {
    this.records = new PointRecords(has, capacity);
  }

  /** A page for a list that holds so many records. */
  add(held: number): number {
    if (this.#free < 0) return this.#addNew(held);
    const page = this.#free;
    this.#free = this.links[page];
    this.links[page] = -1;
    return page;
  }

  /** Takes back the pages linked behind one. */
  freeAfter(page: number): void {
    const first = this.links[page];
    if (first < 0) return;
    let last = first;
    while (this.links[last] >= 0) last = this.links[last];
    this.links[last] = this.#free;
    this.#free = first;
    this.links[page] = -1;
  }

  #addNew(held: number): number {
    if (this.count === this.begins.length) this.#growPages();
    const page = this.count++;
    const begin = this.#used;
    const end = begin + Math.min(MOST_RECORDS, Math.max(LEAST_RECORDS, held));
    if (end > this.records.capacity) this.records.grow(Math.ceil(Math.max(end, GROWTH * begin)), begin);
    this.begins[page] = begin;
    this.ends[page] = end;
    this.links[page] = -1;
    this.#used = end;
    return page;
  }

  #growPages(): void {
    this.begins = grown(this.begins);
    this.ends = grown(this.ends);
    this.links = grown(this.links);
  }
}

/** Twice as long. */
export function grown(values: Int32Array<ArrayBuffer>): Int32Array<ArrayBuffer> {
  const larger = new Int32Array(2 * values.length);
  larger.set(values);
  return larger;
}
