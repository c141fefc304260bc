import type { Random } from '../../fixtures/simulator/random.ts';
import type { Bytes, Span } from './seed.ts';

/** Where an edit may fall. */
export interface Zone {
  readonly span: Span;
  readonly boundaries: readonly number[];
}

export type ByteEdit = (bytes: Bytes, zone: Zone, random: Random) => Bytes;

const POWERS = [7, 8, 15, 16, 24, 31, 32, 40, 53, 63].map((bits) => 2n ** BigInt(bits));
const INTEGERS = [
  0n,
  1n,
  -1n,
  2n,
  64n,
  100n,
  1020n,
  1024n,
  ...POWERS.flatMap((power) => [power - 1n, power, -power]),
];
const FLOATS = [0, -0, 1, -1, 1e-300, 1e-9, 0.1, 1e9, 1e12, 1e13, 3e38, 1e300, NaN, Infinity, -Infinity];
/** Edits fall so near behind a boundary: the first fields of a record. */
const NEAR_BYTES = 12;
const TAIL_BYTES = 64;
const LONGEST_SPAN = 200;

/** Edits that leave everything where it is. */
export const RIGID_EDITS: readonly ByteEdit[] = [
  (bytes, zone, random) => {
    bytes[placeIn(bytes, zone, random)] ^= 1 << random.integer(0, 7);
    return bytes;
  },
  (bytes, zone, random) => {
    bytes[placeIn(bytes, zone, random)] = random.pick([
      0,
      1,
      10,
      32,
      127,
      128,
      254,
      255,
      random.integer(0, 255),
    ]);
    return bytes;
  },
  putInteger,
  putInteger,
  putFloat,
  (bytes, zone, random) => {
    const [begin, end] = spanIn(bytes, zone, random);
    return bytes.fill(random.pick([0, 255, 32]), begin, end);
  },
  (bytes, zone, random) => {
    const [begin, end] = spanIn(bytes, zone, random);
    return bytes.copyWithin(placeIn(bytes, zone, random), begin, end);
  },
];

/** Edits after which the rest lies elsewhere, or is gone. */
export const LOOSE_EDITS: readonly ByteEdit[] = [
  (bytes, zone, random) => bytes.slice(0, placeIn(bytes, zone, random)),
  (bytes, zone, random) => bytes.slice(0, random.pick(zone.boundaries.length > 0 ? zone.boundaries : [0])),
  (bytes, zone, random) => splice(bytes, spanIn(bytes, zone, random), []),
  (bytes, zone, random) => {
    const span = spanIn(bytes, zone, random);
    return splice(bytes, [span[1], span[1]], bytes.subarray(...span));
  },
  (bytes, zone, random) => {
    const at = placeIn(bytes, zone, random);
    return splice(
      bytes,
      [at, at],
      Array.from({ length: random.integer(1, 40) }, () => random.integer(0, 255)),
    );
  },
];

function putInteger(bytes: Bytes, zone: Zone, random: Random): Bytes {
  const size = random.pick([1, 2, 4, 8]);
  const at = Math.min(placeIn(bytes, zone, random), bytes.length - size);
  if (at < 0) return bytes;
  const value = random.chance(0.2) ? BigInt(bytes.length + random.integer(-9, 9)) : random.pick(INTEGERS);
  const word = new DataView(new ArrayBuffer(8));
  const isLittle = random.chance(0.8);
  word.setBigUint64(0, BigInt.asUintN(64, value), isLittle);
  bytes.set(new Uint8Array(word.buffer, isLittle ? 0 : 8 - size, size), at);
  return bytes;
}

function putFloat(bytes: Bytes, zone: Zone, random: Random): Bytes {
  const size = random.pick([4, 8]);
  const at = Math.min(placeIn(bytes, zone, random), bytes.length - size);
  if (at < 0) return bytes;
  const view = new DataView(bytes.buffer);
  const isLittle = random.chance(0.8);
  if (size === 4) view.setFloat32(at, random.pick(FLOATS), isLittle);
  else view.setFloat64(at, random.pick(FLOATS), isLittle);
  return bytes;
}

/** Near a boundary, in the tail or anywhere in the zone. */
function placeIn(bytes: Bytes, { span: [begin, stop], boundaries }: Zone, random: Random): number {
  const end = Math.min(stop, bytes.length) - 1;
  const low = Math.min(begin, Math.max(0, end));
  if (end <= low) return low;
  const die = random.next();
  if (die < 0.4 && boundaries.length > 0) {
    const at = random.pick(boundaries) + random.integer(0, NEAR_BYTES);
    return Math.min(end, Math.max(low, at));
  }
  return random.integer(die < 0.5 ? Math.max(low, end - TAIL_BYTES) : low, end);
}

function spanIn(bytes: Bytes, zone: Zone, random: Random): Span {
  const begin = placeIn(bytes, zone, random);
  const end = Math.min(bytes.length, zone.span[1], begin + random.integer(1, random.pick([8, LONGEST_SPAN])));
  return [begin, Math.max(begin, end)];
}

export function splice(bytes: Bytes, [begin, end]: Span, instead: ArrayLike<number>): Bytes {
  const result = new Uint8Array(begin + instead.length + bytes.length - end);
  result.set(bytes.subarray(0, begin));
  result.set(instead, begin);
  result.set(bytes.subarray(end), begin + instead.length);
  return result;
}
