/** Masks of a storey's height bins: two words an owner, a bit a bin. Shifts reach no farther than a word. */

/** Bits of a mask. */
export const MOST_BINS = 62;
const WORD = 31;

/** Notes that an owner has something in a bin. */
export function setBin(masks: Int32Array, owner: number, bin: number): void {
  masks[2 * owner + (bin < WORD ? 0 : 1)] |= 1 << (bin % WORD);
}

/** Whether an owner has something in a bin; there is none below bin 0. */
export function hasBin(masks: Int32Array, owner: number, bin: number): boolean {
  return bin >= 0 && ((masks[2 * owner + (bin < WORD ? 0 : 1)] >>> (bin % WORD)) & 1) === 1;
}

/** Filled bins of those from `from` to before `to`. */
export function countBins(masks: Int32Array, owner: number, from: number, to: number): number {
  let count = 0;
  for (let bin = from; bin < to; bin++) if (hasBin(masks, owner, bin)) count++;
  return count;
}

/** The highest filled bin; −1 where none is. */
export function highestBin(masks: Int32Array, owner: number): number {
  const [low, high] = [masks[2 * owner], masks[2 * owner + 1]];
  return high !== 0 ? WORD + 31 - Math.clz32(high) : 31 - Math.clz32(low);
}

/** The lowest filled bin; −1 where none is. */
export function lowestBin(masks: Int32Array, owner: number): number {
  const [low, high] = [masks[2 * owner], masks[2 * owner + 1]];
  const lowestOf = (word: number) => 31 - Math.clz32(word & -word);
  if (low !== 0) return lowestOf(low);
  return high !== 0 ? WORD + lowestOf(high) : -1;
}
