import { BLOCK_CELLS } from './cell-code.ts';
import { CODE, type PointRecords, PRIORITY } from './point-records.ts';

/** Finds those of a block's points that keep their cell, by a table of its cells that fits the cache. */
export class CellContest {
  readonly #keepsAll: boolean;
  /** Record + 1 of a cell, or of a slot; empty between uses. */
  #cells = new Int32Array(BLOCK_CELLS);

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
    const { words, stride } = records;
    const step = 2 * stride;
    const cells = this.#cells;
    let lost = 0;
    for (let i = 0; i < listed.length; i++) {
      const record = listed[i];
      const code = words[step * record + CODE];
      codes[i] = code;
      const rival = cells[code] - 1;
      if (rival >= 0) {
        lost++;
        const lead = words[step * record + PRIORITY] - words[step * rival + PRIORITY];
        if (lead > 0 || (lead === 0 && !records.precedes(record, rival))) continue;
      }
      cells[code] = record + 1;
    }
    if (lost === 0) {
      for (let i = 0; i < listed.length; i++) cells[codes[i]] = 0;
      return listed.length;
    }
    let count = 0;
    for (let i = 0; i < listed.length; i++) {
      const code = codes[i];
      if (cells[code] !== listed[i] + 1) continue;
      cells[code] = 0;
      codes[count] = code;
      listed[count++] = listed[i];
    }
    return count;
  }

  /** The first by attributes keeps a place: a table by priority, the hash of the place. */
  #leaveOutDoubles(records: PointRecords, listed: Uint32Array): number {
    const { words, stride } = records;
    const slots = this.#slotsFor(listed.length);
    const mask = slots.length - 1;
    const slotOf = (record: number) => {
      let slot = words[2 * stride * record + PRIORITY] & mask;
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
export function copyCodes({ words, stride }: PointRecords, listed: Uint32Array, into: Uint16Array): void {
  for (let i = 0; i < listed.length; i++) into[i] = words[2 * stride * listed[i] + CODE];
}
