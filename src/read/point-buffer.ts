import { closeRanks } from './close-ranks.ts';
import type { PointChunk } from './cloud-reader.ts';

/** Points handed on at once: some hundred kilobytes, so they stay in cache from decoding to thinning. */
export const CHUNK_POINTS = 1 << 15;

/** The values a point may have, in the order readers number them. */
export const FIELDS = ['x', 'y', 'z', 'red', 'green', 'blue', 'intensity', 'classification'] as const;
export const X = 0;
export const Z = 2;
export const RED = 3;
export const BLUE = 5;
export const INTENSITY = 6;
export const CLASSIFICATION = 7;

/** What full colour is in the source: `uint8` where every value is a byte already; `auto` looks at the first points. */
export type ColourRange = 'unit' | 'uint8' | 'byte' | 'short' | 'auto';

/** Where the values of one field go: the value of point i is `into[first + step · i]`. */
export interface FieldColumn {
  readonly into: Float64Array | Uint8Array;
  readonly first: number;
  readonly step: number;
}

/** Collects decoded values and hands them on as full chunks, so that chunks do not depend on the bytes' pieces. */
export class PointBuffer {
  count = 0;
  readonly xyz = new Float64Array(3 * CHUNK_POINTS);
  readonly #values: (Float64Array | Uint8Array)[] = [];
  readonly #colour: Uint8Array | undefined;
  readonly #intensity: Float32Array | undefined;
  readonly #classification: Uint8Array | undefined;
  readonly #range: ColourRange;
  #colourScale: number | undefined;
  #places = new Uint32Array(0);

  /** @param has whether the source has a field, by its number in {@link FIELDS} */
  constructor(has: (field: number) => boolean, range: ColourRange = 'auto') {
    const hasColour = has(RED) && has(RED + 1) && has(BLUE);
    this.#range = range;
    if (hasColour) this.#colour = new Uint8Array(3 * CHUNK_POINTS);
    if (has(INTENSITY)) this.#intensity = new Float32Array(CHUNK_POINTS);
    if (has(CLASSIFICATION)) this.#classification = new Uint8Array(CHUNK_POINTS);
    if (this.#colour)
      this.#values[RED] = range === 'uint8' ? this.#colour : new Float64Array(3 * CHUNK_POINTS);
    if (has(INTENSITY)) this.#values[INTENSITY] = new Float64Array(CHUNK_POINTS);
    if (has(CLASSIFICATION)) this.#values[CLASSIFICATION] = new Float64Array(CHUNK_POINTS);
  }

  get free(): number {
    return CHUNK_POINTS - this.count;
  }

  /** Where values of a field go from the next free point on, or undefined where the field is of no use. */
  column(field: number): FieldColumn | undefined {
    if (field <= Z) return { into: this.xyz, first: 3 * this.count + field, step: 3 };
    const isColour = field >= RED && field <= BLUE;
    const into = this.#values[isColour ? RED : field];
    if (!into) return undefined;
    return isColour
      ? { into, first: 3 * this.count + field - RED, step: 3 }
      : { into, first: this.count, step: 1 };
  }

  /** Adds one point. @param values by field number; those of fields the source lacks are not looked at */
  push(values: Float64Array): void {
    const at = 3 * this.count;
    this.xyz[at] = values[X];
    this.xyz[at + 1] = values[X + 1];
    this.xyz[at + 2] = values[Z];
    const colour = this.#values[RED];
    if (colour) {
      colour[at] = values[RED];
      colour[at + 1] = values[RED + 1];
      colour[at + 2] = values[BLUE];
    }
    if (this.#intensity) this.#values[INTENSITY][this.count] = values[INTENSITY];
    if (this.#classification) this.#values[CLASSIFICATION][this.count] = values[CLASSIFICATION];
    this.count++;
  }

  /** Drops those of the points from `first` on whose mark is not 0; `marks[0]` is the first one's. */
  dropMarked(first: number, marks: Float64Array): void {
    if (this.#places.length === 0) this.#places = new Uint32Array(CHUNK_POINTS);
    const places = this.#places;
    let count = 0;
    for (let i = first; i < this.count; i++) if (marks[i - first] === 0) places[count++] = i;
    this.count = first + count;
    closeRanks(this.xyz, 3, { places, count, first });
    this.#values.forEach((values, field) => {
      closeRanks(values, field === RED ? 3 : 1, { places, count, first });
    });
  }

  /** The points so far, as a chunk whose arrays are used again. */
  take(): PointChunk {
    const count = this.count;
    this.count = 0;
    if (this.#colour && this.#range !== 'uint8') this.#convertColour(this.#colour, 3 * count);
    this.#intensity?.set(this.#values[INTENSITY].subarray(0, count));
    if (this.#classification) copyBytes(this.#values[CLASSIFICATION], this.#classification, count);
    return {
      count,
      xyz: this.xyz,
      ...(this.#colour && { colour: this.#colour }),
      ...(this.#intensity && { intensity: this.#intensity }),
      ...(this.#classification && { classification: this.#classification }),
    };
  }

  #convertColour(colour: Uint8Array, length: number): void {
    const values = this.#values[RED];
    this.#colourScale ??= colourScale(values, length, this.#range);
    // Black tells nothing yet: any scale is right.
    const scale = this.#colourScale ?? 0;
    for (let i = 0; i < length; i++) {
      const value = values[i] * scale + 0.5;
      colour[i] = value > 255 ? 255 : value > 0 ? value : 0;
    }
  }
}

/** A buffer for what records hold. */
export function bufferFor(fields: readonly { readonly field: number }[], range?: ColourRange): PointBuffer {
  return new PointBuffer((number) => fields.some(({ field }) => field === number), range);
}

/** Factor to 0 … 255. Floats go to 1 or, in some files, to 255: the largest of the first chunk that is not black tells. */
function colourScale(values: ArrayLike<number>, length: number, range: ColourRange): number | undefined {
  if (range === 'byte') return 1;
  if (range === 'short') return 255 / 65535;
  let largest = 0;
  let hasFraction = range === 'unit';
  for (let i = 0; i < length; i++) {
    if (values[i] > largest) largest = values[i];
    if (values[i] % 1 !== 0) hasFraction = true;
  }
  if (largest === 0) return undefined;
  if (largest > 255) return 255 / 65535;
  return largest <= 1 && hasFraction ? 255 : 1;
}

function copyBytes(from: ArrayLike<number>, to: Uint8Array, count: number): void {
  for (let i = 0; i < count; i++) to[i] = from[i];
}
