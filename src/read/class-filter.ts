import { CLASS_CODES } from '../core/classes.ts';
import type { Warning } from '../core/types.ts';
import type { PointChunk } from './cloud-reader.ts';

/** Entries a point. */
const WIDTHS = { xyz: 3, colour: 3, intensity: 1, classification: 1, station: 1 } as const;

/** Lets the points of some classes through; all, where points have none. */
export class ClassFilter {
  readonly #isKept: Uint8Array;
  readonly #seen = new Uint8Array(CLASS_CODES);
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
    let count = 0;
    for (let i = 0; classification && i < chunk.count; i++) {
      this.#seen[classification[i]] = 1;
      if (this.#isKept[classification[i]] === 1) movePoint(chunk, i, count++);
    }
    const kept = classification ? { ...chunk, count } : chunk;
    this.#kept += kept.count;
    return kept;
  }

  /** What to tell, where the filter is of no use to this cloud. */
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

function movePoint(chunk: PointChunk, from: number, to: number): void {
  if (from === to) return;
  for (const name of Object.keys(WIDTHS) as (keyof typeof WIDTHS)[]) {
    const width = WIDTHS[name];
    chunk[name]?.copyWithin(width * to, width * from, width * (from + 1));
  }
}
