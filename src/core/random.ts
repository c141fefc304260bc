/** A source of numbers in [0, 1). */
export type Random = () => number;

/**
 * Seeded generator: equal seeds give equal numbers on every machine.
 *
 * sfc32 (PractRand), started by 15 empty rounds, so that neighbouring seeds do not resemble each other.
 *
 * @param seed whole number, 0 to 2³² − 1
 */
export function createRandom(seed: number): Random {
  let a = 0x9e3779b9;
  let b = 0x243f6a88;
  let c = seed | 0;
  let counter = 1;
  const next = (): number => {
    const sum = (((a + b) | 0) + counter) | 0;
    counter = (counter + 1) | 0;
    a = b ^ (b >>> 9);
    b = (c + (c << 3)) | 0;
    c = (((c << 21) | (c >>> 11)) + sum) | 0;
    return (sum >>> 0) / 2 ** 32;
  };
  for (let round = 0; round < 15; round++) next();
  return next;
}
