import { type StepValue, text } from './step-text.ts';

/** The digits of an IfcGloballyUniqueId, six bits each. */
const DIGITS = '0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz_$';
/** Any four that differ: each makes 32 of the 128 bits. */
const SEEDS = [0x9747b28c, 0x3c6ef372, 0xa54ff53a, 0x510e527f] as const;

/**
 * Globally unique ids made of what a thing is: a UUID of version 8 (RFC 9562 §5.8) out of hashes of scan, role and content,
 * written as IFC does. So equal plans give equal ids, and a wall keeps its own while others change.
 */
export class IfcGuids {
  readonly #scan: string;
  readonly #used = new Set<string>();

  /** @param scan what tells the scan from others */
  constructor(scan: string) {
    this.#scan = scan;
  }

  /** @param content what tells a thing from others in its role; things told apart by nothing are numbered */
  next(role: string, content: string): StepValue {
    const key = `${this.#scan}\n${role}\n${content}`;
    for (let copy = 0; ; copy++) {
      const guid = guidOf(copy === 0 ? key : `${key}\n${copy}`);
      if (this.#used.has(guid)) continue;
      this.#used.add(guid);
      return text(guid);
    }
  }
}

function guidOf(key: string): string {
  const words = SEEDS.map((seed) => hash(key, seed));
  words[1] = (words[1] & 0xffff0fff) | 0x8000;
  words[2] = (words[2] & 0x3fffffff) | 0x80000000;
  let bits = words.reduce((all, word) => (all << 32n) | BigInt(word >>> 0), 0n);
  let guid = '';
  for (let i = 0; i < 22; i++) {
    guid = DIGITS[Number(bits & 63n)] + guid;
    bits >>= 6n;
  }
  return guid;
}

/** MurmurHash3 of 32 bits [Appleby11] over UTF-16 units, a block each. */
function hash(key: string, seed: number): number {
  let h = seed;
  for (let i = 0; i < key.length; i++) {
    let k = Math.imul(key.charCodeAt(i), 0xcc9e2d51);
    k = Math.imul((k << 15) | (k >>> 17), 0x1b873593);
    h ^= k;
    h = (Math.imul((h << 13) | (h >>> 19), 5) + 0xe6546b64) | 0;
  }
  h ^= key.length;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
