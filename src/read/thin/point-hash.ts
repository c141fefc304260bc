/*
 * The multipliers are odd and without pattern: the digits of the golden ratio, and those of MurmurHash3 [Appleby11]. They
 * stand where they are used, as a minified bundle makes variables of constants, which an engine checks at every use.
 */

/**
 * A number that looks random but depends on nothing except the bits of a point's float64 coordinates, and neither on their
 * order nor on their signs: a cloud whose axes are named otherwise keeps the same points.
 *
 * @param words the bits, of x from `at` on
 */
export function pointPriority(words: Int32Array, at: number): number {
  const x = coordinateHash(words[at], words[at + 1]);
  const y = coordinateHash(words[at + 2], words[at + 3]);
  return finish(x + y + coordinateHash(words[at + 4], words[at + 5]));
}

/** A number that scatters the places of a lattice. */
export function placeHash(ix: number, iy: number, iz: number): number {
  return finish(Math.imul(ix, 0x9e3779b1) + Math.imul(iy, 0x85ebca77) + Math.imul(iz, 0xc2b2ae3d));
}

/** Of the two halves of a float64, its sign left out; not linear, or sums of coordinates would be told apart, not places. */
function coordinateHash(low: number, high: number): number {
  const h = Math.imul(low, 0x9e3779b1) + Math.imul(high & 0x7fffffff, 0x85ebca77);
  return Math.imul(h ^ (h >>> 15), 0xc2b2ae3d);
}

/** The finaliser of MurmurHash3: every bit of the sum reaches every bit of the result. */
function finish(sum: number): number {
  let h = sum | 0;
  h = Math.imul(h ^ (h >>> 16), 0x85ebca6b);
  h = Math.imul(h ^ (h >>> 13), 0xc2b2ae35);
  return h ^ (h >>> 16);
}
