/** CRC-32C's polynomial, bits reversed. */
const POLYNOMIAL = 0x82f63b78;
const SLICES = 8;
/** Entries of one table: one for each value of a byte. */
const ENTRIES = 256;
/** Table k holds what a byte that k bytes follow adds to the sum. */
const TABLES = makeTables();

/** CRC-32C of bytes `begin` up to but without `end`, eight a step ([Kounavis05]). Complexity: O(n). */
export function crc32c(bytes: Uint8Array, begin: number, end: number): number {
  const table = TABLES;
  let sum = -1;
  let at = begin;
  for (const last = end - SLICES; at <= last; at += SLICES) {
    sum ^= bytes[at] | (bytes[at + 1] << 8) | (bytes[at + 2] << 16) | (bytes[at + 3] << 24);
    sum =
      table[7 * ENTRIES + (sum & 255)] ^
      table[6 * ENTRIES + ((sum >>> 8) & 255)] ^
      table[5 * ENTRIES + ((sum >>> 16) & 255)] ^
      table[4 * ENTRIES + (sum >>> 24)] ^
      table[3 * ENTRIES + bytes[at + 4]] ^
      table[2 * ENTRIES + bytes[at + 5]] ^
      table[ENTRIES + bytes[at + 6]] ^
      table[bytes[at + 7]];
  }
  for (; at < end; at++) sum = (sum >>> 8) ^ table[(sum ^ bytes[at]) & 255];
  return ~sum >>> 0;
}

function makeTables(): Int32Array {
  const table = new Int32Array(SLICES * ENTRIES);
  for (let byte = 0; byte < ENTRIES; byte++) {
    let sum = byte;
    for (let bit = 0; bit < 8; bit++) sum = sum & 1 ? (sum >>> 1) ^ POLYNOMIAL : sum >>> 1;
    table[byte] = sum;
  }
  for (let at = ENTRIES; at < table.length; at++) {
    const before = table[at - ENTRIES];
    table[at] = (before >>> 8) ^ table[before & 255];
  }
  return table;
}
