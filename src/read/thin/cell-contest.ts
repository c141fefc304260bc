import { BLOCK_CELLS } from './cell-code.ts';
import { type PointRecords, PRIORITY, TAG_WORDS } from './point-records.ts';

/** Finds those of a block's points that keep their cell, by a table of its cells that fits the cache. */
export class CellContest {
  readonly #keepsAll: boolean;
  /** Of a cell the place in the list of who holds it, + 1; of a slot the record, + 1. Empty between uses. */
  #cells = new Int32Array(BLOCK_CELLS);
  #priorities = new Int32Array(0);

  /** @param keepsAll cells hold every distinct point, not one */
  constructor(keepsAll: boolean) {
    this.#keepsAll = keepsAll;
  }

  /**
   * Leaves those that keep their cell at the front of a list, in their order. Returns how many they are.
   *
   * @param codes filled with their cells
   */
  decide(records: PointRecords, listed: Uint32Array, codes: Uint16Array): number {
    if (!this.#keepsAll) return this.#leaveOutLosers(records, listed, codes);
    const count = this.#leaveOutDoubles(records, listed);
    copyCodes(records, listed.subarray(0, count), codes);
    return count;
  }

  /** The lowest priority keeps a cell. */
  #leaveOutLosers(records: PointRecords, listed: Uint32Array, codes: Uint16Array): number {
    const { tags } = records;
    const cells = this.#cells;
    if (this.#priorities.length < listed.length) this.#priorities = new Int32Array(2 * listed.length);
    const priorities = this.#priorities;
    for (let i = 0; i < listed.length; i++) {
      const tag = Math.imul(TAG_WORDS, listed[i]);
      codes[i] = tags[tag];
      priorities[i] = tags[tag + PRIORITY];
    }
    let ties = 0;
    for (let i = 0; i < listed.length; i++) {
      const rival = cells[codes[i]] - 1;
      if (rival < 0 || priorities[i] < priorities[rival]) cells[codes[i]] = i + 1;
      else if (priorities[i] === priorities[rival]) ties++;
    }
    if (ties > 0) this.#breakTies(records, listed, codes);
    let count = 0;
    for (let i = 0; i < listed.length; i++) {
      const code = codes[i];
      if (cells[code] !== i + 1) continue;
      cells[code] = 0;
      codes[count] = code;
      listed[count++] = listed[i];
    }
    return count;
  }

  /** Of points of one cell and priority the first by coordinates, then attributes, keeps it. */
  #breakTies(records: PointRecords, listed: Uint32Array, codes: Uint16Array): void {
    const cells = this.#cells;
    const priorities = this.#priorities;
    for (let i = 0; i < listed.length; i++) {
      const rival = cells[codes[i]] - 1;
      if (priorities[i] === priorities[rival] && records.precedes(listed[i], listed[rival]))
        cells[codes[i]] = i + 1;
    }
  }

  /** The first by attributes keeps a place: a table by priority, the hash of the place. */
  #leaveOutDoubles(records: PointRecords, listed: Uint32Array): number {
    const { tags } = records;
    const slots = this.#slotsFor(listed.length);
    const mask = slots.length - 1;
    const slotOf = (record: number) => {
      let slot = tags[TAG_WORDS * record + PRIORITY] & mask;
      while (slots[slot] !== 0 && records.comparePlaces(slots[slot] - 1, record) !== 0)
        slot = (slot + 1) & mask;
      return slot;
    };
    for (const record of listed) {
      const slot = slotOf(record);
      if (slots[slot] === 0 || records.precedes(record, slots[slot] - 1)) slots[slot] = record + 1;
    }
    let count = 0;
    for (const record of listed) if (slots[slotOf(record)] === record + 1) listed[count++] = record;
    slots.fill(0);
    return count;
  }

  /** At least twice as many empty slots. */
  #slotsFor(points: number): Int32Array {
    const length = 2 ** Math.ceil(Math.log2(2 * points + 1));
    if (length > this.#cells.length) this.#cells = new Int32Array(length);
    return this.#cells.subarray(0, length);
  }
}

/** The cells of records. */
export function copyCodes({ tags }: PointRecords, listed: Uint32Array, into: Uint16Array): void {
  for (let i = 0; i < listed.length; i++) into[i] = tags[TAG_WORDS * listed[i]];
}
