import type { Random } from '../../fixtures/simulator/random.ts';

/** A run of bytes: begin and end. */
export type Span = readonly [begin: number, end: number];

export type Bytes = Uint8Array<ArrayBuffer>;

/** A whole file, and what mutators need to know of it. */
export interface Seed {
  /** Its extension counts where the content does not tell. */
  readonly name: string;
  readonly bytes: Bytes;
  /** Where its parts begin and end: headers, fields, tables, records, lines. */
  readonly boundaries: readonly number[];
  /** What is read after opening only: damage there gets past the header. */
  readonly body: Span;
  /** Where it is text. */
  readonly text: readonly Span[];
  /** Offsets count in it, so bytes put in or taken away in the body spoil what follows. */
  readonly isRigid?: boolean;
  /** Puts checksums right. */
  repair?(bytes: Bytes): Bytes;
  /** Makes the file anew with its content spoilt: what byte edits hardly ever reach. */
  remake?(random: Random): Bytes;
  /** How often it is made anew; half the time if not given. */
  readonly remadeShare?: number;
}

export function textOf(bytes: Uint8Array): string {
  return Buffer.from(bytes.buffer, bytes.byteOffset, bytes.byteLength).toString('latin1');
}

export function bytesOfLatin1(text: string): Bytes {
  return Uint8Array.from(Buffer.from(text, 'latin1'));
}

/** Offsets of a mark, and of what follows it. */
export function placesOf(bytes: Uint8Array, mark: string): number[] {
  const text = textOf(bytes);
  const places: number[] = [];
  for (let at = text.indexOf(mark); at >= 0; at = text.indexOf(mark, at + 1))
    places.push(at, at + mark.length);
  return places;
}
