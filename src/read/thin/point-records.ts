import type { PointAttributes } from '../../core/types.ts';
import type { PointChunk } from '../cloud-reader.ts';

/** Words (of 32 bits) of a record: x, y and z as float64, then these. */
export const PRIORITY = 6;
/** The point's cell in its block. */
export const CODE = 7;
/** Red, green and blue from the lowest byte on, classification in the highest. */
const COLOUR = 8;
const INTENSITY = 9;
const STATION = 10;
/** A word that only keeps float64 values aligned. */
const PADDING = 1;

/** Float64 entries of a record: those of a bare point, of one with colour, intensity or class, of one with a station too. */
const BARE = (CODE + 1) >> 1;
const COLOURED = (INTENSITY + 1) >> 1;
const STATIONED = (STATION + 1 + PADDING) >> 1;

/** Which attributes points have. */
export type AttributeSet = Readonly<Record<keyof PointAttributes, boolean>>;

/** Points with all that is known of them, a record each: whoever has fetched one part of a point has fetched all of it. */
export class PointRecords {
  /** Float64 entries of a record; x, y and z come first. */
  readonly stride: number;
  readonly has: AttributeSet;
  xyz: Float64Array<ArrayBuffer>;
  /** The same bytes. */
  words: Int32Array<ArrayBuffer>;
  #floats: Float32Array<ArrayBuffer>;

  constructor(has: AttributeSet, capacity: number) {
    this.has = has;
    const isColoured = has.colour || has.intensity || has.classification;
    this.stride = has.station ? STATIONED : isColoured ? COLOURED : BARE;
    this.xyz = new Float64Array(capacity * this.stride);
    this.words = new Int32Array(this.xyz.buffer);
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
    this.words = new Int32Array(grown.buffer);
    this.#floats = new Float32Array(grown.buffer);
  }

  /** Copies the attributes of `count` points of a chunk, the first `from`, to records from `to` on; those it lacks are 0. */
  setAttributes(to: number, chunk: PointChunk, from: number, count: number): void {
    const { words, has } = this;
    const step = 2 * this.stride;
    if (this.stride === BARE) return;
    const first = step * to;
    const end = first + step * count;
    const colour = has.colour && chunk.colour;
    const intensity = has.intensity && chunk.intensity;
    const classification = has.classification && chunk.classification;
    const station = has.station && chunk.station;
    for (let at = first, i = 3 * from; at < end; at += step, i += 3)
      words[at + COLOUR] = colour ? colour[i] | (colour[i + 1] << 8) | (colour[i + 2] << 16) : 0;
    for (let at = first, i = from; at < end; at += step, i++)
      this.#floats[at + INTENSITY] = intensity ? intensity[i] : 0;
    for (let at = first, i = from; classification && at < end; at += step, i++)
      words[at + COLOUR] |= classification[i] << 24;
    for (let at = first, i = from; has.station && at < end; at += step, i++)
      words[at + STATION] = station ? station[i] : 0;
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
    const { words } = this;
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
    const { words } = this;
    const floats = this.#floats;
    const step = 2 * this.stride;
    const { colour, intensity, classification, station } = into;
    for (let i = 0; i < listed.length; i++) {
      const at = step * listed[i];
      const to = places[i];
      if (colour) {
        colour[3 * to] = words[at + COLOUR];
        colour[3 * to + 1] = words[at + COLOUR] >>> 8;
        colour[3 * to + 2] = words[at + COLOUR] >>> 16;
      }
      if (intensity) intensity[to] = floats[at + INTENSITY];
      if (classification) classification[to] = words[at + COLOUR] >>> 24;
      if (station) station[to] = words[at + STATION];
    }
  }
}
