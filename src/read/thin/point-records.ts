import type { PointAttributes } from '../../core/types.ts';
import type { PointChunk } from '../cloud-reader.ts';
import type { Places, PointRun } from './point-run.ts';

/** Words (of 32 bits) of a tag: the point's cell in its block, and its priority. */
export const TAG_WORDS = 2;
export const PRIORITY = 1;

/** Words of a record: x, y and z as float64, then these: red, green and blue from the lowest byte on, classification in the highest. */
const COLOUR = 6;
const INTENSITY = 7;
const STATION = 8;
/** A word that only keeps float64 values aligned. */
const PADDING = 1;

/** Float64 entries of a record: those of a bare point, of one with colour, intensity or class, of one with a station too. */
const BARE = COLOUR >> 1;
const COLOURED = (INTENSITY + 1) >> 1;
const STATIONED = (STATION + 1 + PADDING) >> 1;

/** Which attributes points have. */
export type AttributeSet = Readonly<Record<keyof PointAttributes, boolean>>;

/**
 * Points with all that is known of them: a record each, so that whoever has fetched one part of a point has fetched all of
 * it; and beside it a tag, all that it takes to decide who keeps a cell.
 */
export class PointRecords {
  /** Float64 entries of a record; x, y and z come first. */
  readonly stride: number;
  readonly has: AttributeSet;
  xyz: Float64Array<ArrayBuffer>;
  /** {@link TAG_WORDS} a point. */
  tags: Int32Array<ArrayBuffer>;
  /** The bytes of the records. */
  #words: Int32Array<ArrayBuffer>;
  #floats: Float32Array<ArrayBuffer>;

  constructor(has: AttributeSet, capacity: number) {
    this.has = has;
    const isColoured = has.colour || has.intensity || has.classification;
    this.stride = has.station ? STATIONED : isColoured ? COLOURED : BARE;
    this.xyz = new Float64Array(capacity * this.stride);
    this.tags = new Int32Array(capacity * TAG_WORDS);
    this.#words = new Int32Array(this.xyz.buffer);
    this.#floats = new Float32Array(this.xyz.buffer);
  }

  get capacity(): number {
    return this.xyz.length / this.stride;
  }

  /** Room for `capacity` records, of which `used` are taken over. */
  grow(capacity: number, used: number): void {
    const grown = new Float64Array(capacity * this.stride);
    grown.set(this.xyz.subarray(0, used * this.stride));
    this.xyz = grown;
    const tags = new Int32Array(capacity * TAG_WORDS);
    tags.set(this.tags.subarray(0, used * TAG_WORDS));
    this.tags = tags;
    this.#words = new Int32Array(grown.buffer);
    this.#floats = new Float32Array(grown.buffer);
  }

  /** Gives the records of a run the places and tags of its points. */
  setPlaces({ xyz: from, stride: step }: Places, run: PointRun): void {
    const { count, points, records, codes, priorities } = run;
    const { xyz, tags, stride } = this;
    for (let k = 0; k < count; k++) {
      const own = Math.imul(stride, records[k]);
      const at = Math.imul(step, points[k]);
      // −0 becomes 0: one place, different bits.
      xyz[own] = from[at] + 0;
      xyz[own + 1] = from[at + 1] + 0;
      xyz[own + 2] = from[at + 2] + 0;
    }
    for (let k = 0; k < count; k++) {
      const own = Math.imul(TAG_WORDS, records[k]);
      tags[own] = codes[k];
      tags[own + PRIORITY] = priorities[k];
    }
  }

  /** Gives the records of a run the attributes that its points have in a chunk; those it lacks are 0. */
  setAttributes({ count, points, records }: PointRun, chunk: PointChunk): void {
    if (this.stride === BARE) return;
    const { has } = this;
    const words = this.#words;
    const floats = this.#floats;
    const step = 2 * this.stride;
    const colour = has.colour && chunk.colour;
    const intensity = has.intensity && chunk.intensity;
    const classification = has.classification && chunk.classification;
    const station = has.station && chunk.station;
    if (colour) {
      for (let k = 0; k < count; k++) {
        const i = Math.imul(3, points[k]);
        const word = colour[i] | (colour[i + 1] << 8) | (colour[i + 2] << 16);
        words[Math.imul(step, records[k]) + COLOUR] = word;
      }
    } else for (let k = 0; k < count; k++) words[Math.imul(step, records[k]) + COLOUR] = 0;
    if (intensity)
      for (let k = 0; k < count; k++) floats[Math.imul(step, records[k]) + INTENSITY] = intensity[points[k]];
    else for (let k = 0; k < count; k++) words[Math.imul(step, records[k]) + INTENSITY] = 0;
    for (let k = 0; classification && k < count; k++)
      words[Math.imul(step, records[k]) + COLOUR] |= classification[points[k]] << 24;
    for (let k = 0; has.station && k < count; k++)
      words[Math.imul(step, records[k]) + STATION] = station ? station[points[k]] : 0;
  }

  /** Gives the records of a run the attributes of those of others that it comes from. */
  copyAttributes(other: PointRecords, { count, points, records }: PointRun): void {
    const [words, from] = [this.#words, other.#words];
    const step = 2 * this.stride;
    for (let k = 0; k < count; k++)
      for (let word = COLOUR; word < step; word++)
        words[step * records[k] + word] = from[step * points[k] + word];
  }

  /** Copies records over others, one after another: the first `count` of two lists. */
  move(from: Uint32Array, to: Uint32Array, count: number): void {
    const { xyz, tags, stride } = this;
    const words = this.#words;
    for (let i = 0; i < count; i++) {
      const own = Math.imul(TAG_WORDS, to[i]);
      const other = Math.imul(TAG_WORDS, from[i]);
      tags[own] = tags[other];
      tags[own + PRIORITY] = tags[other + PRIORITY];
    }
    for (let i = 0; i < count; i++) {
      const own = Math.imul(stride, to[i]);
      const other = Math.imul(stride, from[i]);
      xyz[own] = xyz[other];
      xyz[own + 1] = xyz[other + 1];
      xyz[own + 2] = xyz[other + 2];
    }
    // Not as float64, which may change the bits of a NaN.
    const step = 2 * stride;
    for (let word = COLOUR; word < step; word++)
      for (let i = 0; i < count; i++)
        words[Math.imul(step, to[i]) + word] = words[Math.imul(step, from[i]) + word];
  }

  /** Whether record a comes before b of the same priority: the first coordinate, then attribute, that differs is smaller. */
  precedes(a: number, b: number): boolean {
    return (
      this.comparePlaces(a, b) < 0 || (this.comparePlaces(a, b) === 0 && this.#compareAttributes(a, b) < 0)
    );
  }

  /** By x, then y, then z. */
  comparePlaces(a: number, b: number): number {
    const { xyz, stride } = this;
    const [at, bt] = [a * stride, b * stride];
    return xyz[at] - xyz[bt] || xyz[at + 1] - xyz[bt + 1] || xyz[at + 2] - xyz[bt + 2];
  }

  #compareAttributes(a: number, b: number): number {
    if (this.stride === BARE) return 0;
    const words = this.#words;
    const [at, bt] = [2 * this.stride * a, 2 * this.stride * b];
    const [own, other] = [words[at + COLOUR], words[bt + COLOUR]];
    for (const shift of [0, 8, 16]) {
      const difference = ((own >>> shift) & 255) - ((other >>> shift) & 255);
      if (difference !== 0) return difference;
    }
    const station = this.has.station ? words[at + STATION] - words[bt + STATION] : 0;
    return (
      this.#floats[at + INTENSITY] - this.#floats[bt + INTENSITY] || (own >>> 24) - (other >>> 24) || station
    );
  }

  /** Copies the attributes of records to those points of `into` that `places` names. */
  getAttributes(listed: Uint32Array, into: PointAttributes, places: Uint32Array): void {
    const words = this.#words;
    const floats = this.#floats;
    const step = 2 * this.stride;
    const { colour, intensity, classification, station } = into;
    for (let i = 0; colour && i < listed.length; i++) {
      const word = words[Math.imul(step, listed[i]) + COLOUR];
      const to = Math.imul(3, places[i]);
      colour[to] = word;
      colour[to + 1] = word >>> 8;
      colour[to + 2] = word >>> 16;
    }
    for (let i = 0; intensity && i < listed.length; i++)
      intensity[places[i]] = floats[Math.imul(step, listed[i]) + INTENSITY];
    for (let i = 0; classification && i < listed.length; i++)
      classification[places[i]] = words[Math.imul(step, listed[i]) + COLOUR] >>> 24;
    for (let i = 0; station && i < listed.length; i++)
      station[places[i]] = words[Math.imul(step, listed[i]) + STATION];
  }
}
