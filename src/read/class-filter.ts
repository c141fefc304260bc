import { CLASS_CODES } from '../core/classes.ts';
import type { Warning } from '../core/types.ts';
import { closeRanks } from './close-ranks.ts';
import { ATTRIBUTE_WIDTHS, ATTRIBUTES, type PointChunk } from './cloud-reader.ts';

/** Lets the points of some classes through; all, where points have none. */
export class ClassFilter {
  readonly #isKept: Uint8Array;
  readonly #seen = new Uint8Array(CLASS_CODES);
  #places = new Uint32Array(0);
  #hasClasses = false;
  #kept = 0;

  /** @param isKept 1 for each class code to keep */
  constructor(isKept: Uint8Array) {
    this.#isKept = isKept;
  }

  /** Moves the points to keep to the front of the chunk's arrays; readers fill these anew. O(points). */
  apply(chunk: PointChunk): PointChunk {
    const { classification } = chunk;
    this.#hasClasses ||= classification !== undefined;
    const kept = classification ? this.#choose(chunk, classification) : chunk;
    this.#kept += kept.count;
    return kept;
  }

  #choose(chunk: PointChunk, classification: Uint8Array): PointChunk {
    if (this.#places.length < chunk.count) this.#places = new Uint32Array(chunk.count);
    const places = this.#places;
    let count = 0;
    for (let i = 0; i < chunk.count; i++) {
      const code = classification[i];
      this.#seen[code] = 1;
      if (this.#isKept[code] === 1) places[count++] = i;
    }
    if (count < chunk.count) {
      closeRanks(chunk.xyz, 3, { places, count });
      for (const name of ATTRIBUTES) {
        const values = chunk[name];
        if (values) closeRanks(values, ATTRIBUTE_WIDTHS[name], { places, count });
      }
    }
    return { ...chunk, count };
  }

  /** What to tell where the filter is of no use to the cloud that was read; null where it is. */
  get objection(): Warning | null {
    if (this.#kept > 0 && this.#hasClasses) return null;
    const found = Array.from(this.#seen.keys()).filter((code) => this.#seen[code] === 1);
    return {
      code: 'read/classes-ignored',
      message: this.#hasClasses
        ? `No point has one of the classes to keep, only ${found.join(', ')}; all points were kept.`
        : 'The points have no classes to choose by; all were kept.',
      hint: 'Set classes to all, or to codes that the file has.',
    };
  }
}
