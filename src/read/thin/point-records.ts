import type { PointAttributes } from '../../core/types.ts';
import type { PointChunk } from '../cloud-reader.ts';
import type { PointRun } from './point-run.ts';

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

  /** Gives the records of a run the attributes that its points have in a chunk; those it lacks are 0. */
  setAttributes({ count, points, records }: PointRun, chunk: PointChunk): void {
    if (this.stride === BARE) return;
    const { words, has } = this;
    const floats = this.#floats;
    const step = 2 * this.stride;
    const colour = has.colour && chunk.colour;
    const intensity = has.intensity && chunk.intensity;
    const classification = has.classification && chunk.classification;
    const station = has.station && chunk.station;
    for (let k = 0; k < count; k++) {
      const i = 3 * points[k];
      const word = colour ? colour[i] | (colour[i + 1] << 8) | (colour[i + 2] << 16) : 0;
      words[step * records[k] + COLOUR] = word;
    }
    for (let k = 0; k < count; k++)
      floats[step * records[k] + INTENSITY] = intensity ? intensity[points[k]] : 0;
    for (let k = 0; classification && k < count; k++)
      words[step * records[k] + COLOUR] |= classification[points[k]] << 24;
    for (let k = 0; has.station && k < count; k++)
      words[step * records[k] + STATION] = station ? station[points[k]] : 0;
  }

  /** Gives the records of a run the attributes of those of others that it comes from. */
  copyAttributes({ words: from }: PointRecords, { count, points, records }: PointRun): void {
    const { words } = this;
    const step = 2 * this.stride;
    for (let k = 0; k < count; k++)
      for (let word = CODE + 1; word < step; word++)
        words[step * records[k] + word] = from[step * points[k] + word];
  }

  /** Copies a record over another. */
  move(from: number, to: number): void {
    const { xyz, words, stride } = this;
    xyz[stride * to] = xyz[stride * from];
    xyz[stride * to + 1] = xyz[stride * from + 1];
    xyz[stride * to + 2] = xyz[stride * from + 2];
    for (let word = PRIORITY; word < 2 * stride; word++)
      words[2 * stride * to + word] = words[2 * stride * from + word];
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
